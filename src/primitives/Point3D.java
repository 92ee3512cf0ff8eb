package primitives;

import javax.vecmath.Point3f;

/**
 * A point of space in scene units: a {@link Point3f} under the name that the assignment gives it.
 *
 * <p>Points are mutable, as all tuples of vecmath are. The classes of this project copy the points that they
 * are given and return copies.
 */
public class Point3D extends Point3f {

  private static final long serialVersionUID = 1L;

  /** The origin. */
  public Point3D() {
    super();
  }

  /**
   * The point of the given coordinates.
   *
   * @param x first coordinate
   * @param y second coordinate
   * @param z third coordinate
   */
  public Point3D(final float x, final float y, final float z) {
    super(x, y, z);
  }

  /**
   * A copy.
   *
   * @param P point to be copied
   * @throws IllegalArgumentException if P is null
   */
  public Point3D(final Point3D P) {
    super(arguments.Arguments.notNull("P", P));
  }
}
