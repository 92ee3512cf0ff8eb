package meshes;

import java.nio.charset.StandardCharsets;

/**
 * Reads decimal numbers from bytes, many times faster than {@link Double#parseDouble}.
 *
 * <p>The digits are gathered into a whole number w, and w · 10<sup>e</sup> is computed in double. Up to 15 digits and a
 * power of at most 22 both factors are exact, and so is the rounding: the number is the one that the JDK reads. Beyond that
 * it is wrong by less than 2 units in the last place of a double; digits past the 18th add less than a hundredth. (Clinger,
 * "How to read floating point numbers accurately", PLDI 1990.)
 *
 * <p>The number rounded to float is what {@link Float#parseFloat} reads, always: where a double lies so near the middle
 * between two floats that its error matters, once in tens of millions of numbers, the slow way is taken.
 */
final class DecimalParser {

  /** Most digits that are sure to fit a long. */
  private static final int DIGITS = 18;

  /** Units in the last place of a double from one float to the next, less one: the bits that rounding drops. */
  private static final long DROPPED = (1L << 29) - 1;
  private static final long MIDDLE = 1L << 28;
  private static final long DOUBT = 8;

  /** Powers of ten, from that of the least exponent on. */
  private static final int LARGEST_EXPONENT = 60;
  private static final double[] POWERS = new double[2 * LARGEST_EXPONENT + 1];

  /** The largest whole number and the largest power of ten up to which all are exact in double. */
  private static final long EXACT = 1L << 53;
  private static final int EXACT_POWER = 22;

  static {
    for (int i = 0; i < POWERS.length; i++) {
      POWERS[i] = Double.parseDouble("1e" + (i - LARGEST_EXPONENT));
    }
  }

  private int end;

  /** Index after the number that was read last; the index where it should have begun if there was none. */
  int end() {
    return end;
  }

  /**
   * Reads a number: a sign, digits, a point, an exponent. What follows it is for the caller to look at.
   *
   * @param bytes the bytes, in which something other than a number follows
   * @param start index of the first byte
   * @return the number, perhaps infinite; NaN if there is none
   */
  double parse(final byte[] bytes, final int start) {
    int i = start;
    final boolean negative = bytes[i] == '-';
    if (negative || bytes[i] == '+') {
      i++;
    }
    long w = 0;
    int digits = 0;
    int exponent = 0;
    final int whole = i;
    int digit = bytes[i] - '0';
    while (digit >= 0 && digit <= 9) {
      if (digits < DIGITS) {
        w = 10 * w + digit;
        digits += w == 0 ? 0 : 1;
      } else {
        exponent++;
      }
      digit = bytes[++i] - '0';
    }
    int count = i - whole;
    if (bytes[i] == '.') {
      final int fraction = ++i;
      digit = bytes[i] - '0';
      while (digit >= 0 && digit <= 9) {
        if (digits < DIGITS) {
          w = 10 * w + digit;
          digits += w == 0 ? 0 : 1;
          exponent--;
        }
        digit = bytes[++i] - '0';
      }
      count += i - fraction;
    }
    end = count == 0 ? start : i;
    if (count == 0) {
      return Double.NaN;
    }
    if ((bytes[i] | 0x20) == 'e') {
      exponent += exponent(bytes, i + 1);
    }
    return rounded(negative, w, exponent, bytes, start);
  }

  /** Reads the digits after an e, as far as there are any; moves the end behind them. */
  private int exponent(final byte[] bytes, final int start) {
    final boolean negative = bytes[start] == '-';
    int i = negative || bytes[start] == '+' ? start + 1 : start;
    int exponent = 0;
    boolean any = false;
    for (int digit = bytes[i] - '0'; digit >= 0 && digit <= 9; digit = bytes[++i] - '0') {
      exponent = Math.min(10 * exponent + digit, 100_000);
      any = true;
    }
    if (any) {
      end = i;
    }
    return negative ? -exponent : exponent;
  }

  private double rounded(final boolean negative, final long w, final int exponent, final byte[] bytes, final int start) {
    if (exponent >= -LARGEST_EXPONENT && exponent <= LARGEST_EXPONENT) {
      final boolean exact = exponent < 0 && exponent >= -EXACT_POWER && w <= EXACT;
      final double value = exact ? w / POWERS[LARGEST_EXPONENT - exponent] : w * POWERS[exponent + LARGEST_EXPONENT];
      final long fromMiddle = (Double.doubleToRawLongBits(value) & DROPPED) - MIDDLE;
      final boolean normal = value >= Float.MIN_NORMAL || w == 0;
      if (normal && (fromMiddle > DOUBT || fromMiddle < -DOUBT)) {
        return negative ? -value : value;
      }
    }
    return slowly(new String(bytes, start, end - start, StandardCharsets.ISO_8859_1));
  }

  /** The JDK's double, moved by one unit if it rounds to another float than the text does: it then lies in the middle. */
  private static double slowly(final String text) {
    final double value = Double.parseDouble(text);
    final float rounded = Float.parseFloat(text);
    if ((float) value == rounded) {
      return value;
    }
    return (float) value < rounded ? Math.nextUp(value) : Math.nextDown(value);
  }
}
