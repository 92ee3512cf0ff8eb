package models;

import static arguments.Arguments.direction;
import static arguments.Arguments.finite;

import javax.vecmath.Tuple3f;

import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;

/** The axis of a round shape: one of its points and a unit direction, in double. */
final class Axis {

  final double x;
  final double y;
  final double z;
  final double ux;
  final double uy;
  final double uz;

  /**
   * An axis.
   *
   * @param pointName the point's name in the shape's constructor, for messages
   * @param point a point of the axis
   * @param directionName the direction's name there
   * @param direction the direction, of any length but 0
   * @throws IllegalArgumentException if an argument is null or not finite, or if the direction is zero
   */
  Axis(final String pointName, final Point3D point, final String directionName, final Vector3D direction) {
    x = finite(pointName, point).x;
    y = point.y;
    z = point.z;
    final double length = length(direction(directionName, direction));
    ux = direction.x / length;
    uy = direction.y / length;
    uz = direction.z / length;
  }

  /** Length of a vector, without overflow or underflow of the squares in float. */
  static double length(final Tuple3f v) {
    return Math.sqrt((double) v.x * v.x + (double) v.y * v.y + (double) v.z * v.z);
  }

  Point3D point() {
    return new Point3D((float) x, (float) y, (float) z);
  }

  Vector3D unit() {
    return new Vector3D((float) ux, (float) uy, (float) uz);
  }

  /** Component along the axis of a vector. */
  double along(final double vx, final double vy, final double vz) {
    return vx * ux + vy * uy + vz * uz;
  }

  /**
   * Box about a disc, or about the solid that it sweeps along the axis.
   *
   * @param half half the length swept, to either side of the point
   * @param r radius of the disc, whose plane is perpendicular to the axis
   */
  BoundingBox boxAroundDisc(final double half, final double r) {
    return BoundingBox.around(x, y, z, half * Math.abs(ux) + r * acrossX(), half * Math.abs(uy) + r * acrossY(),
        half * Math.abs(uz) + r * acrossZ());
  }

  /**
   * Box about a disc perpendicular to the axis.
   *
   * @param s place of its centre along the axis, from the point
   * @param r its radius
   */
  BoundingBox boxOfDisc(final double s, final double r) {
    return BoundingBox.around(x + s * ux, y + s * uy, z + s * uz, r * acrossX(), r * acrossY(), r * acrossZ());
  }

  /** Box about a ball, or about the solid that it sweeps along the axis. See {@link #boxAroundDisc}. */
  BoundingBox boxAroundBall(final double half, final double r) {
    return BoundingBox.around(x, y, z, half * Math.abs(ux) + r, half * Math.abs(uy) + r, half * Math.abs(uz) + r);
  }

  /** Greatest first coordinate of a unit vector perpendicular to the axis: √(1 − ux²) without its cancellation. */
  double acrossX() {
    return Math.sqrt(uy * uy + uz * uz);
  }

  /** Greatest second coordinate of such a vector. */
  double acrossY() {
    return Math.sqrt(ux * ux + uz * uz);
  }

  /** Greatest third coordinate of such a vector. */
  double acrossZ() {
    return Math.sqrt(ux * ux + uy * uy);
  }

  @Override
  public String toString() {
    return toString("P", "u");
  }

  /** Point and direction, by the names that they have in the shape's constructor. */
  String toString(final String pointName, final String directionName) {
    return pointName + "=(" + (float) x + ", " + (float) y + ", " + (float) z + "), " + directionName + "=("
        + (float) ux + ", " + (float) uy + ", " + (float) uz + ")";
  }
}
