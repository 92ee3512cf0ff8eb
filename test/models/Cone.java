package models;

import java.awt.Color;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/**
 * A shape as a student may write one: it extends {@link Object3D} and implements {@code intersectionWith} only. A cone
 * with its base, from the middle C of the base to the tip C + h û.
 */
class Cone extends Object3D {

  private final Point3D C;
  private final Vector3D u;
  private final float r;
  private final float h;

  Cone(final Point3D C, final Vector3D u, final float r, final float h, final Color color) {
    super(color);
    this.C = new Point3D(C);
    this.u = new Vector3D(u);
    this.u.normalize();
    this.r = r;
    this.h = h;
  }

  @Override
  public Hit intersectionWith(final Ray ray) {
    if (ray == null) {
      throw new IllegalArgumentException("ray must not be null");
    }
    if (ray == Ray.NORAY) {
      return Hit.NOHIT;
    }
    final Point3D R = ray.getStartingPoint();
    final Vector3D d = ray.getDirection();
    final double qx = (double) R.x - C.x - (double) h * u.x, qy = (double) R.y - C.y - (double) h * u.y,
        qz = (double) R.z - C.z - (double) h * u.z;
    final double k = 1 + (double) r * r / ((double) h * h), qu = qx * u.x + qy * u.y + qz * u.z;
    final double du = (double) d.x * u.x + (double) d.y * u.y + (double) d.z * u.z;
    final double a = (double) d.x * d.x + (double) d.y * d.y + (double) d.z * d.z - k * du * du;
    final double b = qx * d.x + qy * d.y + qz * d.z - k * qu * du, c = qx * qx + qy * qy + qz * qz - k * qu * qu;
    final double root = Math.sqrt(b * b - a * c), base = (-h - qu) / du;
    double t = Double.POSITIVE_INFINITY;
    boolean onBase = false;
    for (final double side : new double[] {(-b - root) / a, (-b + root) / a}) {
      final double s = qu + side * du;
      t = side > 0 && side < t && s <= 0 && s >= -h ? side : t;
    }
    final double x = qx + base * d.x + (double) h * u.x, y = qy + base * d.y + (double) h * u.y,
        z = qz + base * d.z + (double) h * u.z;
    if (base > 0 && base < t && x * x + y * y + z * z <= (double) r * r) {
      t = base;
      onBase = true;
    }
    if (!(t < Float.POSITIVE_INFINITY)) {
      return Hit.NOHIT;
    }
    final double s = k * (qu + t * du);
    final Vector3D n = onBase ? new Vector3D(-u.x, -u.y, -u.z) : new Vector3D((float) (qx + t * d.x - s * u.x),
        (float) (qy + t * d.y - s * u.y), (float) (qz + t * d.z - s * u.z));
    return new Hit((float) t, ray.pointAtParameter((float) t), n, this);
  }
}
