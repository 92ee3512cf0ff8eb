package inspection;

import java.util.List;
import java.util.Optional;

import models.Object3D;
import primitives.Point3D;
import radiometry.RadianceRGB;
import rendering.LightObserver;
import tracer.Ray;

/**
 * A surface in the tree of a pixel's light, with what its lights contribute and the rays that leave it.
 *
 * @param surface the surface, its ray and the weight of that
 * @param sceneObject the object of the scene that has the surface, such as a mesh or a transformed object
 * @param lights what becomes of each light there
 * @param branches the ideally reflected and refracted rays
 */
public record LightNode(LightObserver.Surface surface, Object3D sceneObject, List<Lamp> lights, List<Branch> branches) {

  /**
   * A light at the surface.
   *
   * @param contribution what it contributes
   * @param blocker the closest object that blocks it; empty unless it is blocked
   */
  public record Lamp(LightObserver.Contribution contribution, Optional<Blocker> blocker) {
  }

  /**
   * An object between a surface and a light.
   *
   * @param object the object
   * @param sceneObject the object of the scene that contains it, or the object itself
   * @param point the point where it blocks the shadow ray
   * @param t distance of that point along the shadow ray
   */
  public record Blocker(Object3D object, Object3D sceneObject, Point3D point, float t) {
  }

  /**
   * A ray that leaves the surface.
   *
   * @param specular the ray, its factor and its fate
   * @param weight product of the factors on the way from the pixel, this one included
   * @param target the surface that it hits; empty if it is not followed or leaves the scene
   * @param background what it contributes if it leaves the scene; empty if it does not
   */
  public record Branch(LightObserver.Specular specular, RadianceRGB weight, Optional<LightNode> target,
      Optional<RadianceRGB> background) {

    /**
     * What the ray contributes to the pixel.
     *
     * @return its radiance, weighted
     */
    public RadianceRGB radiance() {
      return target.map(LightNode::radiance).or(() -> background).orElse(RadianceRGB.NORADIANCE);
    }
  }

  /**
   * Copies the lists.
   *
   * @param surface the surface, its ray and the weight of that
   * @param sceneObject the object of the scene that has the surface
   * @param lights what becomes of each light there
   * @param branches the ideally reflected and refracted rays
   */
  public LightNode {
    lights = List.copyOf(lights);
    branches = List.copyOf(branches);
  }

  /**
   * What the surface and everything seen in it contribute to the pixel.
   *
   * @return the weighted radiance; at the root, up to rounding, that of the pixel
   */
  public RadianceRGB radiance() {
    RadianceRGB sum = RadianceRGB.NORADIANCE;
    for (final Lamp lamp : lights) {
      if (lamp.contribution.outcome() == LightObserver.Outcome.LIT) {
        sum = sum.plus(lamp.contribution.radiance());
      }
    }
    for (final Branch branch : branches) {
      sum = sum.plus(branch.radiance());
    }
    return sum;
  }

  /**
   * The ray that hits the surface.
   *
   * @return the ray
   */
  public Ray ray() {
    return surface.ray();
  }
}
