package materials;

import radiometry.ReflectanceRGB;

/**
 * A rough surface of microfacets that mirror and shade each other: f = k<sub>d</sub>/π + F · D(h) G / (4 ci co), with F
 * = k<sub>s</sub> + (1 − k<sub>d</sub> − k<sub>s</sub>)(1 − c)⁵ and G = min(1, 2 (n·h) co / c, 2 (n·h) ci / c); h is
 * the half vector of wi and wo, c = wo·h, ci = n·wi and co = n·wo. What the diffuse part takes is not reflected twice.
 * With a polished distribution the lobe is ideal reflection with the factor F at c = co.
 *
 * <p><img src="doc-files/ReflectiveCookTorrance.png" width="320" height="240" alt="A ball of rough copper">
 *
 * <p>Sources: Cook and Torrance, "A reflectance model for computer graphics", ACM Transactions on Graphics 1(1), 1982,
 * with 4 in place of π by Walter et al., "Microfacet models for refraction through rough surfaces", EGSR 2007, equation
 * 20; F by Schlick, "An inexpensive BRDF model for physically-based rendering", Eurographics 1994; that G conserves
 * energy for every distribution by Heitz, "Understanding the masking-shadowing function in microfacet-based BRDFs",
 * JCGT 3(2), 2014.
 */
public final class ReflectiveCookTorrance extends DiffuseSpecular {

  private final ReflectanceRGB diffuse;
  private final ReflectanceRGB specular;

  /**
   * A surface of microfacets. The sum of both reflectances is at most 1 in each channel.
   *
   * @param diffuse k<sub>d</sub>; null for none
   * @param specular k<sub>s</sub>, the specular reflectance at normal incidence; null for none
   * @param ndf distribution of the microfacets; null for a polished surface
   * @throws IllegalArgumentException if both reflectances are null or black, or if their sum exceeds 1 in a channel
   */
  public ReflectiveCookTorrance(final ReflectanceRGB diffuse, final ReflectanceRGB specular,
      final NormalDistributionFunction ndf) {
    super(Channels.of(diffuse).times(1 / Math.PI), Channels.of(specular),
        Channels.of(diffuse).plus(Channels.of(specular)).rest(), ndf, StandIn.of(diffuse, specular));
    Energy.check(diffuse, specular);
    this.diffuse = diffuse;
    this.specular = specular;
  }

  @Override
  double lobe(final Microfacets facets, final SurfaceInteraction interaction, final double c) {
    return facets.cavityLobe(interaction, c);
  }

  @Override
  public String toString() {
    return "ReflectiveCookTorrance(" + diffuse + ", " + specular + ", " + distribution() + ")";
  }
}
