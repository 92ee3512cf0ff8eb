package tracer;

import static arguments.Arguments.direction;
import static arguments.Arguments.finite;
import static arguments.Arguments.wrong;

import acceleration.RayRounding;
import models.Object3D;
import primitives.Point3D;
import primitives.Vector3D;

/**
 * A ray: the points R + t v, t &gt; 0, of a starting point R and a direction v of unit length, so that the
 * parameter t is the distance from R in scene units.
 *
 * <p>Immutable. Points and vectors are copied on their way in and out. They hold floats; for computations prone to
 * cancellation, the same numbers are available in double and without a copy, the direction normalised again in double
 * ({@link #startX()}, {@link #directionX()} and so on).
 */
public final class Ray {

  /** The absence of a ray: it hits no object, and its accessors return null or NaN. */
  public static final Ray NORAY = exactly(Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN);

  private final double startX;
  private final double startY;
  private final double startZ;
  private final float vx;
  private final float vy;
  private final float vz;
  private final double directionX;
  private final double directionY;
  private final double directionZ;
  private final Object3D left;
  private final double blindness;

  /**
   * The ray that starts at a point and follows a vector.
   *
   * @param R starting point
   * @param v direction, of any length but 0
   * @throws IllegalArgumentException if an argument is null or not finite, or if v is zero
   */
  public Ray(final Point3D R, final Vector3D v) {
    this(finite("R", R), direction("v", v).x, v.y, v.z);
  }

  /**
   * The ray that starts at a point and passes through another.
   *
   * @param R starting point
   * @param Q another point of the ray
   * @throws IllegalArgumentException if an argument is null or not finite, or if Q equals R
   */
  public Ray(final Point3D R, final Point3D Q) {
    this(finite("R", R), (double) other(R, Q).x - R.x, (double) Q.y - R.y, (double) Q.z - R.z);
  }

  private Ray(final Point3D R, final double x, final double y, final double z) {
    this(R.x, R.y, R.z, x, y, z, 1 / Math.sqrt(x * x + y * y + z * z));
    assert Math.abs(directionX * directionX + directionY * directionY + directionZ * directionZ - 1) < 1e-12 : this;
  }

  /** Rounds the scaled direction to floats, and normalises those in double. */
  private Ray(final double startX, final double startY, final double startZ,
      final double x, final double y, final double z, final double scale) {
    this.startX = startX;
    this.startY = startY;
    this.startZ = startZ;
    final double ux = RayRounding.rounded(scale * x), uy = RayRounding.rounded(scale * y),
        uz = RayRounding.rounded(scale * z);
    final double k = RayRounding.toUnit(ux * ux + uy * uy + uz * uz);
    vx = (float) ux;
    vy = (float) uy;
    vz = (float) uz;
    directionX = k * ux;
    directionY = k * uy;
    directionZ = k * uz;
    left = null;
    blindness = 0;
  }

  /** Keeps the direction as it is. */
  private Ray(final double startX, final double startY, final double startZ,
      final double directionX, final double directionY, final double directionZ,
      final Object3D left, final double blindness) {
    this.startX = startX;
    this.startY = startY;
    this.startZ = startZ;
    vx = (float) directionX;
    vy = (float) directionY;
    vz = (float) directionZ;
    this.directionX = directionX;
    this.directionY = directionY;
    this.directionZ = directionZ;
    this.left = left;
    this.blindness = blindness;
  }

  private static Point3D other(final Point3D R, final Point3D Q) {
    if (finite("Q", Q).equals(R)) {
      throw wrong("samePoint", "Q", "R", Q);
    }
    return Q;
  }

  /**
   * The ray of a ray generator, from numbers in double: the start is rounded to floats, the direction to a unit vector of
   * floats. Arguments are not checked: a ray of numbers that are not finite hits nothing.
   *
   * @param startX first coordinate of the starting point
   * @param startY second coordinate of the starting point
   * @param startZ third coordinate of the starting point
   * @param x first component of the direction, of any length but 0
   * @param y second component of the direction
   * @param z third component of the direction
   * @return the ray
   */
  public static Ray towards(final double startX, final double startY, final double startZ,
      final double x, final double y, final double z) {
    return new Ray(RayRounding.rounded(startX), RayRounding.rounded(startY), RayRounding.rounded(startZ), x, y, z,
        1 / Math.sqrt(x * x + y * y + z * z));
  }

  /**
   * The ray of a direction that is a unit vector of floats already: {@link #getDirection()} of another ray. Arguments are
   * not checked.
   *
   * @param startX first coordinate of the starting point
   * @param startY second coordinate of the starting point
   * @param startZ third coordinate of the starting point
   * @param x first component of the direction
   * @param y second component of the direction
   * @param z third component of the direction
   * @return the ray
   */
  public static Ray along(final double startX, final double startY, final double startZ,
      final float x, final float y, final float z) {
    return new Ray(startX, startY, startZ, x, y, z, 1);
  }

  /**
   * The ray of numbers that are not rounded: a ray in the frame of a transformed object. Only the results of its
   * accessors are rounded. Arguments are not checked.
   *
   * @param startX first coordinate of the starting point
   * @param startY second coordinate of the starting point
   * @param startZ third coordinate of the starting point
   * @param x first component of the direction, of unit length in double
   * @param y second component of the direction
   * @param z third component of the direction
   * @return the ray
   */
  public static Ray exactly(final double startX, final double startY, final double startZ,
      final double x, final double y, final double z) {
    return new Ray(startX, startY, startZ, x, y, z, null, 0);
  }

  /** A ray that leaves an object whose hits are of unknown accuracy. */
  static Ray leaving(final double startX, final double startY, final double startZ,
      final double x, final double y, final double z, final Object3D left, final double blindness) {
    return new Ray(startX, startY, startZ, x, y, z, left, blindness);
  }

  /**
   * This ray in another frame. Arguments are not checked.
   *
   * @param x first coordinate of its start there
   * @param y second coordinate of the start
   * @param z third coordinate of the start
   * @param dx first component of its direction there, of unit length in double
   * @param dy second component of the direction
   * @param dz third component of the direction
   * @param stretch length there of a unit of length along this ray
   * @return the ray, which leaves the same object
   */
  public Ray inFrame(final double x, final double y, final double z, final double dx, final double dy, final double dz,
      final double stretch) {
    return new Ray(x, y, z, dx, dy, dz, left, blindness * stretch);
  }

  /**
   * This ray from a point farther on.
   *
   * @param distance distance of its new start from this one, in scene units
   * @return the ray, which leaves no object
   */
  public Ray from(final double distance) {
    return exactly(startX + distance * directionX, startY + distance * directionY, startZ + distance * directionZ,
        directionX, directionY, directionZ);
  }

  /**
   * Whether this ray ignores a hit, as one on the surface that it leaves: it is on the object that the ray leaves, the
   * accuracy of its hits is unknown, and its distance is within {@link #blindness()}.
   *
   * @param hit a hit of this ray
   * @return false for a ray that leaves no object
   */
  public boolean isBlindTo(final Hit hit) {
    return left != null && hit.getObject() == left && hit.distance() <= blindness;
  }

  /**
   * Distance within which this ray ignores the object that it leaves.
   *
   * @return a distance in scene units; 0 for a ray that leaves no object of unknown accuracy
   */
  public double blindness() {
    return blindness;
  }

  /**
   * The point at a distance along the ray.
   *
   * @param t distance from the starting point in scene units; a negative one lies behind it
   * @return a new point, R + t v; null for {@link #NORAY}
   * @throws IllegalArgumentException if t is infinite or NaN
   */
  public Point3D pointAtParameter(final float t) {
    finite("t", t);
    return this == NORAY ? null : new Point3D((float) (startX + t * directionX), (float) (startY + t * directionY),
        (float) (startZ + t * directionZ));
  }

  /**
   * The starting point R.
   *
   * @return a new point; null for {@link #NORAY}
   */
  public Point3D getStartingPoint() {
    return this == NORAY ? null : new Point3D((float) startX, (float) startY, (float) startZ);
  }

  /**
   * The direction v.
   *
   * @return a new vector of unit length; null for {@link #NORAY}
   */
  public Vector3D getDirection() {
    return this == NORAY ? null : new Vector3D(vx, vy, vz);
  }

  /**
   * First coordinate of the starting point, in double.
   *
   * @return the number; NaN for {@link #NORAY}, as for the other five
   */
  public double startX() {
    return startX;
  }

  /**
   * Second coordinate of the starting point, in double.
   *
   * @return the number
   */
  public double startY() {
    return startY;
  }

  /**
   * Third coordinate of the starting point, in double.
   *
   * @return the number
   */
  public double startZ() {
    return startZ;
  }

  /**
   * First component of the direction, of unit length in double.
   *
   * @return the number
   */
  public double directionX() {
    return directionX;
  }

  /**
   * Second component of the direction, of unit length in double.
   *
   * @return the number
   */
  public double directionY() {
    return directionY;
  }

  /**
   * Third component of the direction, of unit length in double.
   *
   * @return the number
   */
  public double directionZ() {
    return directionZ;
  }

  @Override
  public String toString() {
    return this == NORAY ? "Ray.NORAY" : "Ray(R=" + getStartingPoint() + ", v=" + getDirection() + ")";
  }
}
