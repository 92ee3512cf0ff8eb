package materials;

/**
 * Torrance and Sparrow's Gaussian: D(θ) = N · exp(−κ θ²), θ in radians, κ = ln 2 / β². Source: Blinn, "Models of light
 * reflection for computer synthesized pictures", SIGGRAPH 1977, D₂. There is no closed form of N, which is computed by
 * Simpson's rule.
 *
 * <p><img src="doc-files/Torrance.png" width="320" height="240" alt="A ball with a highlight of Torrance">
 */
public final class Torrance extends NormalDistributionFunction {

  /** Where exp(−κ θ²) = exp(−49): what lies beyond does not change the integral in double. */
  private static final double END = 7;

  /** Intervals of Simpson's rule: at a step of END / 2000 its error is below 1e-10. */
  private static final int INTERVALS = 2000;

  private final double kappa;
  private final double peak;

  /**
   * A Gaussian.
   *
   * @param beta angle of half value in degrees, from 0 to 90
   * @throws IllegalArgumentException if beta is outside, or NaN
   */
  public Torrance(final float beta) {
    super(beta);
    final double radians = Math.toRadians(beta);
    this.kappa = Math.log(2) / (radians * radians);
    this.peak = isPolished() ? Double.POSITIVE_INFINITY : 1 / integral();
  }

  /** The integral of exp(−κ θ²) (n·h) over the hemisphere, 2π ∫ exp(−κ θ²) cos θ sin θ dθ, whose ends contribute nothing. */
  private double integral() {
    final double end = Math.min(Math.PI / 2, END / Math.sqrt(kappa)), step = end / INTERVALS;
    double sum = 0;
    for (int i = 1; i < INTERVALS; i++) {
      sum += (i % 2 == 0 ? 2 : 4) * integrand(i * step);
    }
    return sum * step / 3;
  }

  private double integrand(final double theta) {
    return Math.PI * Math.sin(2 * theta) * Math.exp(-kappa * theta * theta);
  }

  @Override
  protected double density(final double cosine, final double sine2) {
    final double theta = Math.atan2(Math.sqrt(sine2), cosine);
    return peak * Math.exp(-kappa * theta * theta);
  }
}
