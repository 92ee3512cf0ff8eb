package materials;

/**
 * Phong's lobe in terms of h, whose angle to n is half of that to the mirrored direction: D(θ) = 2 (q + 1) / π ·
 * cos<sup>q</sup> 2θ for θ &lt; 45°, else 0, with q = −ln 2 / ln cos 2β. Source: Horn, "Hill shading and the
 * reflectance map", Proceedings of the IEEE 69(1), 1981.
 *
 * <p><img src="doc-files/Horn.png" width="320" height="240" alt="A ball with a highlight of Horn">
 */
public final class Horn extends NormalDistributionFunction {

  private final double exponent;
  private final double peak;

  /**
   * Phong's lobe.
   *
   * @param beta angle of half value in degrees, from 0 to 90; from 45 on, all directions up to 45° are equally likely
   * @throws IllegalArgumentException if beta is outside, or NaN
   */
  public Horn(final float beta) {
    super(beta);
    this.exponent = beta >= 45 ? 0 : -Math.log(2) / Math.log1p(-2 * sine2(beta));
    this.peak = 2 * (exponent + 1) / Math.PI;
  }

  @Override
  protected double density(final double cosine, final double sine2) {
    return sine2 < 0.5 ? peak * Math.exp(exponent * Math.log1p(-2 * sine2)) : 0;
  }
}
