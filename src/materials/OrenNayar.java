package materials;

import static arguments.Arguments.within;

import radiometry.ReflectanceRGB;

/**
 * A rough matte surface, such as clay or the moon, flatter in brightness than Lambert's: f = k<sub>d</sub>/π · (A + B ·
 * max(0, cos φ) · sin α · tan β), with α the larger and β the smaller of the angles of wi and wo to the normal, φ the
 * angle between their projections on the surface, A = 1 − σ² / (2 (σ² + 0.33)) and B = 0.45 σ² / (σ² + 0.09), σ in
 * radians. For σ = 0 it is Lambert's.
 *
 * <p><img src="doc-files/OrenNayar.png" width="320" height="240" alt="A ball as of clay, flat in brightness">
 *
 * <p>The formula is an approximation: with σ below 19 degrees, a white surface seen at a grazing angle reflects up to 1.5 %
 * more than it receives.
 *
 * <p>Computed without angles: cos φ sin α tan β = (pi·po) / max(ci, co), where pi·po = wi·wo − ci co is the product of the
 * projections. Source: Oren and Nayar, "Generalization of Lambert's reflectance model", SIGGRAPH 1994, equation 30.
 */
public final class OrenNayar extends DiffuseSpecular {

  private final ReflectanceRGB diffuse;
  private final float sigma;
  private final double a;
  private final double b;

  /**
   * A rough matte surface.
   *
   * @param diffuse k<sub>d</sub>, not black
   * @param sigma roughness, the standard deviation of the slope angle of its facets in degrees, from 0 to 90
   * @throws IllegalArgumentException if diffuse is null or black, or if sigma is outside, or NaN
   */
  public OrenNayar(final ReflectanceRGB diffuse, final float sigma) {
    super(Channels.of(Energy.notBlack("diffuse", diffuse)).times(1 / Math.PI), Channels.ZERO, Channels.ZERO, null,
        StandIn.of(diffuse));
    this.diffuse = diffuse;
    this.sigma = within("sigma", 0f, 90f, sigma);
    final double radians = Math.toRadians(sigma), variance = radians * radians;
    this.a = 1 - variance / (2 * (variance + 0.33));
    this.b = 0.45 * variance / (variance + 0.09);
  }

  @Override
  double diffuse(final SurfaceInteraction interaction) {
    final double ci = interaction.cosineIn(), co = interaction.cosineOut();
    return a + b * Math.max(0, (interaction.cosineBetween() - ci * co) / Math.max(ci, co));
  }

  @Override
  public String toString() {
    return "OrenNayar(" + diffuse + ", " + sigma + ")";
  }
}
