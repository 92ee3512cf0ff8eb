package materials;

import radiometry.ReflectanceRGB;

/**
 * The surface of clear glass or water: ideal reflection and ideal refraction, and no lobe. Source: Whitted, "An improved
 * illumination model for shaded display", Communications of the ACM 23(6), 1980; factors as in {@link BTDF}.
 *
 * <p><img src="doc-files/IdealDielectric.png" width="320" height="240" alt="A glass ball">
 */
public final class IdealDielectric extends BTDF {

  /**
   * A smooth surface between two transparent media.
   *
   * @param dielectric k, the part of the light that is not absorbed at the surface; null for none, which looks black
   * @param eta_int index of refraction inside, &gt; 0
   * @param eta_ext index of refraction outside, &gt; 0
   * @throws IllegalArgumentException if an index is not positive or not finite
   */
  public IdealDielectric(final ReflectanceRGB dielectric, final float eta_int, final float eta_ext) {
    super(dielectric, eta_int, eta_ext);
  }

  @Override
  public boolean scatters() {
    return false;
  }

  @Override
  public void scatter(final SurfaceInteraction interaction) {
    interaction.setRadiance(0, 0, 0);
  }

  @Override
  public String toString() {
    return "IdealDielectric(" + media() + ")";
  }
}
