package materials;

import static arguments.Arguments.wrongState;

import primitives.Vector3D;
import radiometry.RadianceRGB;
import radiometry.ReflectanceRGB;

/**
 * A bidirectional reflectance distribution function f(wi, wo), in 1/sr: a surface that reflects light on the viewer's
 * side. A new kind extends this class and implements {@link #reflect}: see {@link materials}.
 *
 * <p>A physical f is reciprocal, f(wi, wo) = f(wo, wi), and reflects no more than it receives: ∫ f(wi, wo) n·wi dωi ≤ 1.
 */
public abstract class BRDF extends Material {

  /** A BRDF. */
  protected BRDF() {
    // All that a material has is in its class.
  }

  /**
   * The radiance reflected in one direction of light that arrives from another: f(wi, wo) times the irradiance on the
   * surface.
   *
   * @param irradiance on the surface, that is, with the cosine n·wi included
   * @param wi unit vector towards the light, n·wi &gt; 0
   * @param wo unit vector towards the viewer, n·wo &gt; 0
   * @param n unit normal on the viewer's side
   * @return the radiance; never null
   */
  public abstract RadianceRGB reflect(RadianceRGB irradiance, Vector3D wi, Vector3D wo, Vector3D n);

  /**
   * Factor of the ideal reflection: the fraction of the radiance from the mirrored direction that is seen in the surface.
   *
   * @param cosine n·wo, from 0 to 1
   * @return the factor at that angle; null, as by default, for none
   */
  public ReflectanceRGB mirror(final double cosine) {
    return null;
  }

  /** {@inheritDoc} The default calls {@link #reflect}. */
  @Override
  public void scatter(final SurfaceInteraction interaction) {
    interaction.setRadiance(0, 0, 0);
    final Vector3D wi = interaction.incident(), wo = interaction.outgoing(), n = interaction.normal();
    if (n.dot(wi) > 0 && n.dot(wo) > 0) {
      final RadianceRGB radiance = reflect(interaction.irradiance(), wi, wo, n);
      if (radiance == null) {
        throw wrongState("nullResult", getClass().getName(), "reflect");
      }
      interaction.setRadiance(radiance.getR(), radiance.getG(), radiance.getB());
    }
  }

  /** {@inheritDoc} The default calls {@link #mirror}. */
  @Override
  public boolean specular(final double cosine, final boolean outside, final SpecularRays rays) {
    final ReflectanceRGB factor = mirror(cosine);
    if (factor == null) {
      return false;
    }
    rays.reflect(factor.getR(), factor.getG(), factor.getB());
    rays.refractNothing();
    return true;
  }
}
