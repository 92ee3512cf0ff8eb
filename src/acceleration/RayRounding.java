package acceleration;

/**
 * Rounds the numbers of rays: starts and directions to floats, and normalises the directions again in double. The loops
 * convert nothing, so that the compiler can vectorise them.
 */
public final class RayRounding {

  /** 2^29 + 1, which splits the 24 bits of a float off the 53 of a double. */
  private static final double SPLITTER = (1 << 29) + 1;

  private RayRounding() {
  }

  static void roundStarts(final int n, final double[] x) {
    for (int i = 0; i < n; i++) {
      x[i] = rounded(x[i]);
    }
  }

  static void roundDirections(final int n, final double[] x, final double[] y, final double[] z) {
    for (int i = 0; i < n; i++) {
      final double k = 1 / Math.sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
      x[i] = rounded(k * x[i]);
      y[i] = rounded(k * y[i]);
      z[i] = rounded(k * z[i]);
    }
  }

  static void bringToUnit(final int n, final double[] x, final double[] y, final double[] z,
      final double[] unitX, final double[] unitY, final double[] unitZ) {
    for (int i = 0; i < n; i++) {
      final double k = toUnit(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
      unitX[i] = k * x[i];
      unitY[i] = k * y[i];
      unitZ[i] = k * z[i];
    }
  }

  /**
   * Rounds a number to the 24 significant bits of a float, without converting it (Veltkamp's splitting; Dekker, "A
   * Floating-Point Technique for Extending the Available Precision", 1971). The range of float does not limit the result:
   * it becomes neither subnormal nor infinite where a float would.
   *
   * @param x a number, at most 2<sup>900</sup>
   * @return the nearest number of 24 bits
   */
  public static double rounded(final double x) {
    final double p = SPLITTER * x;
    return p - (p - x);
  }

  /**
   * The factor that normalises a vector whose length is 1 up to the rounding of floats: 1 / √(1 + δ) by its series, whose
   * next term, of δ³ &lt; 10<sup>-19</sup>, is beyond double.
   *
   * @param squaredLength square of the vector's length, 1 + δ
   * @return the factor
   */
  public static double toUnit(final double squaredLength) {
    final double delta = squaredLength - 1;
    return 1 - delta * (0.5 - 0.375 * delta);
  }
}
