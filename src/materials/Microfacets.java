package materials;

/**
 * The reflecting lobes of a distribution of microfacets, without their Fresnel factor. With s = wi + wo, h = s / |s| and
 * c = wo·h = wi·h = |s| / 2.
 */
final class Microfacets {

  private final NormalDistributionFunction ndf;

  /** The microfacets of a distribution; null for a polished surface. */
  Microfacets(final NormalDistributionFunction ndf) {
    this.ndf = ndf;
  }

  /** Whether the lobe is replaced by ideal reflection. */
  boolean arePolished() {
    return ndf == null || ndf.isPolished();
  }

  /** The cosine c of wi and wo to the half vector between them. */
  static double halfwayCosine(final SurfaceInteraction interaction) {
    return Math.sqrt(interaction.length2(1, 1)) / 2;
  }

  /**
   * The density of mirrored directions, D(h) (n·h) / (4c), over max(ci, co). Sources: Walter et al., "Microfacet models
   * for refraction through rough surfaces", EGSR 2007, equations 14 and 24; Neumann, Neumann and Szirmay-Kalos,
   * "Compact metallic reflectance models", Eurographics 1999.
   */
  double mirroredDensity(final SurfaceInteraction interaction, final double c) {
    final double ci = interaction.cosineIn(), co = interaction.cosineOut(), nh = (ci + co) / (2 * c);
    return density(interaction, 1, 1, nh, 4 * c * c) * nh / (4 * c * Math.max(ci, co));
  }

  /**
   * D(h) G / (4 ci co) with the masking of V-shaped cavities, G = min(1, 2 (n·h) co / c, 2 (n·h) ci / c). Source: Cook and
   * Torrance, "A reflectance model for computer graphics", ACM Transactions on Graphics 1(1), 1982.
   */
  double cavityLobe(final SurfaceInteraction interaction, final double c) {
    final double nh = (interaction.cosineIn() + interaction.cosineOut()) / (2 * c);
    return density(interaction, 1, 1, nh, 4 * c * c) * masking(interaction, nh, c, c) / 4;
  }

  /** D of the direction h of a wi + b wo, given n·h and the squared length of that sum. */
  double density(final SurfaceInteraction interaction, final double a, final double b, final double nh,
      final double length2) {
    return nh > 0 ? ndf.density(Math.min(1, nh), Math.min(1, interaction.cross2(a, b) / length2)) : 0;
  }

  /** G / (ci co), in a form that stays finite towards grazing directions: the cosines of wi and wo to h are given. */
  static double masking(final SurfaceInteraction interaction, final double nh, final double hi, final double ho) {
    final double ci = Math.abs(interaction.cosineIn()), co = interaction.cosineOut();
    return Math.min(1 / (ci * co), Math.min(2 * nh / (ci * ho), 2 * nh / (co * hi)));
  }

  @Override
  public String toString() {
    return String.valueOf(ndf);
  }
}
