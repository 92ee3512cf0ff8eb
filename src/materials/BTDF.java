package materials;

import static arguments.Arguments.positive;

import java.awt.Color;

import primitives.Vector3D;
import radiometry.RadianceRGB;
import radiometry.ReflectanceRGB;

/**
 * A bidirectional transmittance distribution function: the surface between two transparent media, which reflects one part
 * of the light and refracts the rest. Inside is the side opposite to the surface's own normal. η<sub>o</sub> is the index
 * of refraction on the viewer's side of the surface, η<sub>t</sub> that on the other; each surface has its own two
 * indices, and there is no stack of media.
 *
 * <p>The ideal part is followed by recursion: reflection with the factor k F, refraction with the factor k (1 − F)
 * (η<sub>o</sub>/η<sub>t</sub>)², F being Fresnel's reflectance for unpolarised light. The last term is the change of
 * radiance at an interface, which cancels for light that passes through. Source: Pharr, Jakob and Humphreys, "Physically
 * Based Rendering", 4th edition, 2023, sections 9.3 and 9.5.
 */
public abstract class BTDF extends Material {

  private final ReflectanceRGB dielectric;
  private final Channels k;
  private final float inside;
  private final float outside;
  private final double outsideRatio;
  private final double insideRatio;

  /** A surface with a factor, null for black, and two indices of refraction. */
  BTDF(final ReflectanceRGB dielectric, final float etaInt, final float etaExt) {
    this.dielectric = dielectric;
    this.k = Channels.of(dielectric);
    this.inside = positive("eta_int", etaInt);
    this.outside = positive("eta_ext", etaExt);
    this.outsideRatio = (double) outside / inside;
    this.insideRatio = (double) inside / outside;
  }

  @Override
  public final Color getColor() {
    return StandIn.of(dielectric);
  }

  /**
   * The radiance scattered in one direction of light that arrives from another, on the same side of the surface or on the
   * other: f(wi, wo) times the irradiance on the surface.
   *
   * @param irradiance on the surface, that is, with the cosine |n·wi| included
   * @param wi unit vector towards the light
   * @param wo unit vector towards the viewer, n·wo &gt; 0
   * @param n unit normal on the viewer's side
   * @param isOutside whether the viewer is on the side of the surface's own normal
   * @return the radiance
   * @throws IllegalArgumentException if an argument is null, or if a vector is zero or not finite
   */
  public final RadianceRGB scatter(final RadianceRGB irradiance, final Vector3D wi, final Vector3D wo, final Vector3D n,
      final boolean isOutside) {
    final SurfaceInteraction interaction = new SurfaceInteraction(irradiance, wi, wo, n, isOutside);
    scatter(interaction);
    return interaction.radiance();
  }

  /**
   * Fresnel's reflectance for unpolarised light, without the factor k.
   *
   * @param cosine cosine of the angle between the normal and the direction of the viewer, from 0 to 1
   * @param isOutside whether the viewer is on the side of the surface's own normal
   * @return from 0 to 1; 1 for total reflection
   */
  public final double getReflectance(final double cosine, final boolean isOutside) {
    final double ratio = ratio(isOutside);
    return Fresnel.reflectance(cosine, ratio, Fresnel.refractedCosine(cosine, ratio));
  }

  @Override
  public final boolean specular(final double cosine, final boolean isOutside, final SpecularRays rays) {
    final double ratio = ratio(isOutside), refracted = Fresnel.refractedCosine(Math.min(1, cosine), ratio);
    final double f = Fresnel.reflectance(Math.min(1, cosine), ratio, refracted), rest = (1 - f) * ratio * ratio;
    rays.reflect(k.r() * f, k.g() * f, k.b() * f);
    if (f < 1) {
      rays.refract(k.r() * rest, k.g() * rest, k.b() * rest, ratio, refracted);
    } else {
      rays.refractNothing();
    }
    return k.largest() > 0;
  }

  /** η<sub>o</sub> / η<sub>t</sub>. */
  final double ratio(final boolean isOutside) {
    return isOutside ? outsideRatio : insideRatio;
  }

  /** The factor of all reflected and refracted light. */
  final Channels factor() {
    return k;
  }

  /** The arguments of the constructor, for {@code toString}. */
  final String media() {
    return dielectric + ", " + inside + ", " + outside;
  }
}
