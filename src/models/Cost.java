package models;

import static arguments.Arguments.notNull;

import tracer.Ray;

/**
 * What it costs to find the closest hit of one ray: the number of objects tested, without those that the tree of their
 * boxes culls; of a mesh, the number of triangles tested; of a ray-marched object, the number of steps of its
 * {@link SphereTrace}.
 *
 * <p>For inspection: it traces the ray once more and counts, so that ordinary queries are not slowed down. In an image,
 * neighbouring rays are traced together and share some of this work.
 */
public final class Cost {

  private Cost() {
  }

  /**
   * The cost of one ray.
   *
   * @param object the object, such as a whole scene
   * @param ray the ray; {@link Ray#NORAY} costs nothing
   * @return number of tests and steps, at least 0
   * @throws IllegalArgumentException if an argument is null
   */
  public static int of(final Object3D object, final Ray ray) {
    notNull("object", object);
    return notNull("ray", ray) == Ray.NORAY ? 0 : object.cost(ray);
  }
}
