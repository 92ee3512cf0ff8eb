package scenes;

/**
 * The range of a value.
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

  /** Shares of a whole, which may exceed 1 by what their sum may. */
  static final Range SHARE = new Range(0, true, 1 + LightReader.TOLERANCE, true);

  /** Degrees of a slope. */
  static final Range RIGHT_ANGLE = new Range(0, true, 90, true);

  boolean contains(final double x) {
    return (lowAllowed ? x >= low : x > low) && (highAllowed ? x <= high : x < high);
  }

  /** Whether the range is bounded; the bounds of the number's type do not count. */
  boolean hasEnd() {
    return hasLowEnd() || hasHighEnd();
  }

  private boolean hasLowEnd() {
    return low > Integer.MIN_VALUE;
  }

  private boolean hasHighEnd() {
    return high < Double.POSITIVE_INFINITY;
  }

  /** The range as an inequality of a name, {@code 0 < fov <= 180}. */
  String about(final String name) {
    if (!hasHighEnd()) {
      return name + (lowAllowed ? " >= " : " > ") + number(low);
    }
    return (hasLowEnd() ? number(low) + (lowAllowed ? " <= " : " < ") : "") + name
        + (highAllowed ? " <= " : " < ") + number(high);
  }

  /** A number of this range, as an example of how numbers are written. */
  String example() {
    return contains(2.5) ? "2.5" : "0.5";
  }

  /** A bound as people write it: without its tolerance. */
  private static String number(final double x) {
    return Math.abs(x - Math.rint(x)) <= LightReader.TOLERANCE ? Long.toString(Math.round(x)) : Double.toString(x);
  }
}
