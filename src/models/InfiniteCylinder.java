package models;

/**
 * Where a line enters and leaves an infinite cylinder, given the components perpendicular to the axis of two vectors: the
 * one from the line's start to a point of the axis, and the line's direction.
 */
final class InfiniteCylinder {

  /** Parameter at which the line enters; −∞ if it is parallel to the axis and inside, NaN if it stays outside. */
  final double enter;

  /** Parameter at which the line leaves; +∞ or NaN likewise. */
  final double leave;

  /**
   * Intersects a line with a cylinder. The discriminant is computed from the squared distance between line and axis, which
   * does not cancel when the cylinder is far away (see {@link Sphere}).
   *
   * @param lx first component of the vector to the axis
   * @param ly second component
   * @param lz third component
   * @param dx first component of the direction, not a unit vector
   * @param dy second component
   * @param dz third component
   * @param r radius
   */
  InfiniteCylinder(final double lx, final double ly, final double lz, final double dx, final double dy, final double dz,
      final double r) {
    final double a = dx * dx + dy * dy + dz * dz, b = lx * dx + ly * dy + lz * dz;
    final double c = lx * lx + ly * ly + lz * lz - r * r;
    final double s = b / a, px = lx - s * dx, py = ly - s * dy, pz = lz - s * dz;
    final double sqrtD = Math.sqrt(a * (r * r - (px * px + py * py + pz * pz)));
    final boolean parallel = a == 0;
    enter = parallel ? (c <= 0 ? Double.NEGATIVE_INFINITY : Double.NaN) : Quadratic.smaller(a, b, c, sqrtD);
    leave = parallel ? (c <= 0 ? Double.POSITIVE_INFINITY : Double.NaN) : Quadratic.greater(a, b, c, sqrtD);
  }
}
