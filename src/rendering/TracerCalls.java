package rendering;

import static arguments.Arguments.notNull;

import java.awt.Color;

import arguments.Messages;
import lights.Incidence;
import lights.Light;
import materials.Material;
import materials.SpecularRays;
import materials.SurfaceInteraction;
import models.Group3D;
import models.Object3D;
import primitives.Point3D;
import tracer.Hit;
import tracer.Ray;

/**
 * Calls of the lights, materials and objects of a scene, some of which may be user-written: their exceptions become a
 * {@link TracingFailure} with the ray. One for each thread.
 */
final class TracerCalls {

  private final Group3D scene;
  private final MatteMaterials matte = new MatteMaterials();

  TracerCalls(final Group3D scene) {
    this.scene = scene;
  }

  Hit closestHit(final Ray ray) {
    try {
      return scene.intersectionWith(ray);
    } catch (RuntimeException | StackOverflowError failure) {
      throw TracingFailure.ofScene(ray, failure);
    }
  }

  boolean isBlocked(final Ray shadowRay, final double distance) {
    try {
      return scene.intersectAny(shadowRay, distance);
    } catch (RuntimeException | StackOverflowError failure) {
      throw TracingFailure.ofScene(shadowRay, failure);
    }
  }

  /** The material of the object that a ray hits; if it has none, a matte one of its colour there. */
  Material material(final Ray ray, final Hit hit) {
    final Object3D object = hit.getObject();
    final Material material = object.getMaterial();
    if (material != null) {
      return material;
    }
    try {
      final Color color = object.getColorAt(hit);
      return matte.of(notNull("color", color));
    } catch (RuntimeException | StackOverflowError failure) {
      throw TracingFailure.of(object, "getColorAt", ray, failure);
    }
  }

  boolean illuminate(final Light light, final Ray ray, final Hit hit, final Incidence incidence) {
    final double x = hit.pointX(), y = hit.pointY(), z = hit.pointZ();
    try {
      return light.illuminate(x, y, z, incidence);
    } catch (RuntimeException | StackOverflowError failure) {
      final boolean positionFails = failure instanceof IllegalStateException && isPositionAtFault(light, x, y, z);
      throw TracingFailure.of(light, positionFails ? "getPosition" : "getIrradianceAt", ray, failure);
    }
  }

  /** Whether a light that cannot illuminate a point has an irradiance there, so that its position is what is missing. */
  private static boolean isPositionAtFault(final Light light, final double x, final double y, final double z) {
    try {
      return light.getIrradianceAt(new Point3D((float) x, (float) y, (float) z)) != null;
    } catch (RuntimeException | StackOverflowError irradianceFails) {
      return false;
    }
  }

  void scatter(final Material material, final Ray ray, final SurfaceInteraction interaction) {
    try {
      material.scatter(interaction);
      check(interaction);
    } catch (RuntimeException | StackOverflowError failure) {
      throw TracingFailure.of(material, "reflect", ray, failure);
    }
  }

  /** Rejects a radiance that is negative or not finite. */
  static void check(final SurfaceInteraction interaction) {
    final double sr = interaction.radianceR(), sg = interaction.radianceG(), sb = interaction.radianceB();
    if (!(sr >= 0 && sg >= 0 && sb >= 0 && sr + sg + sb < Double.POSITIVE_INFINITY)) {
      throw new IllegalStateException(Messages.text("rendering.wrongRadiance", sr, sg, sb));
    }
  }

  /** Computes the factors of the ideal rays; false if the material reflects and refracts none. */
  boolean findSpecular(final Material material, final Ray ray, final double cosine, final boolean outside,
      final SpecularRays specular) {
    try {
      return material.specular(Math.max(0, Math.min(1, cosine)), outside, specular);
    } catch (RuntimeException | StackOverflowError failure) {
      throw TracingFailure.of(material, "mirror", ray, failure);
    }
  }
}
