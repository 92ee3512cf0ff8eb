package models;

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
 * A capsule: the points at most r away from a segment of length l centred at P, that is, a cylinder with a hemisphere at
 * each end.
 *
 * <p><img src="doc-files/Capsule.png" width="320" height="240" alt="A capsule, and its axis">
 *
 * <p>A line that enters the infinite cylinder beside the segment enters the capsule there; one that enters it beyond an
 * end of the segment can enter the capsule only through the sphere at that end; and likewise for leaving. So the
 * quadratics are those of {@link Cylinder} and {@link Sphere}. The normal points from the closest point of the segment.
 * Source: the capsule is a sphere swept along a segment, Ericson, "Real-Time Collision Detection", 2005, §5.3.
 */
public class Capsule extends Object3D {

  private final Axis axis;
  private final double r;
  private final double half;

  /**
   * A capsule.
   *
   * @param P middle of the axis segment, which runs from P − (l/2) û to P + (l/2) û
   * @param u direction of the axis, of any length but 0
   * @param r radius of the side and of both ends, &gt; 0
   * @param l length of the segment, without the hemispheres, &gt; 0
   * @param color colour
   * @throws IllegalArgumentException if an argument is null or not finite, if u is zero, or if a size is not positive
   */
  public Capsule(final Point3D P, final Vector3D u, final float r, final float l, final Color color) {
    this(P, u, r, l, Appearance.of(color));
  }

  /**
   * A capsule of a material.
   *
   * @param P middle of the axis segment, which runs from P − (l/2) û to P + (l/2) û
   * @param u direction of the axis, of any length but 0
   * @param r radius of the side and of both ends, &gt; 0
   * @param l length of the segment, without the hemispheres, &gt; 0
   * @param material material
   * @throws IllegalArgumentException if an argument is null or not finite, if u is zero, or if a size is not positive
   */
  public Capsule(final Point3D P, final Vector3D u, final float r, final float l, final Material material) {
    this(P, u, r, l, Appearance.of(material));
  }

  private Capsule(final Point3D P, final Vector3D u, final float r, final float l, final Appearance appearance) {
    super(appearance);
    this.axis = new Axis("P", P, "u", u);
    this.r = positive("r", r);
    this.half = positive("l", l) * 0.5;
  }

  @Override
  public Hit intersectionWith(final Ray ray) {
    return closestHit(ray);
  }

  @Override
  double distance(final double sx, final double sy, final double sz, final double dx, final double dy, final double dz) {
    final Axis u = axis;
    final double lx = u.x - sx, ly = u.y - sy, lz = u.z - sz;
    final double s = u.along(lx, ly, lz), d = u.along(dx, dy, dz);
    final InfiniteCylinder side = new InfiniteCylinder(lx - s * u.ux, ly - s * u.uy, lz - s * u.uz,
        dx - d * u.ux, dy - d * u.uy, dz - d * u.uz, r);
    final double above = side.enter * d - s, below = side.leave * d - s;
    final double enter = Math.abs(above) <= half ? side.enter
        : end(lx, ly, lz, dx, dy, dz, Math.copySign(half, above), true);
    final double leave = Math.abs(below) <= half ? side.leave
        : end(lx, ly, lz, dx, dy, dz, Math.copySign(half, below), false);
    return enter <= leave && side.enter <= side.leave
        ? Quadratic.firstPositive(enter, leave) : Double.POSITIVE_INFINITY;
  }

  /** Where a line enters or leaves the sphere at a place along the axis; NaN if it misses. */
  private double end(final double x, final double y, final double z, final double dx, final double dy, final double dz,
      final double at, final boolean entered) {
    final double lx = x + at * axis.ux, ly = y + at * axis.uy, lz = z + at * axis.uz;
    final double b = lx * dx + ly * dy + lz * dz, c = lx * lx + ly * ly + lz * lz - r * r;
    final double px = lx - b * dx, py = ly - b * dy, pz = lz - b * dz;
    final double root = Math.sqrt(r * r - (px * px + py * py + pz * pz));
    return entered ? Quadratic.smaller(1, b, c, root) : Quadratic.greater(1, b, c, root);
  }

  @Override
  Hit hitAt(final Ray ray, final double t, final int part) {
    final Axis u = axis;
    final double lx = ray.startX() + t * ray.directionX() - u.x, ly = ray.startY() + t * ray.directionY() - u.y,
        lz = ray.startZ() + t * ray.directionZ() - u.z;
    final double s = Math.max(-half, Math.min(half, u.along(lx, ly, lz)));
    final double nx = lx - s * u.ux, ny = ly - s * u.uy, nz = lz - s * u.uz;
    final double k = r / Math.sqrt(nx * nx + ny * ny + nz * nz);
    return Hit.of(t, u.x + s * u.ux + k * nx, u.y + s * u.uy + k * ny, u.z + s * u.uz + k * nz, nx, ny, nz,
        Rounding.bound(u.x, u.y, u.z, 2 * (half + r)), this);
  }

  @Override
  public BoundingBox getBoundingBox() {
    return axis.boxAroundBall(half, r);
  }

  @Override
  public List<Object> constructorArguments() {
    return List.of(axis.point(), axis.unit(), (float) r, (float) (2 * half), colourOrMaterial());
  }

  @Override
  public String toString() {
    return "Capsule(" + axis + ", r=" + (float) r + ", l=" + (float) (2 * half) + ")";
  }
}
