package inspection;

import java.util.Locale;

import javax.vecmath.Tuple3f;

/** Numbers as text, with the digits that a float has, and a point for the decimals whatever the language. */
final class Numbers {

  private Numbers() {
  }

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

  static String text(final Tuple3f tuple) {
    return "(" + text(tuple.x) + ", " + text(tuple.y) + ", " + text(tuple.z) + ")";
  }
}
