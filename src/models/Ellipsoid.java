package models;

import static arguments.Arguments.notNull;
import static arguments.Arguments.positive;

import java.awt.Color;
import java.util.List;

import materials.Material;
import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/**
 * An ellipsoid: the points C + a i + b j + c k with (a/Rx)² + (b/Ry)² + (c/Rz)² ≤ 1, where i is the horizontal axis,
 * k = i × aux normalised and j = k × i the vertical axis.
 *
 * <p><img src="doc-files/Ellipsoid.png" width="320" height="240" alt="An ellipsoid">
 *
 * <p>For the point q = (a/Rx, b/Ry, c/Rz) let κ = |q|, which is less than 1 inside and more than 1 outside. {@link #SDF}
 * is a lower bound of the distance, and its ratio to the distance tends to 1 towards the surface:
 * <ul>
 * <li>outside, the distance to the tangent plane at q/κ, beyond which the whole ellipsoid lies;</li>
 * <li>inside, the least s at which κ can reach 1: after a step of length s, κ² has grown by at most 2 g s + s²/m², where g
 *     is half the gradient of κ² and m the least radius.</li>
 * </ul>
 *
 * <p>The march is sphere tracing with steps that take the direction into account. Hart's step ends on a sphere that is
 * known to be empty; the step here ends on a plane that has the ellipsoid behind it: q·x = (1 + κ²)/2, parallel to the
 * tangent plane and just outside it, since (1 + κ²)/2 ≥ κ. It needs no square root and never passes the surface; the
 * steps shrink quadratically, or by halves along a tangent. For a ray that starts inside, the march goes backwards from
 * beyond the ellipsoid: as that is convex, the first crossing found is the only one ahead of the start.
 *
 * <p>Source of the scheme: Hart, "Sphere tracing", The Visual Computer 12, 1996; the planes are supporting planes of a
 * convex set, Rockafellar, "Convex Analysis", 1970, §11.
 */
public class Ellipsoid extends ProceduralObject3D {

  /** Length of the step after which the march ends, relative to the remaining distance: the next would be its square. */
  private static final double CLOSE = 0x1p-20;

  /** Rounding errors of {@link #SDF} and of the upper bound, relative to the distance from the centre plus the size. */
  private static final double SDF_NOISE = 0x1p-48;

  private final Frame frame;
  private final double Rx;
  private final double Ry;
  private final double Rz;
  private final double least;
  private final double greatest;
  private final double ax;
  private final double ay;
  private final double az;
  private final double bx;
  private final double by;
  private final double bz;
  private final double cx;
  private final double cy;
  private final double cz;

  /**
   * An ellipsoid.
   *
   * @param C centre
   * @param i direction of the horizontal axis, of any length but 0
   * @param aux auxiliary vector that with i spans the plane of the vertical axis, not parallel to i
   * @param Rx radius along i, &gt; 0
   * @param Ry radius along j, &gt; 0
   * @param Rz radius along k, &gt; 0
   * @param color colour
   * @throws IllegalArgumentException if an argument is null or not finite, if aux is along i, or if a radius is not
   *     positive
   */
  public Ellipsoid(final Point3D C, final Vector3D i, final Vector3D aux, final float Rx, final float Ry, final float Rz,
      final Color color) {
    this(C, i, aux, Rx, Ry, Rz, Appearance.of(color));
  }

  /**
   * An ellipsoid of a material.
   *
   * @param C centre
   * @param i direction of the horizontal axis, of any length but 0
   * @param aux auxiliary vector that with i spans the plane of the vertical axis, not parallel to i
   * @param Rx radius along i, &gt; 0
   * @param Ry radius along j, &gt; 0
   * @param Rz radius along k, &gt; 0
   * @param material material
   * @throws IllegalArgumentException if an argument is null or not finite, if aux is along i, or if a radius is not
   *     positive
   */
  public Ellipsoid(final Point3D C, final Vector3D i, final Vector3D aux, final float Rx, final float Ry, final float Rz,
      final Material material) {
    this(C, i, aux, Rx, Ry, Rz, Appearance.of(material));
  }

  private Ellipsoid(final Point3D C, final Vector3D i, final Vector3D aux, final float Rx, final float Ry, final float Rz,
      final Appearance appearance) {
    super(appearance);
    this.frame = new Frame(C, i, aux);
    this.Rx = positive("Rx", Rx);
    this.Ry = positive("Ry", Ry);
    this.Rz = positive("Rz", Rz);
    this.least = Math.min(Rx, Math.min(Ry, Rz));
    this.greatest = Math.max(Rx, Math.max(Ry, Rz));
    this.ax = frame.ix / Rx;
    this.ay = frame.iy / Rx;
    this.az = frame.iz / Rx;
    this.bx = frame.jx / Ry;
    this.by = frame.jy / Ry;
    this.bz = frame.jz / Ry;
    this.cx = frame.kx / Rz;
    this.cy = frame.ky / Rz;
    this.cz = frame.kz / Rz;
  }

  @Override
  public Hit intersectionWith(final Ray ray) {
    return rayMarching(ray);
  }

  @Override
  double distance(final double x, final double y, final double z, final double dx, final double dy, final double dz) {
    return march(x, y, z, dx, dy, dz);
  }

  /**
   * The march, in coordinates in which the ellipsoid is the unit ball. It begins at the point of the ray that is
   * closest to the centre, so that nothing cancels when the ray comes from far away.
   */
  @Override
  double march(final double x, final double y, final double z, final double dx, final double dy, final double dz) {
    final double lx = x - frame.x, ly = y - frame.y, lz = z - frame.z;
    final double start = lx * dx + ly * dy + lz * dz;
    final double px = lx - start * dx, py = ly - start * dy, pz = lz - start * dz;
    if (!(px * px + py * py + pz * pz < greatest * greatest)) {
      return Double.POSITIVE_INFINITY;
    }
    final double qa = ax * px + ay * py + az * pz, qb = bx * px + by * py + bz * pz, qc = cx * px + cy * py + cz * pz;
    final double va = ax * dx + ay * dy + az * dz, vb = bx * dx + by * dy + bz * dz, vc = cx * dx + cy * dy + cz * dz;
    final double v2 = va * va + vb * vb + vc * vc, middle = -(qa * va + qb * vb + qc * vc) / v2;
    final double ma = qa + middle * va, mb = qb + middle * vb, mc = qc + middle * vc;
    final double room = 1 - (ma * ma + mb * mb + mc * mc);
    if (!(room > 0) || Double.isNaN(v2)) {
      return Double.POSITIVE_INFINITY;
    }
    final double half = march(room) / Math.sqrt(v2);
    final double enter = middle - half - start, leave = middle + half - start;
    return enter > 0 ? enter : leave > 0 ? leave : Double.POSITIVE_INFINITY;
  }

  /**
   * Marches towards the unit ball along a line that passes the centre at the squared distance 1 − room, from the plane
   * that touches the ball across the line; the same from both sides. Along a tangent the distance halves from step to step,
   * at most 27 times, as room is a difference of doubles from 1.
   *
   * @param room 2⁻⁵³ … 1
   * @return distance of the crossing from the line's closest point to the centre
   */
  private static double march(final double room) {
    double ahead = 1, step = 0.5 - 0.5 * room;
    while (step > CLOSE * ahead) {
      ahead -= step;
      step = 0.5 * (ahead - room / ahead);
    }
    return ahead - step;
  }

  @Override
  Hit hitAt(final Ray ray, final double t, final int part) {
    final double px = ray.startX() + t * ray.directionX() - frame.x, py = ray.startY() + t * ray.directionY() - frame.y,
        pz = ray.startZ() + t * ray.directionZ() - frame.z;
    final double qa = ax * px + ay * py + az * pz, qb = bx * px + by * py + bz * pz, qc = cx * px + cy * py + cz * pz;
    final double s = 1 / Math.sqrt(qa * qa + qb * qb + qc * qc);
    return Hit.of(t, frame.x + s * px, frame.y + s * py, frame.z + s * pz,
        qa * ax + qb * bx + qc * cx, qa * ay + qb * by + qc * cy, qa * az + qb * bz + qc * cz,
        Rounding.bound(frame.x, frame.y, frame.z, 2 * greatest) + CLOSE * CLOSE * greatest, this);
  }

  @Override
  protected float SDF(final Point3D P) {
    final double distance = signedDistance(notNull("P", P).x, P.y, P.z);
    final double noise = SDF_NOISE * (length(P.x - frame.x, P.y - frame.y, P.z - frame.z) + greatest);
    return Math.copySign(roundedDown(Math.max(0, Math.abs(distance) - noise)), (float) distance);
  }

  @Override
  double signedDistance(final double x, final double y, final double z) {
    final double px = x - frame.x, py = y - frame.y, pz = z - frame.z;
    final double qa = ax * px + ay * py + az * pz, qb = bx * px + by * py + bz * pz, qc = cx * px + cy * py + cz * pz;
    final double k2 = qa * qa + qb * qb + qc * qc, ga = qa / Rx, gb = qb / Ry, gc = qc / Rz;
    final double g = Math.sqrt(ga * ga + gb * gb + gc * gc), k = Math.sqrt(k2);
    return k2 >= 1 ? k * (k - 1) / g : -(1 - k2) / (g + Math.sqrt(g * g + (1 - k2) / (least * least)));
  }

  @Override
  protected float distanceUpperBound(final Point3D P) {
    final double px = notNull("P", P).x - frame.x, py = P.y - frame.y, pz = P.z - frame.z;
    final double a = Math.abs(frame.alongI(px, py, pz)) + Rx, b = Math.abs(frame.alongJ(px, py, pz)) + Ry,
        c = Math.abs(frame.alongK(px, py, pz)) + Rz;
    final double corner = length(a, b, c), sphere = length(px, py, pz) + greatest;
    return roundedUp(Math.min(corner, sphere) * (1 + SDF_NOISE));
  }

  @Override
  public BoundingBox getBoundingBox() {
    final Frame f = frame;
    return BoundingBox.around(f.x, f.y, f.z, length(Rx * f.ix, Ry * f.jx, Rz * f.kx),
        length(Rx * f.iy, Ry * f.jy, Rz * f.ky), length(Rx * f.iz, Ry * f.jz, Rz * f.kz));
  }

  private static double length(final double a, final double b, final double c) {
    return Math.sqrt(a * a + b * b + c * c);
  }

  @Override
  public List<Object> constructorArguments() {
    return List.of(frame.origin(), frame.i(), frame.j(), (float) Rx, (float) Ry, (float) Rz, colourOrMaterial());
  }

  @Override
  public String toString() {
    return "Ellipsoid(C=(" + (float) frame.x + ", " + (float) frame.y + ", " + (float) frame.z + "), Rx=" + (float) Rx
        + ", Ry=" + (float) Ry + ", Rz=" + (float) Rz + ")";
  }
}
