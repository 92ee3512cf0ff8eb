package rendering;

/**
 * Encodes linear light as the numbers of a pixel: clamped to [0, 1], encoded by IEC 61966-2-1, "Default RGB colour space
 * - sRGB", 1999, and rounded to 8 bits. As powers are slow, the thresholds between levels are computed once.
 */
final class SrgbEncoding {

  private static final int MOST = 255;

  /** The least number that is shown as level i + 1; at the end infinity, as there is no level 256. */
  private static final double[] STEPS = new double[MOST + 1];

  static {
    for (int level = 1; level <= MOST; level++) {
      double step = decoded((level - 0.5) / 255);
      while (level(step) >= level) {
        step = Math.nextDown(step);
      }
      while (level(step) < level) {
        step = Math.nextUp(step);
      }
      STEPS[level - 1] = step;
    }
    STEPS[MOST] = Double.POSITIVE_INFINITY;
  }

  /**
   * Number of equal parts of [0, 1]. They are narrower than the narrowest level, 1 / (255 · 12.92), so that at most one
   * level ends in each.
   */
  private static final int PARTS = 4096;

  /** The level of the least number of each part. */
  private static final byte[] LEVELS = new byte[PARTS];

  static {
    int level = 0;
    for (int part = 0; part < PARTS; part++) {
      while (STEPS[level] <= (double) part / PARTS) {
        level++;
      }
      LEVELS[part] = (byte) level;
    }
  }

  /** The linear values of the levels. */
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

  /** The linear value of a level. */
  static double number(final int level) {
    return NUMBERS[level];
  }

  /** The level of any number, which is cut to [0, 1]: 0 for NaN. */
  static int channel(final double v) {
    if (!(v > 0)) {
      return 0;
    }
    if (v >= 1) {
      return MOST;
    }
    final int level = LEVELS[(int) (PARTS * v)] & 0xff;
    return v >= STEPS[level] ? level + 1 : level;
  }
}
