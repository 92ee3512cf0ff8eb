package materials;

import radiometry.ReflectanceRGB;

/** A coefficient of a formula in each of the three channels, in double. */
final class Channels {

  /** Zero. */
  static final Channels ZERO = new Channels(0, 0, 0);

  private final double r;
  private final double g;
  private final double b;

  Channels(final double r, final double g, final double b) {
    this.r = r;
    this.g = g;
    this.b = b;
  }

  /** The factors of a reflectance; 0 if it is null. */
  static Channels of(final ReflectanceRGB k) {
    return k == null ? ZERO : new Channels(k.getR(), k.getG(), k.getB());
  }

  /** Whether a reflectance is null or black. */
  static boolean isAbsent(final ReflectanceRGB k) {
    return k == null || k.isBlack();
  }

  double r() {
    return r;
  }

  double g() {
    return g;
  }

  double b() {
    return b;
  }

  Channels times(final double factor) {
    return new Channels(factor * r, factor * g, factor * b);
  }

  Channels times(final Channels other) {
    return new Channels(r * other.r, g * other.g, b * other.b);
  }

  Channels plus(final Channels other) {
    return new Channels(r + other.r, g + other.g, b + other.b);
  }

  /** 1 minus each channel. */
  Channels rest() {
    return new Channels(1 - r, 1 - g, 1 - b);
  }

  double largest() {
    return Math.max(r, Math.max(g, b));
  }
}
