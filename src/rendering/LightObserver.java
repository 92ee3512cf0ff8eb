package rendering;

import lights.Light;
import tracer.Hit;
import tracer.Ray;

/**
 * Watches how {@link Illumination} finds the radiance of one ray: the surfaces that it and the rays made there hit, and what
 * each light brings. Numbers are those that the picture is made of.
 */
public interface LightObserver {

  /** Watches nothing. */
  LightObserver NONE = new LightObserver() {
  };

  /**
   * A ray hits a surface. What the lights bring there comes next.
   *
   * @param ray the ray
   * @param hit the hit
   * @param depth depth of the ray, 0 for the pixel's own
   * @param r product of the factors on the way from the pixel, red
   * @param g green
   * @param b blue
   */
  default void surface(final Ray ray, final Hit hit, final int depth, final double r, final double g, final double b) {
  }

  /**
   * A light sends light to the surface, which reflects or transmits it along the ray.
   *
   * @param light the light
   * @param number its number among the lights, from 0
   * @param shadowRay the ray from the surface to the light
   * @param distance how far the light is along it
   * @param isBlocked whether an object lies between
   * @param r radiance that it brings to the pixel, or would bring if it were not blocked, red
   * @param g green
   * @param b blue
   */
  default void light(final Light light, final int number, final Ray shadowRay, final double distance,
      final boolean isBlocked, final double r, final double g, final double b) {
  }

  /**
   * A ray leaves the scene and brings the background.
   *
   * @param ray the ray
   * @param depth depth of the ray
   * @param r radiance that it brings to the pixel, red
   * @param g green
   * @param b blue
   */
  default void background(final Ray ray, final int depth, final double r, final double g, final double b) {
  }
}
