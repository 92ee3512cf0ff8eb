package scenes;

/** The decimal numbers of scene files: a sign, digits, a point, an exponent, and nothing else that Java accepts. */
final class Decimal {

  private Decimal() {
  }

  /** The float to which a text was rounded, but the greatest or the least one in place of overflow or underflow. */
  static float clamped(final String text, final float number) {
    if (Float.isInfinite(number)) {
      return Math.copySign(Float.MAX_VALUE, number);
    }
    return number == 0 && text.split("[eE]")[0].matches(".*[1-9].*") ? Math.copySign(Float.MIN_VALUE, number) : number;
  }

  /** Whether a text is a decimal number. */
  static boolean is(final String text) {
    int i = afterSign(text, 0);
    final int whole = digits(text, i);
    i += whole;
    int fraction = 0;
    if (i < text.length() && text.charAt(i) == '.') {
      fraction = digits(text, ++i);
      i += fraction;
    }
    if (whole + fraction == 0) {
      return false;
    }
    if (i < text.length() && (text.charAt(i) == 'e' || text.charAt(i) == 'E')) {
      i = afterSign(text, i + 1);
      final int exponent = digits(text, i);
      i = exponent == 0 ? -1 : i + exponent;
    }
    return i == text.length();
  }

  private static int afterSign(final String text, final int i) {
    return i < text.length() && (text.charAt(i) == '+' || text.charAt(i) == '-') ? i + 1 : i;
  }

  private static int digits(final String text, final int from) {
    int i = from;
    while (i < text.length() && text.charAt(i) >= '0' && text.charAt(i) <= '9') {
      i++;
    }
    return i - from;
  }

  /** Whether a text is a whole number: digits, perhaps with a sign. */
  static boolean isWhole(final String text) {
    final int start = afterSign(text, 0), digits = digits(text, start);
    return digits > 0 && start + digits == text.length();
  }
}
