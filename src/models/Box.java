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
 * A rectangular box: the points C + a i + b j + c k with |a| ≤ w/2, |b| ≤ h/2, |c| ≤ d/2, where i is the
 * horizontal axis, k = i × aux normalised and j = k × i the vertical axis.
 *
 * <p><img src="doc-files/Box.png" width="320" height="240" alt="A box">
 *
 * <p>The ray is transformed to the box's frame and intersected with three slabs. If x and dx are its start and direction
 * along i, it is within the first slab between t = (−w/2 − x) / dx and t = (w/2 − x) / dx; likewise along j and k; and it
 * is in the box while it is within all three. Source: Kay and Kajiya, "Ray tracing complex scenes", SIGGRAPH 1986. A ray
 * parallel to a slab takes a separate branch, since 0 · ∞ is NaN. The face of a hit is the one closest to the computed
 * point, which is moved onto it.
 */
public class Box extends Object3D {

  private final Frame frame;
  private final double halfW;
  private final double halfH;
  private final double halfD;

  /**
   * A box.
   *
   * @param C centre
   * @param i direction of the horizontal axis, of any length but 0
   * @param aux auxiliary vector that with i spans the plane of the vertical axis, not parallel to i
   * @param w width, along i, &gt; 0
   * @param h height, along j, &gt; 0
   * @param d depth, along k, &gt; 0
   * @param color colour
   * @throws IllegalArgumentException if an argument is null or not finite, if aux is along i, or if a size is not
   *     positive
   */
  public Box(final Point3D C, final Vector3D i, final Vector3D aux, final float w, final float h, final float d,
      final Color color) {
    this(C, i, aux, w, h, d, Appearance.of(color));
  }

  /**
   * A box of a material.
   *
   * @param C centre
   * @param i direction of the horizontal axis, of any length but 0
   * @param aux auxiliary vector that with i spans the plane of the vertical axis, not parallel to i
   * @param w width, along i, &gt; 0
   * @param h height, along j, &gt; 0
   * @param d depth, along k, &gt; 0
   * @param material material
   * @throws IllegalArgumentException if an argument is null or not finite, if aux is along i, or if a size is not
   *     positive
   */
  public Box(final Point3D C, final Vector3D i, final Vector3D aux, final float w, final float h, final float d,
      final Material material) {
    this(C, i, aux, w, h, d, Appearance.of(material));
  }

  private Box(final Point3D C, final Vector3D i, final Vector3D aux, final float w, final float h, final float d,
      final Appearance appearance) {
    super(appearance);
    this.frame = new Frame(C, i, aux);
    this.halfW = positive("w", w) * 0.5;
    this.halfH = positive("h", h) * 0.5;
    this.halfD = positive("d", d) * 0.5;
  }

  @Override
  public Hit intersectionWith(final Ray ray) {
    return closestHit(ray);
  }

  @Override
  double distance(final double sx, final double sy, final double sz, final double dx, final double dy, final double dz) {
    final Frame f = frame;
    final double lx = sx - f.x, ly = sy - f.y, lz = sz - f.z;
    final double a = f.alongI(lx, ly, lz), b = f.alongJ(lx, ly, lz), c = f.alongK(lx, ly, lz);
    final double da = f.alongI(dx, dy, dz), db = f.alongJ(dx, dy, dz), dc = f.alongK(dx, dy, dz);
    if (Slab.isLeft(a, da, halfW) || Slab.isLeft(b, db, halfH) || Slab.isLeft(c, dc, halfD)) {
      return Double.POSITIVE_INFINITY;
    }
    final double enter = Math.max(Math.max(Slab.enter(a, da, halfW), Slab.enter(b, db, halfH)), Slab.enter(c, dc, halfD));
    final double leave = Math.min(Math.min(Slab.leave(a, da, halfW), Slab.leave(b, db, halfH)), Slab.leave(c, dc, halfD));
    return enter <= leave ? Quadratic.firstPositive(enter, leave) : Double.POSITIVE_INFINITY;
  }

  @Override
  Hit hitAt(final Ray ray, final double t, final int part) {
    final Frame f = frame;
    final double lx = ray.startX() - f.x, ly = ray.startY() - f.y, lz = ray.startZ() - f.z;
    final double dx = ray.directionX(), dy = ray.directionY(), dz = ray.directionZ();
    final double startA = f.alongI(lx, ly, lz), startB = f.alongJ(lx, ly, lz), startC = f.alongK(lx, ly, lz);
    final double da = f.alongI(dx, dy, dz), db = f.alongJ(dx, dy, dz), dc = f.alongK(dx, dy, dz);
    final double a = startA + t * da, b = startB + t * db, c = startC + t * dc;
    final double offW = Math.abs(Math.abs(a) - halfW), offH = Math.abs(Math.abs(b) - halfH),
        offD = Math.abs(Math.abs(c) - halfD);
    if (offW <= offH && offW <= offD) {
      return hit(t, Slab.side(a, startA, da, halfW), 0, 0, a, b, c);
    }
    return offH <= offD ? hit(t, 0, Slab.side(b, startB, db, halfH), 0, a, b, c)
        : hit(t, 0, 0, Slab.side(c, startC, dc, halfD), a, b, c);
  }

  /** A hit of the face whose normal in the box's frame is (na, nb, nc), its point moved onto the face. */
  private Hit hit(final double t, final double na, final double nb, final double nc,
      final double a, final double b, final double c) {
    final Frame f = frame;
    final double onA = na == 0 ? Slab.within(a, halfW) : na * halfW, onB = nb == 0 ? Slab.within(b, halfH) : nb * halfH,
        onC = nc == 0 ? Slab.within(c, halfD) : nc * halfD;
    return Hit.of(t, f.x + (onA * f.ix + onB * f.jx + onC * f.kx), f.y + (onA * f.iy + onB * f.jy + onC * f.ky),
        f.z + (onA * f.iz + onB * f.jz + onC * f.kz), na * f.ix + nb * f.jx + nc * f.kx,
        na * f.iy + nb * f.jy + nc * f.ky, na * f.iz + nb * f.jz + nc * f.kz,
        Rounding.bound(f.x, f.y, f.z, 2 * (halfW + halfH + halfD)), this);
  }

  @Override
  public BoundingBox getBoundingBox() {
    return frame.boxAround(halfW, halfH, halfD);
  }

  @Override
  public List<Object> constructorArguments() {
    return List.of(frame.origin(), frame.i(), frame.j(), (float) (2 * halfW), (float) (2 * halfH), (float) (2 * halfD),
        colourOrMaterial());
  }

  @Override
  public String toString() {
    return "Box(C=(" + (float) frame.x + ", " + (float) frame.y + ", " + (float) frame.z + "), w=" + (float) (2 * halfW)
        + ", h=" + (float) (2 * halfH) + ", d=" + (float) (2 * halfD) + ")";
  }
}
