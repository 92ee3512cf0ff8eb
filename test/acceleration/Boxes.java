package acceleration;

import java.util.Random;

/** Boxes of all kinds, six floats each, and where rays hit them: the linear scan that a tree is compared with. */
final class Boxes {

  /** Kinds of random sets of boxes. */
  enum Kind { SCATTERED, CLUSTERED, EQUAL_CENTRES, EQUAL, FLAT, POINTS, NESTED, ALL_SCALES, GRID, HUGE_AND_TINY }

  final float[] numbers;

  Boxes(final float... numbers) {
    this.numbers = numbers;
  }

  /** Random boxes of sizes about 1, except for the kinds that have all sizes. */
  static Boxes random(final Random random, final Kind kind, final int count) {
    final float[] numbers = new float[6 * count];
    for (int i = 0; i < count; i++) {
      final double[] c = new double[3], h = new double[3];
      for (int k = 0; k < 3; k++) {
        c[k] = centre(random, kind, i);
        h[k] = half(random, kind, i, k);
      }
      for (int k = 0; k < 3; k++) {
        numbers[6 * i + k] = (float) (c[k] - h[k]);
        numbers[6 * i + 3 + k] = (float) (c[k] + h[k]);
      }
    }
    return new Boxes(numbers);
  }

  private static double centre(final Random random, final Kind kind, final int i) {
    switch (kind) {
      case CLUSTERED: return i % 5 + 1e-6 * random.nextGaussian();
      case EQUAL_CENTRES: case EQUAL: case NESTED: return 0.25;
      case ALL_SCALES: return Math.pow(10, 60 * random.nextDouble() - 30) * (random.nextInt(3) - 1);
      case GRID: return random.nextInt(10);
      default: return random.nextGaussian();
    }
  }

  private static double half(final Random random, final Kind kind, final int i, final int k) {
    switch (kind) {
      case EQUAL: return 0.5;
      case GRID: return random.nextInt(2) * 0.5;
      case FLAT: return random.nextInt(2) * random.nextDouble();
      case POINTS: return 0;
      case NESTED: return Math.pow(1.01, i % 2000 - 1000);
      case ALL_SCALES: case HUGE_AND_TINY: return Math.pow(10, 60 * random.nextDouble() - 30);
      default: return 0.3 * random.nextDouble();
    }
  }

  int count() {
    return numbers.length / 6;
  }

  /** A copy scaled by a power of two. */
  Boxes times(final float factor) {
    final float[] scaled = numbers.clone();
    for (int i = 0; i < scaled.length; i++) {
      scaled[i] *= factor;
    }
    return new Boxes(scaled);
  }

  /** A random point of a box: within, or on a face, an edge or a corner. */
  float[] pointOf(final Random random, final int box) {
    final float[] P = new float[3];
    for (int k = 0; k < 3; k++) {
      final float min = numbers[6 * box + k], max = numbers[6 * box + 3 + k];
      final int where = random.nextInt(3);
      P[k] = where == 0 ? min : where == 1 ? max : Math.max(min, Math.min(max, 0.5f * min + 0.5f * max));
    }
    return P;
  }

  /** Where a ray enters a box, 0 if it starts inside; infinity if it misses it. */
  double enter(final int box, final double[] start, final double[] direction) {
    double enter = 0, leave = Double.POSITIVE_INFINITY;
    for (int k = 0; k < 3; k++) {
      final float min = numbers[6 * box + k], max = numbers[6 * box + 3 + k];
      if (direction[k] == 0) {
        if (start[k] < min || start[k] > max) {
          return Double.POSITIVE_INFINITY;
        }
      } else {
        final double a = (min - start[k]) / direction[k], b = (max - start[k]) / direction[k];
        enter = Math.max(enter, Math.min(a, b));
        leave = Math.min(leave, Math.max(a, b));
      }
    }
    return enter <= leave ? enter : Double.POSITIVE_INFINITY;
  }
}
