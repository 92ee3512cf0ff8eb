package materials;

import java.awt.Color;

import primitives.Vector3D;
import radiometry.RadianceRGB;
import radiometry.ReflectanceRGB;

/**
 * The form that all BRDFs of this package share: a diffuse part, and a specular part that is a lobe of microfacets or,
 * for a polished surface, ideal reflection. In each channel
 *
 * <p>f = diffuse · {@link #diffuse} + (specular + edge · (1 − c)⁵) · {@link #lobe}, c = wo·h.
 *
 * <p>A part whose coefficient is 0 in all channels is left out.
 */
abstract class DiffuseSpecular extends BRDF {

  private final Channels diffuse;
  private final Channels specular;
  private final Channels edge;
  private final boolean hasSpecular;
  private final boolean hasDiffuse;
  private final Microfacets microfacets;
  private final Color color;

  /**
   * Coefficients and microfacets.
   *
   * @param diffuse coefficient of the diffuse part
   * @param specular reflectance of the specular part at normal incidence
   * @param edge its increase towards grazing directions
   * @param ndf distribution of microfacets; null for a polished surface
   * @param color colour of the material where there is no illumination
   */
  DiffuseSpecular(final Channels diffuse, final Channels specular, final Channels edge, final NormalDistributionFunction ndf,
      final Color color) {
    this.diffuse = diffuse;
    this.specular = specular;
    this.edge = edge;
    this.hasDiffuse = diffuse.largest() > 0;
    this.hasSpecular = specular.largest() > 0;
    this.microfacets = new Microfacets(ndf);
    this.color = color;
  }

  /** The geometric factor of the diffuse part; by default 1, as for Lambert. */
  double diffuse(final SurfaceInteraction interaction) {
    return 1;
  }

  /** The geometric factor of the lobe, without its Fresnel factor. */
  double lobe(final Microfacets facets, final SurfaceInteraction interaction, final double c) {
    return facets.mirroredDensity(interaction, c);
  }

  @Override
  public final Color getColor() {
    return color;
  }

  @Override
  public final boolean scatters() {
    return hasDiffuse || hasLobe();
  }

  private boolean hasLobe() {
    return hasSpecular && !microfacets.arePolished();
  }

  @Override
  public final RadianceRGB reflect(final RadianceRGB irradiance, final Vector3D wi, final Vector3D wo, final Vector3D n) {
    final SurfaceInteraction interaction = new SurfaceInteraction(irradiance, wi, wo, n, true);
    scatter(interaction);
    return interaction.radiance();
  }

  @Override
  public final void scatter(final SurfaceInteraction interaction) {
    if (!(interaction.cosineIn() > 0 && interaction.cosineOut() > 0)) {
      interaction.setRadiance(0, 0, 0);
      return;
    }
    double f = hasDiffuse ? diffuse(interaction) : 0, r = f * diffuse.r(), g = f * diffuse.g(), b = f * diffuse.b();
    if (hasLobe()) {
      final double c = Microfacets.halfwayCosine(interaction), rise = Fresnel.schlick(c);
      f = lobe(microfacets, interaction, c);
      r += f * (specular.r() + edge.r() * rise);
      g += f * (specular.g() + edge.g() * rise);
      b += f * (specular.b() + edge.b() * rise);
    }
    interaction.scatter(r, g, b);
  }

  @Override
  public final ReflectanceRGB mirror(final double cosine) {
    final SpecularRays rays = new SpecularRays();
    return !specular(cosine, true, rays) ? null
        : new ReflectanceRGB((float) rays.reflectedR(), (float) rays.reflectedG(), (float) rays.reflectedB());
  }

  @Override
  public final boolean specular(final double cosine, final boolean outside, final SpecularRays rays) {
    if (!hasSpecular || !microfacets.arePolished()) {
      return false;
    }
    final double rise = Fresnel.schlick(cosine);
    rays.reflect(Math.min(1, specular.r() + edge.r() * rise), Math.min(1, specular.g() + edge.g() * rise),
        Math.min(1, specular.b() + edge.b() * rise));
    rays.refractNothing();
    return true;
  }

  /** Distribution of the microfacets, for {@code toString}. */
  final String distribution() {
    return microfacets.toString();
  }
}
