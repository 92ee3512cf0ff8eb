package rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** The encoding of sRGB: ⌊255 s + ½⌋ with s as IEC 61966-2-1 has it, at its very steps and beyond its ends. */
class SrgbEncodingTest {

  private static int level(final double v) {
    final double s = v <= 0.0031308 ? 12.92 * v : 1.055 * Math.pow(v, 1 / 2.4) - 0.055;
    return (int) Math.floor(255 * s + 0.5);
  }

  /** The least number that the formula shows as a level, by bisection. */
  private static double leastOf(final int level) {
    double low = 0, high = 1;
    while (true) {
      final double middle = 0.5 * (low + high);
      if (!(low < middle && middle < high)) {
        return high;
      }
      if (level(middle) >= level) {
        high = middle;
      } else {
        low = middle;
      }
    }
  }

  @Test
  void levelsBeginWhereTheFormulaSays() {
    for (int i = 1; i <= 255; i++) {
      final double least = leastOf(i);
      assertEquals(i, SrgbEncoding.channel(least));
      assertEquals(i - 1, SrgbEncoding.channel(Math.nextDown(least)));
    }
  }

  @Test
  void whatLiesBeyondTheEndsIsCut() {
    for (final double dark : new double[] {Double.NaN, Double.NEGATIVE_INFINITY, -1, -0.0, 0, Double.MIN_VALUE}) {
      assertEquals(0, SrgbEncoding.channel(dark));
    }
    for (final double bright : new double[] {1, Math.nextDown(1.0), 2, 1e300, Double.POSITIVE_INFINITY}) {
      assertEquals(255, SrgbEncoding.channel(bright));
    }
    assertEquals(0xffff0080, SrgbEncoding.argb(7, 0, SrgbEncoding.number(128)));
  }

  @Test
  void levelsStandForTheNumbersOfTheFormula() {
    for (int i = 0; i < 256; i++) {
      final double s = i / 255.0, v = s <= 0.04045 ? s / 12.92 : Math.pow((s + 0.055) / 1.055, 2.4);
      assertEquals(v, SrgbEncoding.number(i), 1e-15);
      assertEquals(i, SrgbEncoding.channel(SrgbEncoding.number(i)));
    }
  }
}
