package materials;

/**
 * Blinn's cosine lobe: D(θ) = (q + 2) / (2π) · cos<sup>q</sup> θ with q = −ln 2 / ln cos β. Source: Blinn, "Models of light
 * reflection for computer synthesized pictures", SIGGRAPH 1977, D₁.
 *
 * <p><img src="doc-files/Blinn.png" width="320" height="240" alt="A ball with a highlight of Blinn">
 */
public final class Blinn extends NormalDistributionFunction {

  private final double halfExponent;
  private final double peak;

  /**
   * A cosine lobe.
   *
   * @param beta angle of half value in degrees, from 0 to 90; at 90 all directions are equally likely
   * @throws IllegalArgumentException if beta is outside, or NaN
   */
  public Blinn(final float beta) {
    super(beta);
    this.halfExponent = beta == 90 ? 0 : -Math.log(2) / Math.log1p(-sine2(beta));
    this.peak = (2 * halfExponent + 2) / (2 * Math.PI);
  }

  @Override
  protected double density(final double cosine, final double sine2) {
    final double logCosine2 = sine2 < 0.5 ? Math.log1p(-sine2) : 2 * Math.log(cosine);
    return peak * Math.exp(halfExponent * logCosine2);
  }
}
