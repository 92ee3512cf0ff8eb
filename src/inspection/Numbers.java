package inspection;

import java.math.BigDecimal;
import java.util.Locale;

import javax.vecmath.Tuple3f;

/** Numbers as text, with a point for the decimals whatever the language, and none where there are no decimals. */
public final class Numbers {

  private Numbers() {
  }

  /** A number that was computed in double, with seven digits. */
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
   * A float with as many digits as tell it from all others.
   *
   * @param number any number
   * @return the number; with a power of ten only below 0.0001 and from ten million on
   */
  public static String text(final float number) {
    if (number == 0) {
      return "0";
    }
    final String text = Float.toString(number).replaceAll("\\.0(?=E|$)", "");
    return text.endsWith("E-4") ? new BigDecimal(text).toPlainString() : text;
  }

  /**
   * A point or a vector.
   *
   * @param tuple its coordinates
   * @return them as {@link #text(float)} has them, in parentheses
   */
  public static String text(final Tuple3f tuple) {
    return "(" + text(tuple.x) + ", " + text(tuple.y) + ", " + text(tuple.z) + ")";
  }
}
