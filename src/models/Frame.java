package models;

import static arguments.Arguments.finite;
import static arguments.Arguments.notParallel;

import primitives.Point3D;
import primitives.Vector3D;
import primitives.BoundingBox;

/**
 * The frame of an object: an origin C and three orthonormal axes i, j, k, right-handed, in double. It transforms points
 * and directions of the scene to coordinates of the object.
 */
final class Frame {

  final double x;
  final double y;
  final double z;
  final double ix;
  final double iy;
  final double iz;
  final double jx;
  final double jy;
  final double jz;
  final double kx;
  final double ky;
  final double kz;

  /**
   * The frame of a horizontal axis and an auxiliary vector: k = i × aux normalised, j = k × i.
   *
   * @throws IllegalArgumentException if an argument is null or not finite, or if aux is along i
   */
  Frame(final Point3D C, final Vector3D i, final Vector3D aux) {
    x = finite("C", C).x;
    y = C.y;
    z = C.z;
    notParallel("aux", aux, "i", i);
    final double length = Math.sqrt((double) i.x * i.x + (double) i.y * i.y + (double) i.z * i.z);
    ix = i.x / length;
    iy = i.y / length;
    iz = i.z / length;
    final double cx = iy * aux.z - iz * aux.y, cy = iz * aux.x - ix * aux.z, cz = ix * aux.y - iy * aux.x;
    final double across = Math.sqrt(cx * cx + cy * cy + cz * cz);
    kx = cx / across;
    ky = cy / across;
    kz = cz / across;
    jx = ky * iz - kz * iy;
    jy = kz * ix - kx * iz;
    jz = kx * iy - ky * ix;
  }

  Point3D origin() {
    return new Point3D((float) x, (float) y, (float) z);
  }

  Vector3D i() {
    return new Vector3D((float) ix, (float) iy, (float) iz);
  }

  Vector3D j() {
    return new Vector3D((float) jx, (float) jy, (float) jz);
  }

  /** First coordinate of a direction, or of a point relative to the origin. */
  double alongI(final double vx, final double vy, final double vz) {
    return vx * ix + vy * iy + vz * iz;
  }

  /** Second coordinate. */
  double alongJ(final double vx, final double vy, final double vz) {
    return vx * jx + vy * jy + vz * jz;
  }

  /** Third coordinate. */
  double alongK(final double vx, final double vy, final double vz) {
    return vx * kx + vy * ky + vz * kz;
  }

  /** Box about the points a i + b j + c k from the origin with |a| ≤ a₀, |b| ≤ b₀, |c| ≤ c₀. */
  BoundingBox boxAround(final double a, final double b, final double c) {
    return BoundingBox.around(x, y, z, Math.abs(a * ix) + Math.abs(b * jx) + Math.abs(c * kx),
        Math.abs(a * iy) + Math.abs(b * jy) + Math.abs(c * ky), Math.abs(a * iz) + Math.abs(b * jz) + Math.abs(c * kz));
  }
}
