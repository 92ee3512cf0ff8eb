package models;

import static arguments.Arguments.positive;

import java.awt.Color;

import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/**
 * A solid cylinder, closed by two flat discs: the points no farther than r from the axis and no farther than l/2 along
 * it from the middle P.
 *
 * <p>The ray is cut with the cylinder without end and with the slab between the discs; the hit is where the two
 * intervals first overlap. Whether it lies on the side or on a disc is told by which of them its point is closest to.
 * Source: Cychosz and Waggenspack, "Intersecting a Ray with a Cylinder", Graphics Gems IV, 1994.
 */
public class Cylinder extends Object3D {

  private final Axis axis;
  private final double r;
  private final double half;

  /**
   * A cylinder.
   *
   * @param P middle of the axis segment, which runs from P − (l/2) û to P + (l/2) û
   * @param u direction of the axis, of any length but 0
   * @param r radius, &gt; 0
   * @param l length along the axis, &gt; 0
   * @param color colour
   * @throws IllegalArgumentException if an argument is null or not finite, if u is zero, or if a size is not positive
   */
  public Cylinder(final Point3D P, final Vector3D u, final float r, final float l, final Color color) {
    super(color);
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
    final RoundSide side = new RoundSide(lx - s * u.ux, ly - s * u.uy, lz - s * u.uz,
        dx - d * u.ux, dy - d * u.uy, dz - d * u.uz, r);
    final double enter = Math.max(side.enter, Slab.enter(-s, d, half));
    final double leave = Math.min(side.leave, Slab.leave(-s, d, half));
    return enter <= leave ? Quadratic.firstPositive(enter, leave) : Double.POSITIVE_INFINITY;
  }

  @Override
  Hit hitAt(final Ray ray, final double t, final int part) {
    final Axis u = axis;
    final double x = ray.startX() + t * ray.directionX(), y = ray.startY() + t * ray.directionY(),
        z = ray.startZ() + t * ray.directionZ();
    final double s = u.along(x - u.x, y - u.y, z - u.z);
    final double nx = x - u.x - s * u.ux, ny = y - u.y - s * u.uy, nz = z - u.z - s * u.uz;
    final double offSide = Math.abs(Math.sqrt(nx * nx + ny * ny + nz * nz) - r);
    if (offSide < Math.abs(Math.abs(s) - half)) {
      return Hit.of(t, x, y, z, nx, ny, nz, this);
    }
    final double side = Math.signum(s);
    return Hit.of(t, x, y, z, side * u.ux, side * u.uy, side * u.uz, this);
  }

  @Override
  public BoundingBox getBoundingBox() {
    return axis.boxAroundDisc(half, r);
  }

  @Override
  public String toString() {
    return "Cylinder(" + axis + ", r=" + (float) r + ", l=" + (float) (2 * half) + ")";
  }
}
