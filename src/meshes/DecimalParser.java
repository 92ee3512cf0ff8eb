package meshes;

import java.nio.charset.StandardCharsets;

/**
 * Reads decimal numbers from bytes, rounded to the nearest float as {@link Float#parseFloat} does, many times faster.
 *
 * <p>The digits are gathered into a whole number w, and w · 10^e is computed in double: w is rounded once, the power of ten
 * once and the product once, so that the double is wrong by less than 2 of its units in the last place; digits past
 * the 18th add less than a hundredth. The float nearest to it is the right one unless the double lies that near to the
 * middle between two floats, 2<sup>28</sup> units from either: then, once in tens of millions of numbers, the slow and
 * exact way is taken. (The idea is that of Clinger, "How to read floating point numbers accurately", PLDI 1990.)
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
   * @return the number, infinite if it is larger than floats are; NaN if there is none
   */
  float parse(final byte[] bytes, final int start) {
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
      return Float.NaN;
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

  private float rounded(final boolean negative, final long w, final int exponent, final byte[] bytes, final int start) {
    if (exponent >= -LARGEST_EXPONENT && exponent <= LARGEST_EXPONENT) {
      final double value = w * POWERS[exponent + LARGEST_EXPONENT];
      final long fromMiddle = (Double.doubleToRawLongBits(value) & DROPPED) - MIDDLE;
      final boolean normal = value >= Float.MIN_NORMAL || w == 0;
      if (normal && (fromMiddle > DOUBT || fromMiddle < -DOUBT)) {
        return negative ? (float) -value : (float) value;
      }
    }
    return Float.parseFloat(new String(bytes, start, end - start, StandardCharsets.ISO_8859_1));
  }
}
