package meshes;

import ch.randelshofer.fastdoubleparser.JavaDoubleParser;

/** Reads decimal numbers from bytes: finds where one ends, and lets fastdoubleparser compute its value. */
final class DecimalParser {

  private int end;

  /** Index after the number that was read last; the index where it should have begun if there was none. */
  int end() {
    return end;
  }

  /**
   * Reads a number: a sign, digits, a point, an exponent. The caller checks what follows it.
   *
   * @param bytes the bytes, in which something other than a number follows
   * @param start index of the first byte
   * @return the number, perhaps infinite; NaN if there is none
   */
  double parse(final byte[] bytes, final int start) {
    final int whole = afterSign(bytes, start);
    int i = afterDigits(bytes, whole);
    int digits = i - whole;
    if (bytes[i] == '.') {
      final int fraction = i + 1;
      i = afterDigits(bytes, fraction);
      digits += i - fraction;
    }
    if (digits == 0) {
      end = start;
      return Double.NaN;
    }
    if ((bytes[i] | 0x20) == 'e') {
      final int exponent = afterSign(bytes, i + 1), after = afterDigits(bytes, exponent);
      i = after > exponent ? after : i;
    }
    end = i;
    return JavaDoubleParser.parseDouble(bytes, start, end - start);
  }

  private static int afterSign(final byte[] bytes, final int i) {
    return bytes[i] == '-' || bytes[i] == '+' ? i + 1 : i;
  }

  private static int afterDigits(final byte[] bytes, final int from) {
    int i = from;
    while (bytes[i] >= '0' && bytes[i] <= '9') {
      i++;
    }
    return i;
  }
}
