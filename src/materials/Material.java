package materials;

import java.awt.Color;

/**
 * What a surface does to light: a {@link BRDF} reflects it, a {@link BTDF} also transmits it. Immutable, and called by
 * several threads concurrently.
 *
 * <p>The methods other than {@link #getColor} are for renderers: they compute in double and, for the materials of this
 * package, allocate nothing. A user-written material extends {@link BRDF} and need not know them.
 */
public abstract class Material {

  private static final Color LIGHT_GREY = new Color(204, 204, 204);

  /** A material. */
  protected Material() {
    // All that a material has is in its class.
  }

  /**
   * The colour of the material where there is no illumination.
   *
   * @return a colour; by default light grey
   */
  public Color getColor() {
    return LIGHT_GREY;
  }

  /**
   * Whether lights are seen on the surface, so that it is worthwhile to look for them. They are not on a perfect mirror
   * or on clear glass, whose rays never hit a point light.
   *
   * @return true if {@link #scatter} can return radiance; by default true
   */
  public boolean scatters() {
    return true;
  }

  /**
   * Whether lights behind the surface count as well as those in front of it.
   *
   * @return true if {@link #scatter} can return radiance for a direction with n·wi &lt; 0; by default false
   */
  public boolean transmits() {
    return false;
  }

  /**
   * Writes the radiance that goes to the viewer because of light from one direction, f(wi, wo) times the irradiance on the
   * surface.
   *
   * @param interaction the directions and the irradiance, and what the radiance is written to
   * @throws IllegalStateException if a user-written material returns null
   */
  public abstract void scatter(SurfaceInteraction interaction);

  /**
   * Writes the factors of ideal reflection and ideal refraction.
   *
   * @param cosine n·wo, the cosine of the viewer's direction, from 0 to 1
   * @param outside whether the viewer is on the side of the surface's own normal
   * @param rays what the factors are written to
   * @return false if there is neither, whatever was written
   */
  public abstract boolean specular(double cosine, boolean outside, SpecularRays rays);
}
