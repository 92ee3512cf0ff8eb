package scenes;

/**
 * The numbers that a value may be.
 *
 * @param low least number
 * @param lowAllowed whether the least number is one of them
 * @param high greatest number
 * @param highAllowed whether the greatest number is one of them
 */
record Range(double low, boolean lowAllowed, double high, boolean highAllowed) {

  /** Every finite number. */
  static final Range ANY = new Range(Double.NEGATIVE_INFINITY, false, Double.POSITIVE_INFINITY, false);

  /** Lengths. */
  static final Range POSITIVE = new Range(0, false, Double.POSITIVE_INFINITY, false);

  static final Range NOT_NEGATIVE = new Range(0, true, Double.POSITIVE_INFINITY, false);

  /** Factors of reflection. */
  static final Range UNIT = new Range(0, true, 1, true);

  /** Degrees of a slope. */
  static final Range RIGHT_ANGLE = new Range(0, true, 90, true);

  boolean contains(final double x) {
    return (lowAllowed ? x >= low : x > low) && (highAllowed ? x <= high : x < high);
  }

  /** The range of a name in the signs of mathematics, {@code 0 < fov <= 180}; just the name if it has no ends. */
  String about(final String name) {
    final boolean lowEnd = low > Integer.MIN_VALUE;
    final boolean highEnd = high < Double.POSITIVE_INFINITY;
    if (lowEnd && !highEnd) {
      return name + (lowAllowed ? " >= " : " > ") + number(low);
    }
    return (lowEnd ? number(low) + (lowAllowed ? " <= " : " < ") : "") + name
        + (highEnd ? (highAllowed ? " <= " : " < ") + number(high) : "");
  }

  private static String number(final double x) {
    return x == Math.rint(x) ? Long.toString((long) x) : Double.toString(x);
  }
}
