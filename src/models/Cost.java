package models;

import static arguments.Arguments.notNull;

import tracer.Ray;

/**
 * What it costs to find out what one ray meets: the number of objects that are asked, without those that the tree of
 * their boxes leaves out; of a mesh, the number of its triangles that are tested; of an object that is marched to, the
 * number of steps of its {@link SphereTrace}.
 *
 * <p>This is a matter of looking closer. It asks the question anew and counts; no other question is slowed down by it. In
 * an image, rays that are close together are traced together, and share some of this work.
 */
public final class Cost {

  private Cost() {
  }

  /**
   * The cost of one question.
   *
   * @param object what is asked, a whole scene for example
   * @param ray the ray; {@link Ray#NORAY} costs nothing
   * @return number of tests and steps, at least 0
   * @throws IllegalArgumentException if an argument is null
   */
  public static int of(final Object3D object, final Ray ray) {
    notNull("object", object);
    return notNull("ray", ray) == Ray.NORAY ? 0 : object.cost(ray);
  }
}
