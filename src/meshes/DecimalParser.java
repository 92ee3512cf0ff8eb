package meshes;

import ch.randelshofer.fastdoubleparser.JavaDoubleParser;

/**
 * Reads decimal numbers from bytes. A short one without exponent, as nearly all in files of meshes, is the quotient of two
 * numbers that a double holds, and so correctly rounded (Clinger, "How to Read Floating Point Numbers Accurately", PLDI
 * 1990); the value of another comes from fastdoubleparser, which takes longer to load than to read a small mesh.
 */
final class DecimalParser {

  /** Powers of ten that a double holds. */
  private static final double[] POWERS = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
    1e16, 1e17, 1e18};

  /** No more digits than these overflow a long. */
  private static final int LONG_DIGITS = 18;

  /** The greatest number up to which a double holds every whole number. */
  private static final long EXACT = 1L << 53;

  private int end;
  private long digitsRead;

  /** Index after the number that was read last; the index where it should have begun if there was none. */
  int end() {
    return end;
  }

  /**
   * Reads a number: a sign, digits, a point, an exponent. The caller checks what follows it.
   *
   * @param bytes the bytes, in which something other than a number follows
   * @param start index of the first byte
   * @return the number, perhaps infinite; NaN if none
   */
  double parse(final byte[] bytes, final int start) {
    final int whole = afterSign(bytes, start);
    digitsRead = 0;
    end = afterDigits(bytes, whole);
    int digits = end - whole, decimals = 0;
    if (bytes[end] == '.') {
      final int fraction = end + 1;
      end = afterDigits(bytes, fraction);
      decimals = end - fraction;
      digits += decimals;
    }
    if (digits == 0) {
      end = start;
      return Double.NaN;
    }
    if ((bytes[end] | 0x20) != 'e' && digits <= LONG_DIGITS && digitsRead <= EXACT) {
      final double value = digitsRead / POWERS[decimals];
      return bytes[start] == '-' ? -value : value;
    }
    end = afterExponent(bytes, end);
    return JavaDoubleParser.parseDouble(bytes, start, end - start);
  }

  private int afterExponent(final byte[] bytes, final int i) {
    if ((bytes[i] | 0x20) != 'e') {
      return i;
    }
    final int exponent = afterSign(bytes, i + 1), after = afterDigits(bytes, exponent);
    return after > exponent ? after : i;
  }

  private static int afterSign(final byte[] bytes, final int i) {
    return bytes[i] == '-' || bytes[i] == '+' ? i + 1 : i;
  }

  /** Passes over digits, which are appended to those read so far. */
  private int afterDigits(final byte[] bytes, final int from) {
    int i = from;
    long number = digitsRead;
    for (; bytes[i] >= '0' && bytes[i] <= '9'; i++) {
      number = 10 * number + (bytes[i] - '0');
    }
    digitsRead = number;
    return i;
  }
}
