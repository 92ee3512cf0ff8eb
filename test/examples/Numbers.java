package examples;

import java.math.BigDecimal;
import java.math.RoundingMode;

/**
 * Numbers as text, the same on every machine. (Angles go through {@link StrictMath} for the same reason: the last digit of
 * {@link Math#sin} may differ from one machine to another.)
 */
final class Numbers {

  private Numbers() {
  }

  /** A number with a maximum number of decimals, without trailing zeros. */
  static String text(final double x, final int digits) {
    final BigDecimal rounded = BigDecimal.valueOf(x).setScale(digits, RoundingMode.HALF_EVEN);
    return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
  }

  /** A point or a direction, to a thousandth. */
  static String triple(final double x, final double y, final double z) {
    return text(x, 3) + ' ' + text(y, 3) + ' ' + text(z, 3);
  }

  static double sin(final double degrees) {
    return StrictMath.sin(StrictMath.toRadians(degrees));
  }

  static double cos(final double degrees) {
    return StrictMath.cos(StrictMath.toRadians(degrees));
  }
}
