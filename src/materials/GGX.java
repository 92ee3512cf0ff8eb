package materials;

/**
 * The distribution of an ellipsoid's normals, with a long tail: D(θ) = α² / (π (α² cos² θ + sin² θ)²), α² = sin² β /
 * (√2 − cos² β). Sources: Trowbridge and Reitz, as D₃ in Blinn, "Models of light reflection for computer synthesized
 * pictures", SIGGRAPH 1977; Walter, Marschner, Li and Torrance, "Microfacet models for refraction through rough
 * surfaces", EGSR 2007, section 5.2.
 *
 * <p><img src="doc-files/GGX.png" width="320" height="240" alt="A ball with a highlight of GGX, which has a long tail">
 */
public final class GGX extends NormalDistributionFunction {

  private final double alpha2;

  /**
   * The distribution of an ellipsoid.
   *
   * @param beta angle of half value in degrees, from 0 to 90
   * @throws IllegalArgumentException if beta is outside, or NaN
   */
  public GGX(final float beta) {
    super(beta);
    final double sine2 = sine2(beta);
    this.alpha2 = sine2 / (Math.sqrt(2) - 1 + sine2);
  }

  @Override
  protected double density(final double cosine, final double sine2) {
    final double d = alpha2 * cosine * cosine + sine2;
    return alpha2 / (Math.PI * d * d);
  }
}
