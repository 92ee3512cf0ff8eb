package models;

import java.math.BigDecimal;
import java.math.MathContext;

import javax.vecmath.Tuple3f;

/** A vector of decimals: exact sums and products, quotients and roots to 50 digits. */
record ExactVector(BigDecimal x, BigDecimal y, BigDecimal z) {

  static final MathContext DIGITS = new MathContext(50);

  private static final BigDecimal HALF = new BigDecimal(0.5);

  static ExactVector of(final Tuple3f tuple) {
    return of(tuple.x, tuple.y, tuple.z);
  }

  static ExactVector of(final double x, final double y, final double z) {
    return new ExactVector(new BigDecimal(x), new BigDecimal(y), new BigDecimal(z));
  }

  ExactVector plus(final ExactVector v) {
    return new ExactVector(x.add(v.x, DIGITS), y.add(v.y, DIGITS), z.add(v.z, DIGITS));
  }

  ExactVector minus(final ExactVector v) {
    return plus(v.times(BigDecimal.ONE.negate()));
  }

  ExactVector times(final BigDecimal k) {
    return new ExactVector(x.multiply(k, DIGITS), y.multiply(k, DIGITS), z.multiply(k, DIGITS));
  }

  BigDecimal dot(final ExactVector v) {
    return x.multiply(v.x).add(y.multiply(v.y)).add(z.multiply(v.z), DIGITS);
  }

  ExactVector cross(final ExactVector v) {
    return new ExactVector(y.multiply(v.z).subtract(z.multiply(v.y), DIGITS),
        z.multiply(v.x).subtract(x.multiply(v.z), DIGITS),
        x.multiply(v.y).subtract(y.multiply(v.x), DIGITS));
  }

  BigDecimal length() {
    return root(dot(this));
  }

  /** Square root, by Newton's method from that of the double: three steps double its 16 digits to more than are kept. */
  static BigDecimal root(final BigDecimal a) {
    if (a.signum() == 0) {
      return a;
    }
    BigDecimal root = new BigDecimal(Math.sqrt(a.doubleValue()));
    for (int i = 0; i < 3; i++) {
      root = root.add(a.divide(root, DIGITS), DIGITS).multiply(HALF, DIGITS);
    }
    return root;
  }

  ExactVector normalised() {
    return times(BigDecimal.ONE.divide(length(), DIGITS));
  }
}
