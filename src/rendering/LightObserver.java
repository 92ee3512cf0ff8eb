package rendering;

import lights.Light;
import materials.Material;
import primitives.Vector3D;
import radiometry.RadianceRGB;
import tracer.Hit;
import tracer.Ray;

/**
 * Observes how {@link Illumination} computes the radiance of one ray: the surfaces that it and the rays made there hit, what
 * each light contributes, and why a branch ends. All numbers are those of the picture. A ray that is followed is announced
 * by {@link #specular} and reported later, as the same object, by {@link #surface} or {@link #background}.
 */
public interface LightObserver {

  /** Observes nothing. */
  LightObserver NONE = new LightObserver() {
  };

  /**
   * A ray hits a surface. Its lights and the rays that leave it are reported next.
   *
   * @param ray the ray
   * @param hit the hit
   * @param depth depth of the ray, 0 for the ray of the pixel
   * @param weight product of the factors on the way from the pixel
   * @param material the material; a matte one of its colour for an object without
   * @param normal the shading normal on the viewer's side
   * @param isOutside whether the viewer is on the side of the surface's own normal
   */
  record Surface(Ray ray, Hit hit, int depth, RadianceRGB weight, Material material, Vector3D normal, boolean isOutside) {
  }

  /** What becomes of a light at a surface. */
  enum Outcome {
    /** It contributes radiance. */
    LIT,
    /** An object lies between. */
    BLOCKED,
    /** The point is outside the field of the light. */
    OUTSIDE_FIELD,
    /** The light is behind the surface. */
    BEHIND,
    /** The material sends none of it along the ray. */
    NOT_REFLECTED
  }

  /**
   * A light at a surface. If lit, radiance = weight · f · cosine · irradiance in each channel.
   *
   * @param light the light
   * @param number its number among the lights, from 0
   * @param outcome what becomes of it
   * @param irradiance its irradiance perpendicular to the direction of incidence
   * @param cosine cosine of incidence, |n·wi|
   * @param reflected f · cosine · irradiance, before weight and shadow
   * @param radiance what it contributes to the pixel, or would if it were not blocked
   * @param shadowRay the ray from the surface to the light; {@link Ray#NORAY} if none is traced
   * @param distance distance of the light along that ray
   */
  record Contribution(Light light, int number, Outcome outcome, RadianceRGB irradiance, double cosine,
      RadianceRGB reflected, RadianceRGB radiance, Ray shadowRay, double distance) {
  }

  /** What becomes of an ideally reflected or refracted ray. */
  enum Fate {
    /** It is traced. */
    FOLLOWED,
    /** It would exceed the recursion depth. */
    TOO_DEEP,
    /** Its weight is negligible. */
    NEGLIGIBLE,
    /** There is no refracted ray: reflection is total. */
    TOTAL_REFLECTION
  }

  /**
   * An ideally reflected or refracted ray.
   *
   * @param ray the ray; {@link Ray#NORAY} unless it is followed
   * @param isRefracted whether it is the refracted ray
   * @param factor its factor, which includes the Fresnel reflectance or transmittance
   * @param fate what becomes of it
   */
  record Specular(Ray ray, boolean isRefracted, RadianceRGB factor, Fate fate) {
  }

  /**
   * A ray hits a surface.
   *
   * @param surface the surface
   */
  default void surface(final Surface surface) {
  }

  /**
   * A light is examined at the surface reported last.
   *
   * @param contribution what it contributes
   */
  default void light(final Contribution contribution) {
  }

  /**
   * An ideal ray leaves the surface reported last.
   *
   * @param specular the ray
   */
  default void specular(final Specular specular) {
  }

  /**
   * A ray leaves the scene and brings the background.
   *
   * @param ray the ray
   * @param depth its depth
   * @param radiance what it contributes to the pixel
   */
  default void background(final Ray ray, final int depth, final RadianceRGB radiance) {
  }
}
