package inspection;

import static arguments.Arguments.notNull;

import java.util.ArrayList;
import java.util.List;

import javax.vecmath.Vector3d;

import materials.Material;
import materials.SpecularRays;
import materials.SurfaceInteraction;
import radiometry.RadianceRGB;

/**
 * The BRDF of a material for one direction of incidence, over the outgoing directions in the plane of incidence.
 *
 * @param incidence angle of incidence in degrees, 0 … 90; the light is at −incidence
 * @param values the BRDF at the angles −90 … 90 degrees from the normal, in equal steps
 * @param albedo part of the irradiance that is reflected, an ideal reflection included
 */
public record BrdfSlice(double incidence, List<RadianceRGB> values, RadianceRGB albedo) {

  private static final int STEPS = 720;
  private static final int RINGS = 240;
  private static final int SECTORS = 96;

  /**
   * Copies the list.
   *
   * @param incidence angle of incidence in degrees
   * @param values the BRDF at equally spaced angles
   * @param albedo part of the irradiance that is reflected
   */
  public BrdfSlice {
    values = List.copyOf(values);
  }

  /**
   * Evaluates a material.
   *
   * @param material the material
   * @param cosine cosine of incidence, 0 … 1
   * @param outside whether the light is on the side of the surface's own normal
   * @return its values
   * @throws IllegalArgumentException if the material is null
   */
  public static BrdfSlice of(final Material material, final double cosine, final boolean outside) {
    notNull("material", material);
    final double theta = Math.acos(Math.max(0, Math.min(1, cosine)));
    final SurfaceInteraction interaction = new SurfaceInteraction();
    final List<RadianceRGB> values = new ArrayList<>();
    for (int i = 0; i <= STEPS; i++) {
      final double angle = Math.PI * ((double) i / STEPS - 0.5);
      values.add(value(material, interaction, theta, new Vector3d(Math.sin(angle), 0, Math.cos(angle)), outside));
    }
    return new BrdfSlice(Math.toDegrees(theta), values, albedo(material, interaction, theta, outside));
  }

  /** The BRDF for light from (−sin θ, 0, cos θ) about the normal (0, 0, 1). */
  private static RadianceRGB value(final Material material, final SurfaceInteraction interaction, final double theta,
      final Vector3d wo, final boolean outside) {
    if (!(wo.z > 0) || !material.scatters()) {
      return RadianceRGB.NORADIANCE;
    }
    interaction.setView(0, 0, 1, wo.x, wo.y, wo.z, outside);
    interaction.setIncident(-Math.sin(theta), 0, Math.cos(theta));
    interaction.setIrradiance(1, 1, 1);
    material.scatter(interaction);
    return new RadianceRGB(interaction.radianceR(), interaction.radianceG(), interaction.radianceB());
  }

  /** Integrates in rings about the mirrored direction, which are narrow where a lobe may be: ψ = π u⁴. */
  private static RadianceRGB albedo(final Material material, final SurfaceInteraction interaction, final double theta,
      final boolean outside) {
    RadianceRGB sum = ideal(material, Math.cos(theta), outside);
    final double sin = Math.sin(theta), cos = Math.cos(theta);
    for (int i = 0; i < RINGS; i++) {
      final double u = (i + 0.5) / RINGS, psi = Math.PI * Math.pow(u, 4);
      final double ring = 4 * Math.PI * Math.pow(u, 3) / RINGS * Math.sin(psi) * 2 * Math.PI / SECTORS;
      for (int k = 0; k < SECTORS; k++) {
        final double phi = 2 * Math.PI * (k + 0.5) / SECTORS;
        final double a = Math.sin(psi) * Math.cos(phi), b = Math.sin(psi) * Math.sin(phi), c = Math.cos(psi);
        final Vector3d wo = new Vector3d(a * cos + c * sin, b, -a * sin + c * cos);
        sum = sum.plus(value(material, interaction, theta, wo, outside).times(ring * Math.max(0, wo.z)));
      }
    }
    return sum;
  }

  private static RadianceRGB ideal(final Material material, final double cosine, final boolean outside) {
    final SpecularRays rays = new SpecularRays();
    return material.specular(cosine, outside, rays)
        ? new RadianceRGB(rays.reflectedR(), rays.reflectedG(), rays.reflectedB()) : RadianceRGB.NORADIANCE;
  }
}
