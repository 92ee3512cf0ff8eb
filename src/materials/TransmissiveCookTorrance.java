package materials;

import radiometry.ReflectanceRGB;

/**
 * The rough surface of glass: lights are seen as lobes, on both sides; other objects along the ideal rays, as if the
 * surface were smooth. With ci = |n·wi| and co = n·wo:
 * <ul>
 * <li>same side, h = unit(wi + wo): f = k F(wo·h) D(h) G / (4 ci co);</li>
 * <li>other side, h = ±unit(η<sub>t</sub> wi + η<sub>o</sub> wo) with the sign that makes n·h &gt; 0: f = k ·
 *     |wi·h||wo·h| / (ci co) · η<sub>o</sub>² (1 − F(wo·h)) D(h) G / (η<sub>t</sub> wi·h + η<sub>o</sub> wo·h)², only
 *     if wo·h &gt; 0 and wi·h &lt; 0;</li>
 * <li>G = min(1, 2 (n·h) co / |wo·h|, 2 (n·h) ci / |wi·h|).</li>
 * </ul>
 * A polished distribution leaves an {@link IdealDielectric}.
 *
 * <p><img src="doc-files/TransmissiveCookTorrance.png" width="320" height="240" alt="A glass ball with soft highlights">
 *
 * <p>Sources: Walter, Marschner, Li and Torrance, "Microfacet models for refraction through rough surfaces", EGSR 2007,
 * equations 16, 20 and 21; G of Cook and Torrance, "A reflectance model for computer graphics", ACM Transactions on Graphics
 * 1(1), 1982; ideal rays beside lobes as in Whitted, "An improved illumination model for shaded display", Communications of
 * the ACM 23(6), 1980.
 */
public final class TransmissiveCookTorrance extends BTDF {

  private final Microfacets microfacets;

  /**
   * A rough surface between two transparent media.
   *
   * @param dielectric k, the part of the light that is not absorbed at the surface; null for none, which looks black
   * @param eta_int index of refraction inside, &gt; 0
   * @param eta_ext index of refraction outside, &gt; 0
   * @param ndf distribution of the microfacets; null for a polished surface
   * @throws IllegalArgumentException if an index is not positive or not finite
   */
  public TransmissiveCookTorrance(final ReflectanceRGB dielectric, final float eta_int, final float eta_ext,
      final NormalDistributionFunction ndf) {
    super(dielectric, eta_int, eta_ext);
    this.microfacets = new Microfacets(ndf);
  }

  @Override
  public boolean scatters() {
    return !microfacets.arePolished() && factor().largest() > 0;
  }

  @Override
  public boolean transmits() {
    return scatters();
  }

  @Override
  public void scatter(final SurfaceInteraction interaction) {
    double f = 0;
    if (scatters() && interaction.cosineOut() > 0) {
      if (interaction.cosineIn() > 0) {
        f = reflection(interaction);
      } else if (interaction.cosineIn() < 0) {
        f = transmission(interaction, ratio(interaction.outside()));
      }
    }
    interaction.scatter(f * factor().r(), f * factor().g(), f * factor().b());
  }

  private double reflection(final SurfaceInteraction interaction) {
    final double c = Math.min(1, Microfacets.halfwayCosine(interaction));
    return getReflectance(c, interaction.outside()) * microfacets.cavityLobe(interaction, c);
  }

  /** With all indices divided by η<sub>t</sub>: s = wi + r wo, whose square is the denominator of the formula. */
  private double transmission(final SurfaceInteraction interaction, final double r) {
    final double ns = interaction.cosineIn() + r * interaction.cosineOut(), s2 = interaction.length2(1, r);
    final double s = Math.copySign(Math.sqrt(s2), ns), between = interaction.cosineBetween();
    final double nh = ns / s, ho = (between + r) / s, hi = (1 + r * between) / s;
    if (!(ho > 0 && hi < 0)) {
      return 0;
    }
    final double refracted = Fresnel.refractedCosine(Math.min(1, ho), r);
    final double passing = 1 - Fresnel.reflectance(Math.min(1, ho), r, refracted);
    return -hi * ho * r * r * passing * microfacets.density(interaction, 1, r, nh, s2)
        * Microfacets.masking(interaction, nh, -hi, ho) / s2;
  }

  @Override
  public String toString() {
    return "TransmissiveCookTorrance(" + media() + ", " + microfacets + ")";
  }
}
