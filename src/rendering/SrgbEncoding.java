package rendering;

/**
 * How linear light becomes the numbers of a pixel: cut to [0, 1], encoded by IEC 61966-2-1, "Default RGB colour space -
 * sRGB", 1999, and rounded to 8 bits. As raising to a power takes long, the numbers where one level ends and the next begins
 * are computed once.
 */
final class SrgbEncoding {

  /** The least number that is shown as level i + 1. */
  private static final double[] STEPS = new double[255];

  static {
    for (int level = 1; level <= 255; level++) {
      double step = decoded((level - 0.5) / 255);
      while (level(step) >= level) {
        step = Math.nextDown(step);
      }
      while (level(step) < level) {
        step = Math.nextUp(step);
      }
      STEPS[level - 1] = step;
    }
  }

  /** The numbers that the levels stand for. */
  private static final double[] NUMBERS = new double[256];

  static {
    for (int level = 0; level < NUMBERS.length; level++) {
      NUMBERS[level] = decoded(level / 255.0);
    }
  }

  private SrgbEncoding() {
  }

  private static double decoded(final double s) {
    return s <= 0.04045 ? s / 12.92 : Math.pow((s + 0.055) / 1.055, 2.4);
  }

  /** The level of a number of [0, 1], by the formula. */
  private static int level(final double v) {
    return (int) (255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * Math.pow(v, 1 / 2.4) - 0.055) + 0.5);
  }

  /** The pixel of three numbers, opaque. */
  static int argb(final double r, final double g, final double b) {
    return 0xff << 24 | channel(r) << 16 | channel(g) << 8 | channel(b);
  }

  /** The number that a level stands for. */
  static double number(final int level) {
    return NUMBERS[level];
  }

  /** The level of any number: the number of steps up to it. */
  static int channel(final double v) {
    int low = 0, high = 255;
    while (low < high) {
      final int middle = low + high >>> 1;
      if (v >= STEPS[middle]) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }
}
