package models;

/** The points whose coordinate along some axis is at most h from 0, and where a line enters and leaves them. */
final class Slab {

  private Slab() {
  }

  /** Whether a ray starts outside of the slab and does not go towards it: so rays leave a box, which need not divide. */
  static boolean isLeft(final double s, final double d, final double h) {
    return Math.abs(s) > h && s * d >= 0;
  }

  /**
   * Parameter at which a line enters the slab.
   *
   * @param s coordinate of the line's start along the axis
   * @param d component of its direction along the axis
   * @param h half the thickness, &gt; 0
   * @return the parameter; −∞ for a parallel line inside, NaN for one outside
   */
  static double enter(final double s, final double d, final double h) {
    if (d == 0) {
      return Math.abs(s) <= h ? Double.NEGATIVE_INFINITY : Double.NaN;
    }
    return ((d > 0 ? -h : h) - s) / d;
  }

  /** Parameter at which a line leaves the slab; +∞ for a parallel line. See {@link #enter}. */
  static double leave(final double s, final double d, final double h) {
    return d == 0 ? Double.POSITIVE_INFINITY : ((d > 0 ? h : -h) - s) / d;
  }

  /**
   * Which of the two planes of the slab a line hits. The coordinate of the point decides, unless the slab is so thin that
   * rounding hides it; then the start and the direction of the line decide.
   *
   * @param hit coordinate of the point, computed from the line
   * @param s coordinate of the line's start
   * @param d component of its direction
   * @param h half the thickness, &gt; 0
   * @return −1 or 1
   */
  static double side(final double hit, final double s, final double d, final double h) {
    if (Math.abs(Math.abs(hit) - h) <= 0.5 * h) {
      return Math.copySign(1, hit);
    }
    return Math.copySign(1, Math.abs(s) > h ? s : d);
  }

  /** A coordinate clamped to the slab. */
  static double within(final double s, final double h) {
    return Math.max(-h, Math.min(h, s));
  }
}
