package materials;

import radiometry.ReflectanceRGB;

/**
 * A matte surface with a highlight that conserves energy: f = k<sub>d</sub>/π + k<sub>s</sub> · D(h) (n·h) / (4 c
 * max(ci, co)), with h the half vector of wi and wo, c = wo·h, ci = n·wi and co = n·wo. There is no Fresnel effect.
 * With a polished distribution the highlight is ideal reflection with the factor k<sub>s</sub>.
 *
 * <p><img src="doc-files/PhongLafortune.png" width="320" height="240" alt="A red ball with highlights">
 *
 * <p>Sources: Lafortune and Willems, "Using the modified Phong reflectance model for physically based rendering", KU Leuven
 * CW197, 1994, whose lobe is expressed by h here; its density by Walter et al., "Microfacet models for refraction through
 * rough surfaces", EGSR 2007, equations 14 and 24; its denominator by Neumann, Neumann and Szirmay-Kalos, "Compact metallic
 * reflectance models", Eurographics 1999.
 */
public final class PhongLafortune extends DiffuseSpecular {

  private final ReflectanceRGB diffuse;
  private final ReflectanceRGB specular;

  /**
   * A matte surface with a highlight. The sum of both reflectances is at most 1 in each channel.
   *
   * @param diffuse k<sub>d</sub>; null for none
   * @param specular k<sub>s</sub>; null for none
   * @param ndf distribution of the microfacets; null for a polished surface
   * @throws IllegalArgumentException if both reflectances are null or black, or if their sum exceeds 1 in a channel
   */
  public PhongLafortune(final ReflectanceRGB diffuse, final ReflectanceRGB specular, final NormalDistributionFunction ndf) {
    super(Channels.of(diffuse).times(1 / Math.PI), Channels.of(specular), Channels.ZERO, ndf, StandIn.of(diffuse, specular));
    Energy.check(diffuse, specular);
    this.diffuse = diffuse;
    this.specular = specular;
  }

  @Override
  public String toString() {
    return "PhongLafortune(" + diffuse + ", " + specular + ", " + distribution() + ")";
  }
}
