package models;

/**
 * Roots of a t² − 2 b t + c = 0 for a &gt; 0, without cancellation: one root is q / a with q = b ± √D, the sign chosen so
 * that nothing cancels, the other c / q (Press et al., "Numerical Recipes", §5.6).
 */
final class Quadratic {

  private Quadratic() {
  }

  /**
   * Smaller root.
   *
   * @param sqrtD square root of the discriminant b² − a c, computed by the caller as accurately as possible
   */
  static double smaller(final double a, final double b, final double c, final double sqrtD) {
    return b > 0 ? c / (b + sqrtD) : (b - sqrtD) / a;
  }

  /** Greater root; see {@link #smaller}. */
  static double greater(final double a, final double b, final double c, final double sqrtD) {
    return b >= 0 ? (b + sqrtD) / a : c / (b - sqrtD);
  }

  /** The first of two ordered numbers that is greater than 0; infinity if none is, or if both are NaN. */
  static double firstPositive(final double smaller, final double greater) {
    return smaller > 0 ? smaller : greater > 0 ? greater : Double.POSITIVE_INFINITY;
  }
}
