package materials;

/** The fraction of light that a material scatters to a viewer, ∫ f |n·wi| dωi, by two quadratures. */
final class Albedo {

  private static final int RINGS = 600;
  private static final int SECTORS = 96;

  private Albedo() {
  }

  /**
   * By the midpoint rule in rings of equal angle and in sectors, over one side of the surface.
   *
   * @param theta angle of the viewer in radians
   * @param side 1 for the viewer's side, −1 for the other
   * @param rings number of rings; twice as many sectors
   */
  static double[] ofSide(final Material material, final double theta, final boolean outside, final int side,
      final int rings) {
    final SurfaceInteraction interaction = view(theta, outside);
    final double[] sum = new double[3];
    for (int i = 0; i < rings; i++) {
      final double t = Math.PI / 2 * (i + 0.5) / rings, cosine = Math.cos(t), sine = Math.sin(t);
      for (int j = 0; j < 2 * rings; j++) {
        final double phi = Math.PI * (j + 0.5) / rings;
        interaction.setIncident(sine * Math.cos(phi), sine * Math.sin(phi), side * cosine);
        add(material, interaction, sine * cosine * Math.PI / 2 / rings * Math.PI / rings, sum);
      }
    }
    return sum;
  }

  /**
   * Of a reflecting lobe, however narrow: over the half vectors, in rings that grow exponentially about the normal. An area
   * of half vectors is 1 / (4c) of that of directions.
   */
  static double[] ofLobe(final Material material, final double theta) {
    final SurfaceInteraction interaction = view(theta, true);
    final double[] sum = new double[3];
    final double ox = Math.sin(theta), oz = Math.cos(theta);
    for (int i = 0; i < RINGS; i++) {
      final double low = ring(i), high = ring(i + 1), t = (low + high) / 2;
      for (int j = 0; j < SECTORS; j++) {
        final double phi = 2 * Math.PI * (j + 0.5) / SECTORS;
        final double hx = Math.sin(t) * Math.cos(phi), hy = Math.sin(t) * Math.sin(phi), hz = Math.cos(t);
        final double c = hx * ox + hz * oz, x = 2 * c * hx - ox, y = 2 * c * hy, z = 2 * c * hz - oz;
        if (c > 0 && z > 0) {
          interaction.setIncident(x, y, z);
          add(material, interaction, z * 4 * c * Math.sin(t) * (high - low) * 2 * Math.PI / SECTORS, sum);
        }
      }
    }
    return sum;
  }

  private static double ring(final int i) {
    final double growth = 12;
    return Math.PI / 2 * Math.expm1(growth * i / RINGS) / Math.expm1(growth);
  }

  private static SurfaceInteraction view(final double theta, final boolean outside) {
    final SurfaceInteraction interaction = new SurfaceInteraction();
    interaction.setView(0, 0, 1, Math.sin(theta), 0, Math.cos(theta), outside);
    interaction.setIrradiance(1, 1, 1);
    return interaction;
  }

  private static void add(final Material material, final SurfaceInteraction interaction, final double weight,
      final double[] sum) {
    material.scatter(interaction);
    sum[0] += weight * interaction.radianceR();
    sum[1] += weight * interaction.radianceG();
    sum[2] += weight * interaction.radianceB();
  }
}
