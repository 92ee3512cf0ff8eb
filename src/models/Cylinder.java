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
 * A solid cylinder, closed by two flat discs: the points at most r away from the axis and, along it, at most l/2 from the
 * middle P.
 *
 * <p><img src="doc-files/Cylinder.png" width="320" height="240" alt="A cylinder, and its axis">
 *
 * <p>The ray is intersected with the infinite cylinder, |R′ + t v′|² = r², where R′ and v′ are the components of R − P and v
 * perpendicular to the axis u, and with the slab between the discs, |(R − P)·u + t v·u| = l/2; the hit is where the two
 * intervals first overlap. It lies on the side or on a disc, whichever is closer to its computed point, which is moved onto
 * that surface. Source: Cychosz and Waggenspack, "Intersecting a Ray with a Cylinder", Graphics Gems IV, 1994.
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
    this(P, u, r, l, Appearance.of(color));
  }

  /**
   * A cylinder of a material.
   *
   * @param P middle of the axis segment, which runs from P − (l/2) û to P + (l/2) û
   * @param u direction of the axis, of any length but 0
   * @param r radius, &gt; 0
   * @param l length along the axis, &gt; 0
   * @param material material
   * @throws IllegalArgumentException if an argument is null or not finite, if u is zero, or if a size is not positive
   */
  public Cylinder(final Point3D P, final Vector3D u, final float r, final float l, final Material material) {
    this(P, u, r, l, Appearance.of(material));
  }

  private Cylinder(final Point3D P, final Vector3D u, final float r, final float l, final Appearance appearance) {
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
    final double enter = Math.max(side.enter, Slab.enter(-s, d, half));
    final double leave = Math.min(side.leave, Slab.leave(-s, d, half));
    return enter <= leave ? Quadratic.firstPositive(enter, leave) : Double.POSITIVE_INFINITY;
  }

  @Override
  Hit hitAt(final Ray ray, final double t, final int part) {
    final Axis u = axis;
    final double lx = ray.startX() - u.x, ly = ray.startY() - u.y, lz = ray.startZ() - u.z;
    final double dx = ray.directionX(), dy = ray.directionY(), dz = ray.directionZ();
    final double px = lx + t * dx, py = ly + t * dy, pz = lz + t * dz, s = u.along(px, py, pz);
    final double nx = px - s * u.ux, ny = py - s * u.uy, nz = pz - s * u.uz, off = Math.sqrt(nx * nx + ny * ny + nz * nz);
    if (Math.abs(off - r) < Math.abs(Math.abs(s) - half)) {
      return at(t, Slab.within(s, half), nx, ny, nz, r / off, nx, ny, nz);
    }
    final double side = Slab.side(s, u.along(lx, ly, lz), u.along(dx, dy, dz), half);
    return at(t, side * half, nx, ny, nz, off > r ? r / off : 1, side * u.ux, side * u.uy, side * u.uz);
  }

  /** A hit whose point is moved onto the surface: at s along the axis and k (x, y, z) away from it. */
  private Hit at(final double t, final double s, final double x, final double y, final double z, final double k,
      final double nx, final double ny, final double nz) {
    return Hit.of(t, axis.x + (s * axis.ux + k * x), axis.y + (s * axis.uy + k * y), axis.z + (s * axis.uz + k * z),
        nx, ny, nz, Rounding.bound(axis.x, axis.y, axis.z, 2 * (half + r)), this);
  }

  @Override
  public BoundingBox getBoundingBox() {
    return axis.boxAroundDisc(half, r);
  }

  @Override
  public List<Object> constructorArguments() {
    return List.of(axis.point(), axis.unit(), (float) r, (float) (2 * half), colourOrMaterial());
  }

  @Override
  public String toString() {
    return "Cylinder(" + axis + ", r=" + (float) r + ", l=" + (float) (2 * half) + ")";
  }
}
