package primitives;

import javax.vecmath.Vector3f;

/**
 * A vector of space in scene units: a {@link Vector3f} under the name that the assignment gives it.
 *
 * <p>Vectors are mutable, as all tuples of vecmath are. The classes of this project copy the vectors that they
 * are given and return copies.
 */
public class Vector3D extends Vector3f {

  private static final long serialVersionUID = 1L;

  /** The zero vector. */
  public Vector3D() {
    super();
  }

  /**
   * The vector of the given components.
   *
   * @param x first component
   * @param y second component
   * @param z third component
   */
  public Vector3D(final float x, final float y, final float z) {
    super(x, y, z);
  }

  /**
   * A copy.
   *
   * @param v vector to be copied
   * @throws IllegalArgumentException if v is null
   */
  public Vector3D(final Vector3D v) {
    super(arguments.Arguments.notNull("v", v));
  }
}
