package models;

import static arguments.Arguments.positive;

import java.awt.Color;

import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/**
 * A rectangular box: the points C + a i + b j + c k with |a| ≤ w/2, |b| ≤ h/2, |c| ≤ d/2, where i is the
 * horizontal axis, k = i × aux normalised and j = k × i the vertical axis.
 *
 * <p>The ray is taken into the box's frame and cut with three slabs (Kay and Kajiya, "Ray tracing complex scenes",
 * SIGGRAPH 1986); a ray parallel to a slab has a branch of its own, since 0 · ∞ is NaN. The face of a hit is the one
 * that its point is closest to.
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
    super(color);
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
    final double enter = Math.max(Math.max(Slab.enter(a, da, halfW), Slab.enter(b, db, halfH)), Slab.enter(c, dc, halfD));
    final double leave = Math.min(Math.min(Slab.leave(a, da, halfW), Slab.leave(b, db, halfH)), Slab.leave(c, dc, halfD));
    return enter <= leave ? Quadratic.firstPositive(enter, leave) : Double.POSITIVE_INFINITY;
  }

  @Override
  Hit hitAt(final Ray ray, final double t, final int part) {
    final Frame f = frame;
    final double x = ray.startX() + t * ray.directionX(), y = ray.startY() + t * ray.directionY(),
        z = ray.startZ() + t * ray.directionZ();
    final double lx = x - f.x, ly = y - f.y, lz = z - f.z;
    final double a = f.alongI(lx, ly, lz), b = f.alongJ(lx, ly, lz), c = f.alongK(lx, ly, lz);
    final double offW = Math.abs(Math.abs(a) - halfW), offH = Math.abs(Math.abs(b) - halfH),
        offD = Math.abs(Math.abs(c) - halfD);
    if (offW <= offH && offW <= offD) {
      final double side = Math.signum(a);
      return Hit.of(t, x, y, z, side * f.ix, side * f.iy, side * f.iz, this);
    }
    if (offH <= offD) {
      final double side = Math.signum(b);
      return Hit.of(t, x, y, z, side * f.jx, side * f.jy, side * f.jz, this);
    }
    final double side = Math.signum(c);
    return Hit.of(t, x, y, z, side * f.kx, side * f.ky, side * f.kz, this);
  }

  @Override
  public BoundingBox getBoundingBox() {
    return frame.boxAround(halfW, halfH, halfD);
  }

  @Override
  public String toString() {
    return "Box(C=(" + (float) frame.x + ", " + (float) frame.y + ", " + (float) frame.z + "), w=" + (float) (2 * halfW)
        + ", h=" + (float) (2 * halfH) + ", d=" + (float) (2 * halfD) + ")";
  }
}
