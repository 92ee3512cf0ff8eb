package models;

import java.util.Arrays;

import org.apache.commons.numbers.core.DD;

/**
 * Real roots of a polynomial where its sign changes, in order, by bisection between the roots of its derivative: slow
 * and certain. Where the sign of a double is uncertain, {@link DD} decides.
 */
final class PolynomialRoots {

  /** Bound of the rounding errors of Horner's scheme in double, for degrees up to 4, relative to the sum of moduli. */
  private static final double UNSURE = 0x1p-49;

  private final DD[] coefficients;

  private PolynomialRoots(final DD... coefficients) {
    this.coefficients = coefficients;
  }

  /**
   * Roots between −bound and bound.
   *
   * @param coefficients in ascending order of powers
   */
  static double[] within(final double bound, final DD... coefficients) {
    return new PolynomialRoots(coefficients).roots(bound);
  }

  private double[] roots(final double bound) {
    if (coefficients.length < 2) {
      return new double[0];
    }
    final double[] turns = derivative().roots(bound);
    final double[] found = new double[turns.length + 1];
    int count = 0;
    double from = -bound;
    for (int i = 0; i <= turns.length; i++) {
      final double to = i < turns.length ? turns[i] : bound;
      if (sign(from) * sign(to) < 0) {
        found[count++] = bisect(from, to, bound);
      }
      from = to;
    }
    return Arrays.copyOf(found, count);
  }

  private PolynomialRoots derivative() {
    final DD[] slopes = new DD[coefficients.length - 1];
    for (int i = 0; i < slopes.length; i++) {
      slopes[i] = coefficients[i + 1].multiply(i + 1);
    }
    return new PolynomialRoots(slopes);
  }

  private double bisect(final double from, final double to, final double bound) {
    final int before = sign(from);
    double low = from, high = to, middle = 0.5 * (low + high);
    while (low < middle && middle < high && high - low > 0x1p-60 * bound) {
      if (sign(middle) == before) {
        low = middle;
      } else {
        high = middle;
      }
      middle = 0.5 * (low + high);
    }
    return middle;
  }

  private int sign(final double x) {
    double value = 0, modulus = 0;
    for (int i = coefficients.length - 1; i >= 0; i--) {
      value = value * x + coefficients[i].hi();
      modulus = modulus * Math.abs(x) + Math.abs(coefficients[i].hi());
    }
    return Math.abs(value) > UNSURE * modulus ? (int) Math.signum(value) : exactSign(x);
  }

  private int exactSign(final double x) {
    DD value = DD.ZERO;
    for (int i = coefficients.length - 1; i >= 0; i--) {
      value = value.multiply(x).add(coefficients[i]);
    }
    return (int) Math.signum(value.hi());
  }
}
