package materials;

import radiometry.ReflectanceRGB;

/**
 * A matte surface below a glossy coat, where what the coat reflects is missing below: f = 28/(23π) · k<sub>d</sub>(1 −
 * k<sub>s</sub>) · (1 − (1 − ci/2)⁵)(1 − (1 − co/2)⁵) + F · D(h) (n·h) / (4 c max(ci, co)), with F = k<sub>s</sub> + (1 −
 * k<sub>s</sub>)(1 − c)⁵; h is the half vector of wi and wo, c = wo·h, ci = n·wi and co = n·wo. With a polished distribution
 * the lobe is ideal reflection with the factor F at c = co.
 *
 * <p><img src="doc-files/AshikhminShirley.png" width="320" height="240" alt="A lacquered ball">
 *
 * <p>Source: Ashikhmin and Shirley, "An anisotropic Phong BRDF model", Journal of Graphics Tools 5(2), 2000, without
 * anisotropy, D(h) (n·h) being their density of h.
 */
public final class AshikhminShirley extends DiffuseSpecular {

  private final ReflectanceRGB diffuse;
  private final ReflectanceRGB specular;

  /**
   * A matte surface below a glossy coat.
   *
   * @param diffuse k<sub>d</sub>, not black
   * @param specular k<sub>s</sub>, the specular reflectance at normal incidence, not black
   * @param ndf distribution of the microfacets; null for a polished surface
   * @throws IllegalArgumentException if a reflectance is null or black
   */
  public AshikhminShirley(final ReflectanceRGB diffuse, final ReflectanceRGB specular,
      final NormalDistributionFunction ndf) {
    super(Channels.of(Energy.notBlack("diffuse", diffuse)).times(28 / (23 * Math.PI)).times(Channels.of(specular).rest()),
        Channels.of(Energy.notBlack("specular", specular)), Channels.of(specular).rest(), ndf,
        StandIn.of(diffuse, specular));
    this.diffuse = diffuse;
    this.specular = specular;
  }

  @Override
  double diffuse(final SurfaceInteraction interaction) {
    return (1 - Fresnel.schlick(interaction.cosineIn() / 2)) * (1 - Fresnel.schlick(interaction.cosineOut() / 2));
  }

  @Override
  public String toString() {
    return "AshikhminShirley(" + diffuse + ", " + specular + ", " + distribution() + ")";
  }
}
