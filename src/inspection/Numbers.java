package inspection;

import java.math.BigDecimal;
import java.util.Locale;

import javax.vecmath.Tuple3f;

/** Formats numbers, with a decimal point in every language and without trailing zeros. */
public final class Numbers {

  private Numbers() {
  }

  /** Formats a double with seven significant digits. */
  static String text(final double number) {
    if (number == 0) {
      return "0";
    }
    final String text = String.format(Locale.ROOT, "%.7g", number);
    if (text.indexOf('e') >= 0 || text.indexOf('.') < 0) {
      return text;
    }
    return text.replaceAll("\\.?0+$", "");
  }

  /**
   * Formats a float with as many digits as distinguish it from all others.
   *
   * @param number any number
   * @return its decimal representation, in scientific notation below 0.0001 and from ten million
   */
  public static String text(final float number) {
    if (number == 0) {
      return "0";
    }
    final String text = Float.toString(number).replaceAll("\\.0(?=E|$)", "");
    return text.endsWith("E-4") ? new BigDecimal(text).toPlainString() : text;
  }

  /**
   * Formats a point or a vector.
   *
   * @param tuple its coordinates
   * @return the coordinates as by {@link #text(float)}, in parentheses
   */
  public static String text(final Tuple3f tuple) {
    return "(" + text(tuple.x) + ", " + text(tuple.y) + ", " + text(tuple.z) + ")";
  }
}
