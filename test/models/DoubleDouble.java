package models;

/**
 * A number of about 32 digits, held as the sum of two doubles: what the oracles compute with. Source: Dekker, "A
 * floating-point technique for extending the available precision", Numerische Mathematik 18, 1971.
 */
record DoubleDouble(double high, double low) {

  static final DoubleDouble ZERO = new DoubleDouble(0, 0);

  static DoubleDouble of(final double value) {
    return new DoubleDouble(value, 0);
  }

  static DoubleDouble sum(final double a, final double b) {
    final double s = a + b, c = s - a;
    return new DoubleDouble(s, (a - (s - c)) + (b - c));
  }

  static DoubleDouble product(final double a, final double b) {
    final double p = a * b;
    return new DoubleDouble(p, Math.fma(a, b, -p));
  }

  DoubleDouble plus(final DoubleDouble b) {
    final DoubleDouble s = sum(high, b.high), l = sum(low, b.low);
    final DoubleDouble t = sum(s.high, s.low + l.high);
    return sum(t.high, t.low + l.low);
  }

  DoubleDouble minus(final DoubleDouble b) {
    return plus(new DoubleDouble(-b.high, -b.low));
  }

  DoubleDouble times(final DoubleDouble b) {
    final DoubleDouble p = product(high, b.high);
    return sum(p.high, p.low + (high * b.low + low * b.high));
  }

  DoubleDouble times(final double b) {
    return times(of(b));
  }

  DoubleDouble over(final DoubleDouble b) {
    final double first = high / b.high;
    final DoubleDouble rest = minus(b.times(first));
    final double second = rest.high / b.high;
    return sum(first, second).plus(of(rest.minus(b.times(second)).high / b.high));
  }

  DoubleDouble sqrt() {
    final double root = Math.sqrt(high);
    return root == 0 ? ZERO : sum(root, minus(product(root, root)).high / (2 * root));
  }

  static DoubleDouble dot(final DoubleDouble[] a, final DoubleDouble[] b) {
    return a[0].times(b[0]).plus(a[1].times(b[1])).plus(a[2].times(b[2]));
  }

  DoubleDouble absolute() {
    return sign() < 0 ? ZERO.minus(this) : this;
  }

  int sign() {
    return high != 0 ? (int) Math.signum(high) : (int) Math.signum(low);
  }
}
