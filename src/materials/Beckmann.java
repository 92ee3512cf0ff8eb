package materials;

/**
 * A Gaussian of slopes: D(θ) = exp(−tan² θ / α²) / (π α² cos⁴ θ), α² = tan² β / (ln 2 − 4 ln cos β). Sources: Cook and
 * Torrance, "A reflectance model for computer graphics", ACM Transactions on Graphics 1(1), 1982; Walter, Marschner, Li
 * and Torrance, "Microfacet models for refraction through rough surfaces", EGSR 2007, section 5.2.
 *
 * <p><img src="doc-files/Beckmann.png" width="320" height="240" alt="A ball with a highlight of Beckmann">
 */
public final class Beckmann extends NormalDistributionFunction {

  /** Greatest β in degrees: at 90 no slope would be finite. */
  private static final float WIDEST = 89;

  private final double alpha2;

  /**
   * A Gaussian of slopes.
   *
   * @param beta angle of half value in degrees, from 0 to 90; above 89 it counts as 89
   * @throws IllegalArgumentException if beta is outside, or NaN
   */
  public Beckmann(final float beta) {
    super(beta);
    final double sine2 = sine2(Math.min(beta, WIDEST));
    this.alpha2 = sine2 / (1 - sine2) / (Math.log(2) - 2 * Math.log1p(-sine2));
  }

  @Override
  protected double density(final double cosine, final double sine2) {
    final double cosine2 = cosine * cosine, exp = Math.exp(-sine2 / cosine2 / alpha2);
    return exp > 0 ? exp / (Math.PI * alpha2 * cosine2 * cosine2) : 0;
  }
}
