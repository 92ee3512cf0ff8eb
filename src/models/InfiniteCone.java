package models;

/**
 * Where a line enters and leaves one half of an infinite circular cone, |R′ + t v′| ≤ r + t ṙ: the half in which r + t ṙ,
 * the radius at the height of the line's point, is positive.
 *
 * <p>That is a t² + 2 b t + c ≤ 0 with a = v′² − ṙ², b = R′·v′ − r ṙ and c = R′² − r². Its discriminant b² − a c is
 * |r v′ − ṙ R′|² − |R′ × v′|²: both terms vanish for a line through the tip when R is taken from there, so that the sign of
 * the difference does not depend on how close to the tip the line passes. Where a ≤ 0 the line is steeper than the cone
 * and enters each half once; only rounding can make the discriminant negative.
 */
final class InfiniteCone {

  /** Parameter at which the line enters; −∞ if it comes from the cone's infinite end, NaN if it stays outside. */
  final double enter;

  /** Parameter at which the line leaves; +∞ or NaN likewise. */
  final double leave;

  /**
   * Cuts a line with a cone.
   *
   * @param px first component of R′, the part across the axis of the vector from a point of the axis to one of the line
   * @param py second component
   * @param pz third component
   * @param dx first component of v′, the part across the axis of the line's direction
   * @param dy second component
   * @param dz third component
   * @param r radius of the cone at the height of R
   * @param growth by how much the radius grows along the line while t grows by 1
   */
  InfiniteCone(final double px, final double py, final double pz, final double dx, final double dy, final double dz,
      final double r, final double growth) {
    final double length = Math.sqrt(dx * dx + dy * dy + dz * dz), g = Math.abs(growth);
    final double a = (length - g) * (length + g);
    final double minusB = r * growth - (px * dx + py * dy + pz * dz);
    final double c = px * px + py * py + pz * pz - r * r;
    final double root = Math.sqrt(discriminant(px, py, pz, dx, dy, dz, r, growth, a > 0 ? Double.NEGATIVE_INFINITY : 0));
    if (a > 0) {
      enter = Quadratic.smaller(a, minusB, c, root);
      leave = Quadratic.greater(a, minusB, c, root);
    } else if (g == 0) {
      enter = c <= 0 ? Double.NEGATIVE_INFINITY : Double.NaN;
      leave = c <= 0 ? Double.POSITIVE_INFINITY : Double.NaN;
    } else {
      final double crossing = steep(a, minusB, c, root, growth);
      enter = growth > 0 ? crossing : Double.NEGATIVE_INFINITY;
      leave = growth > 0 ? Double.POSITIVE_INFINITY : crossing;
    }
  }

  private static double discriminant(final double px, final double py, final double pz,
      final double dx, final double dy, final double dz, final double r, final double growth, final double least) {
    final double vx = r * dx - growth * px, vy = r * dy - growth * py, vz = r * dz - growth * pz;
    final double nx = py * dz - pz * dy, ny = pz * dx - px * dz, nz = px * dy - py * dx;
    return Math.max(least, vx * vx + vy * vy + vz * vz - (nx * nx + ny * ny + nz * nz));
  }

  /** Where a line with a ≤ 0 crosses the half in which its radius grows: at the root that is farther that way. */
  private static double steep(final double a, final double minusB, final double c, final double root, final double growth) {
    if (minusB * growth > 0) {
      return c / (minusB + Math.copySign(root, minusB));
    }
    return a == 0 ? Double.NaN : (minusB - Math.copySign(root, growth)) / a;
  }
}
