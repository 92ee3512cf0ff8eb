package models;

/**
 * Where a line enters and leaves one half of an infinite circular cone, |R′ + t v′| ≤ r + t ṙ: the half in which r + t ṙ,
 * the radius at the height of the line's point, is positive.
 *
 * <p>Let t count from the point of the line closest to the axis, at the distance m from it, where the radius is r₀. Then
 * the condition becomes a t² − 2 ṙ r₀ t + m² − r₀² ≤ 0 with a = v′² − ṙ². For a line flatter than the cone, a &gt; 0, it
 * holds somewhere in this half if r₀ |v′| ≥ m √a. Only r₀ can cancel, if the line passes near the tip or almost follows a
 * generator, and its error is no more than the rounding of the line's position: with the tip as origin its sign is right
 * however close to the tip the line passes. A line that is steeper than the cone, a ≤ 0, enters each half once.
 */
final class InfiniteCone {

  /** Parameter at which the line enters; −∞ if it comes from the cone's infinite end, NaN if it stays outside. */
  final double enter;

  /** Parameter at which the line leaves; +∞ or NaN likewise. */
  final double leave;

  /**
   * Intersects a line with a cone.
   *
   * @param px first component of R′, the part across the axis of the vector from a point of the axis to one of the line
   * @param py second component
   * @param pz third component
   * @param dx first component of v′, the part across the axis of the line's direction
   * @param dy second component
   * @param dz third component
   * @param r radius of the cone at the height of R
   * @param growth ṙ, growth of the radius along the line per unit of t
   */
  InfiniteCone(final double px, final double py, final double pz, final double dx, final double dy, final double dz,
      final double r, final double growth) {
    final double d2 = dx * dx + dy * dy + dz * dz, d = Math.sqrt(d2), g = Math.abs(growth);
    final double a = (d - g) * (d + g), pd = px * dx + py * dy + pz * dz;
    if (d <= 0.5 * g || d == 0) {
      final double c = px * px + py * py + pz * pz - r * r, root = steepRoot(px, py, pz, dx, dy, dz, r, growth);
      final double crossing = g > 0 ? steep(a, growth * r - pd, c, root, growth) : c <= 0 ? 0 : Double.NaN;
      enter = growth > 0 || Double.isNaN(crossing) ? crossing : Double.NEGATIVE_INFINITY;
      leave = growth < 0 || Double.isNaN(crossing) ? crossing : Double.POSITIVE_INFINITY;
      return;
    }
    final double start = -pd / d2, mx = px + start * dx, my = py + start * dy, mz = pz + start * dz;
    final double m = Math.sqrt(mx * mx + my * my + mz * mz), r0 = r + start * growth;
    final double b = growth * r0, c = (m - r0) * (m + r0);
    if (a > 0) {
      final double side = m * Math.sqrt(a), inside = r0 * d - side;
      final double root = inside >= 0 ? Math.sqrt(inside * (r0 * d + side)) : Double.NaN;
      enter = start + Quadratic.smaller(a, b, c, root);
      leave = start + Quadratic.greater(a, b, c, root);
    } else {
      final double crossing = start + steep(a, b, c, Math.sqrt(r0 * r0 * d2 - a * m * m), growth);
      enter = growth > 0 ? crossing : Double.NEGATIVE_INFINITY;
      leave = growth > 0 ? Double.POSITIVE_INFINITY : crossing;
    }
  }

  /** Root of the discriminant |r v′ − ṙ R′|² − |R′ × v′|², the second term less than the first for a line this steep. */
  private static double steepRoot(final double px, final double py, final double pz,
      final double dx, final double dy, final double dz, final double r, final double growth) {
    final double vx = r * dx - growth * px, vy = r * dy - growth * py, vz = r * dz - growth * pz;
    final double nx = py * dz - pz * dy, ny = pz * dx - px * dz, nz = px * dy - py * dx;
    return Math.sqrt(Math.max(0, vx * vx + vy * vy + vz * vz - (nx * nx + ny * ny + nz * nz)));
  }

  /** Where a line with a ≤ 0 crosses the half in which its radius grows: the root of a t² − 2 b t + c farther that way. */
  private static double steep(final double a, final double b, final double c, final double root, final double growth) {
    if (b * growth > 0) {
      return c / (b + Math.copySign(root, b));
    }
    return a == 0 ? Double.NaN : (b - Math.copySign(root, growth)) / a;
  }
}
