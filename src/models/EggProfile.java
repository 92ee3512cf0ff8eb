package models;

/**
 * The curve that an {@link Egg} is the surface of revolution of: its radius ρ at a height y along the axis,
 * ρ² = a² (b² − y²) / (b² + 2 w y + w²) for |y| ≤ b.
 *
 * <p>Heights are measured from both poles, h = b + y and b − y, so that nothing cancels near them; and b² + 2 w y + w² =
 * (b − w)² + 2 w h is a sum of positive terms, which is accurate even where w is close to b.
 */
final class EggProfile {

  /** Steps of the golden section search: enough to narrow the half circle down to the rounding error. */
  private static final int STEPS = 80;

  private static final double GOLDEN = 0.5 * (Math.sqrt(5) - 1);

  /** Rounding of the search's result, relative to the radius and the half length. */
  private static final double NOISE = 0x1p-40;

  final double a;
  final double b;
  final double w;
  private final double square;

  EggProfile(final double a, final double b, final double w) {
    this.a = a;
    this.b = b;
    this.w = w;
    this.square = (b - w) * (b - w);
  }

  /** The denominator q = b² + 2 w y + w² at the height h − b. */
  double denominator(final double h) {
    return square + 2 * w * h;
  }

  /** ρ² at a height, which is clamped to the poles. */
  double radiusSquared(final double y) {
    final double h = Math.max(0, b + y);
    return a * a * (h * Math.max(0, b - y)) / denominator(h);
  }

  /** Derivative of ρ² with respect to the height. */
  double slope(final double y) {
    final double h = Math.max(0, b + y), below = Math.max(0, b - y), q = denominator(h);
    return a * a * ((below - h) - 2 * w * (h * below / q)) / q;
  }

  /**
   * The largest component of a point of the egg along a direction. As the egg is convex, the component along its outline,
   * y = b cos φ, has one maximum only, which golden section search finds.
   *
   * @param along component along the axis of the direction, a unit vector
   * @param across its component perpendicular to the axis, ≥ 0
   * @return the support function, at least the exact one and at most that of the cylinder around the egg
   */
  double support(final double along, final double across) {
    double low = 0, high = Math.PI;
    double first = high - GOLDEN * (high - low), second = low + GOLDEN * (high - low);
    double atFirst = component(first, along, across), atSecond = component(second, along, across);
    double most = b * Math.abs(along);
    for (int i = 0; i < STEPS; i++) {
      most = Math.max(most, Math.max(atFirst, atSecond));
      if (atFirst > atSecond) {
        high = second;
        second = first;
        atSecond = atFirst;
        first = high - GOLDEN * (high - low);
        atFirst = component(first, along, across);
      } else {
        low = first;
        first = second;
        atFirst = atSecond;
        second = low + GOLDEN * (high - low);
        atSecond = component(second, along, across);
      }
    }
    return Math.min(most + NOISE * (a * across + b * Math.abs(along)), a * across + b * Math.abs(along));
  }

  private double component(final double phi, final double along, final double across) {
    final double sin = Math.sin(0.5 * phi), cos = Math.cos(0.5 * phi), h = 2 * b * cos * cos;
    return b * Math.cos(phi) * along + across * 2 * a * b * sin * cos / Math.sqrt(denominator(h));
  }
}
