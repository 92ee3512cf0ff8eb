package upnatray;

import java.awt.Color;

import models.Object3D;
import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/** A student's object: with intersectionWith, and possibly a box. */
final class StudentsSphere extends Object3D {

  private final Point3D C;
  private final float r;
  private final boolean hasBox;

  StudentsSphere(final Point3D C, final float r, final boolean hasBox, final Color color) {
    super(color);
    this.C = C;
    this.r = r;
    this.hasBox = hasBox;
  }

  @Override
  public BoundingBox getBoundingBox() {
    final double half = 1.001 * r;
    return hasBox ? BoundingBox.around(C.x, C.y, C.z, half, half, half) : super.getBoundingBox();
  }

  @Override
  public Hit intersectionWith(final Ray ray) {
    final Vector3D v = ray.getDirection();
    if (v == null) {
      return Hit.NOHIT;
    }
    assert Math.abs(v.length() - 1) < 1e-6 : ray;
    final double dx = ray.directionX(), dy = ray.directionY(), dz = ray.directionZ();
    final double lx = C.x - ray.startX(), ly = C.y - ray.startY(), lz = C.z - ray.startZ();
    final double b = lx * dx + ly * dy + lz * dz, px = lx - b * dx, py = ly - b * dy, pz = lz - b * dz;
    final double root = Math.sqrt((double) r * r - (px * px + py * py + pz * pz));
    final double t = b - root > 0 ? b - root : b + root;
    if (!((float) t > 0 && (float) t < Float.POSITIVE_INFINITY)) {
      return Hit.NOHIT;
    }
    final Point3D P = ray.pointAtParameter((float) t);
    final Vector3D n = new Vector3D(P.x - C.x, P.y - C.y, P.z - C.z);
    return n.lengthSquared() > 0 ? new Hit((float) t, P, n, this) : Hit.NOHIT;
  }
}
