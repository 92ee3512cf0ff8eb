package lights;

import static arguments.Arguments.finite;
import static arguments.Arguments.wrong;

import primitives.Point3D;

/** The axis of a light: the line from its position S through the point that it is aimed at, in double. */
final class Axis {

  /**
   * How far beyond its edge a field extends, relative to the distance from the light, so that the edge is lit in spite of
   * a dozen rounding errors of 2⁻⁵³ each.
   */
  static final double EDGE = 0x1p-48;

  private final double x;
  private final double y;
  private final double z;
  private final double dx;
  private final double dy;
  private final double dz;

  Axis(final Point3D position, final Point3D lookAt) {
    if (finite("lookAt", lookAt).equals(position)) {
      throw wrong("samePoint", "lookAt", lookAt, "position");
    }
    x = position.x;
    y = position.y;
    z = position.z;
    final double vx = lookAt.x - x, vy = lookAt.y - y, vz = lookAt.z - z;
    final double length = Math.sqrt(vx * vx + vy * vy + vz * vz);
    dx = vx / length;
    dy = vy / length;
    dz = vz / length;
  }

  double directionX() {
    return dx;
  }

  double directionY() {
    return dy;
  }

  double directionZ() {
    return dz;
  }

  /** How far before the position a point is: a = (P − S)·û. */
  double ahead(final double px, final double py, final double pz) {
    return (px - x) * dx + (py - y) * dy + (pz - z) * dz;
  }

  /** How far a point is from the axis: |(P − S) × û|. */
  double beside(final double px, final double py, final double pz) {
    final double vx = px - x, vy = py - y, vz = pz - z;
    final double cx = vy * dz - vz * dy, cy = vz * dx - vx * dz, cz = vx * dy - vy * dx;
    return Math.sqrt(cx * cx + cy * cy + cz * cz);
  }
}
