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
 * A torus: the points at most r away from the ring, a circle of radius R about C in the plane perpendicular to the axis.
 * With r ≥ R it is a solid without a hole, and only its outer surface counts.
 *
 * <p><img src="doc-files/Torus.png" width="320" height="240" alt="A torus, and its axis">
 *
 * <p>For a point at height h above the ring's plane and at distance ρ from the axis, the squared distance to the ring is
 * D² = (ρ − R)² + h², and {@link #SDF} is D − r: the exact distance, except inside a torus with r &gt; R, where it is a
 * bound.
 *
 * <p>The march is sphere tracing whose steps take the direction of the ray into account: they end not on a sphere that is
 * known to be empty but on a quadric that separates the ray from the torus and touches it ({@code TorusTrace} derives it).
 * Source of the scheme: Hart, "Sphere tracing: a geometric method for the antialiased ray tracing of implicit surfaces", The
 * Visual Computer 12, 1996.
 */
public class Torus extends ProceduralObject3D {

  /** A ray whose direction has a smaller component along the axis counts as perpendicular to it. */
  private static final double LEVEL = 0x1p-100;

  /** Rounding errors of {@link #SDF}, relative to the distance from the centre plus R + r. */
  private static final double SDF_NOISE = 0x1p-49;

  private final Axis axis;
  private final double R;
  private final double r;
  private final double outer;
  private final double outer2;
  private final double inner2;
  private final TorusTrace march;

  /**
   * A torus.
   *
   * @param C centre
   * @param axis direction of the axis of revolution, of any length but 0
   * @param R distance from the axis to the centre of the circle that is revolved, &gt; 0
   * @param r radius of that circle, &gt; 0; may be R or more
   * @param color colour
   * @throws IllegalArgumentException if an argument is null or not finite, if the axis is zero, or if a radius is not
   *     positive
   */
  public Torus(final Point3D C, final Vector3D axis, final float R, final float r, final Color color) {
    this(C, axis, R, r, Appearance.of(color));
  }

  /**
   * A torus of a material.
   *
   * @param C centre
   * @param axis direction of the axis of revolution, of any length but 0
   * @param R distance from the axis to the centre of the circle that is revolved, &gt; 0
   * @param r radius of that circle, &gt; 0; may be R or more
   * @param material material
   * @throws IllegalArgumentException if an argument is null or not finite, if the axis is zero, or if a radius is not
   *     positive
   */
  public Torus(final Point3D C, final Vector3D axis, final float R, final float r, final Material material) {
    this(C, axis, R, r, Appearance.of(material));
  }

  private Torus(final Point3D C, final Vector3D axis, final float R, final float r, final Appearance appearance) {
    super(appearance);
    this.axis = new Axis("C", C, "axis", axis);
    this.R = positive("R", R);
    this.r = positive("r", r);
    this.outer = this.R + this.r;
    this.outer2 = outer * outer;
    this.inner2 = this.r < this.R ? (this.R - this.r) * (this.R - this.r) : Double.NEGATIVE_INFINITY;
    this.march = new TorusTrace(this.R, this.r);
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
   * Clips the ray to the sphere of radius R + r about the centre. From here on t counts from the point p of the ray that
   * is closest to the centre, so that nothing cancels when the ray comes from far away.
   */
  @Override
  double march(final double x, final double y, final double z, final double dx, final double dy, final double dz) {
    final double lx = x - axis.x, ly = y - axis.y, lz = z - axis.z;
    final double about = lx * dx + ly * dy + lz * dz;
    final double ax = lx - about * dx, ay = ly - about * dy, az = lz - about * dz;
    final double rest = ax * dx + ay * dy + az * dz, start = about + rest;
    final double px = ax - rest * dx, py = ay - rest * dy, pz = az - rest * dz;
    final double p2 = px * px + py * py + pz * pz, room = outer2 - p2;
    if (!(room > 0)) {
      return Double.POSITIVE_INFINITY;
    }
    final double half = Math.sqrt(room), h = axis.along(px, py, pz), slope = axis.along(dx, dy, dz);
    double enter = -half, leave = half;
    if (Math.abs(slope) > LEVEL) {
      final double middle = -h / slope, reach = r / Math.abs(slope);
      enter = Math.max(enter, middle - reach);
      leave = Math.min(leave, middle + reach);
    }
    if (!(leave >= enter && leave > start) || inHole(enter, p2, h, slope) && inHole(leave, p2, h, slope)) {
      return Double.POSITIVE_INFINITY;
    }
    final double t = across(start, enter, leave, px - h * axis.ux, py - h * axis.uy, pz - h * axis.uz,
        dx - slope * axis.ux, dy - slope * axis.uy, dz - slope * axis.uz, h, slope);
    return t > start ? t - start : Double.POSITIVE_INFINITY;
  }

  private boolean inHole(final double t, final double p2, final double h, final double slope) {
    final double height = h + t * slope;
    return p2 + t * t - height * height < inner2;
  }

  /**
   * Reduces the ray, whose components perpendicular to the axis are given, to numbers that do not depend on the frame:
   * its height h above the ring's plane and its slope; and, seen along the axis, its speed and its position along and
   * beside its path, so that ρ² = (place + t speed)² + aside², where neither term cancels.
   */
  private double across(final double start, final double enter, final double leave, final double qx, final double qy,
      final double qz, final double ex, final double ey, final double ez, final double h, final double slope) {
    final double speed = Math.sqrt(ex * ex + ey * ey + ez * ez), scale = speed > 0 ? 1 / speed : 0;
    final double ux = scale * ex, uy = scale * ey, uz = scale * ez, place = qx * ux + qy * uy + qz * uz;
    final double sx = qx - place * ux, sy = qy - place * uy, sz = qz - place * uz;
    final double aside2 = sx * sx + sy * sy + sz * sz;
    return enter > start ? march.fromOutside(enter, leave, place, speed, aside2, h, slope)
        : march.fromStart(start, leave, place, speed, aside2, h, slope);
  }

  @Override
  Hit hitAt(final Ray ray, final double t, final int part) {
    final double px = ray.startX() + t * ray.directionX() - axis.x, py = ray.startY() + t * ray.directionY() - axis.y,
        pz = ray.startZ() + t * ray.directionZ() - axis.z;
    final double h = axis.along(px, py, pz);
    final double qx = px - h * axis.ux, qy = py - h * axis.uy, qz = pz - h * axis.uz;
    final double rho = Math.sqrt(qx * qx + qy * qy + qz * qz), k = rho > 0 ? R / rho : 0;
    final double nx = px - k * qx, ny = py - k * qy, nz = pz - k * qz, s = r / Math.sqrt(nx * nx + ny * ny + nz * nz);
    return Hit.of(t, axis.x + k * qx + s * nx, axis.y + k * qy + s * ny, axis.z + k * qz + s * nz, nx, ny, nz,
        errorBound(rho), this);
  }

  /** Near the axis, where a torus with r &gt; R has its tips, the direction away from it is less accurate. */
  private double errorBound(final double rho) {
    return Rounding.bound(axis.x, axis.y, axis.z, 2 * outer) * (1 + R / rho);
  }

  @Override
  protected float SDF(final Point3D P) {
    final double distance = signedDistance(notNull("P", P).x, P.y, P.z);
    final double sure = Math.abs(distance) - SDF_NOISE * (distance + outer + outer);
    return Math.copySign(roundedDown(Math.max(0, sure)), (float) distance);
  }

  @Override
  double signedDistance(final double x, final double y, final double z) {
    final double px = x - axis.x, py = y - axis.y, pz = z - axis.z, h = axis.along(px, py, pz);
    final double a = fromAxis(px, py, pz, h) - R;
    return Math.sqrt(a * a + h * h) - r;
  }

  @Override
  protected float distanceUpperBound(final Point3D P) {
    final double px = notNull("P", P).x - axis.x, py = P.y - axis.y, pz = P.z - axis.z, h = axis.along(px, py, pz);
    final double a = fromAxis(px, py, pz, h) + R;
    return roundedUp((Math.sqrt(a * a + h * h) + r) * (1 + SDF_NOISE));
  }

  /** Distance from the axis of a point given relative to the centre, at height h. */
  private double fromAxis(final double px, final double py, final double pz, final double h) {
    final double qx = px - h * axis.ux, qy = py - h * axis.uy, qz = pz - h * axis.uz;
    return Math.sqrt(qx * qx + qy * qy + qz * qz);
  }

  @Override
  public BoundingBox getBoundingBox() {
    return BoundingBox.around(axis.x, axis.y, axis.z, R * Math.hypot(axis.uy, axis.uz) + r,
        R * Math.hypot(axis.uz, axis.ux) + r, R * Math.hypot(axis.ux, axis.uy) + r);
  }

  @Override
  public List<Object> constructorArguments() {
    return List.of(axis.point(), axis.unit(), (float) R, (float) r, colourOrMaterial());
  }

  @Override
  public String toString() {
    return "Torus(C=(" + (float) axis.x + ", " + (float) axis.y + ", " + (float) axis.z + "), axis=("
        + (float) axis.ux + ", " + (float) axis.uy + ", " + (float) axis.uz + "), R=" + (float) R + ", r=" + (float) r + ")";
  }
}
