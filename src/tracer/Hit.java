package tracer;

import static arguments.Arguments.direction;
import static arguments.Arguments.finite;
import static arguments.Arguments.notNull;
import static arguments.Arguments.positive;

import models.Object3D;
import primitives.Point3D;
import primitives.Vector3D;

/**
 * What is known of the intersection of a ray with an object: the parameter t, the point, the normal to the
 * surface there, and the object.
 *
 * <p>Immutable. The normal is of unit length and belongs to the surface: it points out of a closed object and is
 * never turned towards the ray.
 */
public final class Hit {

  /** No intersection, as if it happened at an infinite distance. It has neither point nor normal nor object. */
  public static final Hit NOHIT = new Hit();

  private final float t;
  private final double x;
  private final double y;
  private final double z;
  private final double normalX;
  private final double normalY;
  private final double normalZ;
  private final Object3D object;

  /**
   * An intersection.
   *
   * @param t distance from the start of the ray in scene units, &gt; 0 and finite
   * @param P point of the intersection
   * @param n normal to the surface at that point, of any length but 0
   * @param object object whose colour is to be painted
   * @throws IllegalArgumentException if t is not positive or not finite, if the point or the normal is null or
   *     not finite, if the normal is zero, or if the object is null
   */
  public Hit(final float t, final Point3D P, final Vector3D n, final Object3D object) {
    this(positive("t", t), finite("P", P).x, P.y, P.z, direction("n", n).x, n.y, n.z, notNull("object", object));
  }

  private Hit(final float t, final double x, final double y, final double z,
      final double nx, final double ny, final double nz, final Object3D object) {
    final double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
    this.t = t;
    this.x = x;
    this.y = y;
    this.z = z;
    this.normalX = nx / length;
    this.normalY = ny / length;
    this.normalZ = nz / length;
    this.object = object;
    assert object == null || isDistance(t) : t;
    assert object == null || isUnit(normalX, normalY, normalZ) : "no unit normal: " + nx + ", " + ny + ", " + nz;
  }

  private static boolean isUnit(final double x, final double y, final double z) {
    return Math.abs(x * x + y * y + z * z - 1) < 1e-12;
  }

  private Hit() {
    this(Float.POSITIVE_INFINITY, Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN, null);
  }

  /**
   * The intersection that a shape has computed in double. Where the numbers leave what a float can hold, or make
   * no normal, there is no intersection to speak of.
   *
   * @param t distance from the start of the ray
   * @param x first coordinate of the point
   * @param y second coordinate of the point
   * @param z third coordinate of the point
   * @param nx first component of the normal, of any length
   * @param ny second component of the normal
   * @param nz third component of the normal
   * @param object object whose colour is to be painted
   * @return the intersection, or {@link #NOHIT} if t is not a positive float, the point not finite in floats, or
   *     the normal zero or not finite
   */
  public static Hit of(final double t, final double x, final double y, final double z,
      final double nx, final double ny, final double nz, final Object3D object) {
    final double length2 = nx * nx + ny * ny + nz * nz;
    final boolean sound = isDistance(t) && Float.isFinite((float) x) && Float.isFinite((float) y)
        && Float.isFinite((float) z) && length2 > 0 && length2 < Double.POSITIVE_INFINITY;
    return sound ? new Hit((float) t, x, y, z, nx, ny, nz, object) : NOHIT;
  }

  /**
   * Whether a number can be the parameter of an intersection.
   *
   * @param t a number, computed in double
   * @return true if it is greater than 0 and finite as a float; false for NaN
   */
  public static boolean isDistance(final double t) {
    return (float) t > 0 && (float) t < Float.POSITIVE_INFINITY;
  }

  /**
   * Whether there is an intersection.
   *
   * @return false for {@link #NOHIT}, true for all others
   */
  public boolean hits() {
    return this != NOHIT;
  }

  /**
   * Whether this intersection happens closer to the start of the ray than another.
   *
   * @param hit the other intersection, of the same ray
   * @return true if t here is less than t there; false if they are equal
   * @throws IllegalArgumentException if hit is null
   */
  public boolean isCloser(final Hit hit) {
    return t < notNull("hit", hit).t;
  }

  /**
   * The parameter t.
   *
   * @return distance from the start of the ray in scene units; infinity for {@link #NOHIT}
   */
  public float getT() {
    return t;
  }

  /**
   * The point of the intersection.
   *
   * @return a new point; null for {@link #NOHIT}
   */
  public Point3D getPoint() {
    return hits() ? new Point3D((float) x, (float) y, (float) z) : null;
  }

  /**
   * The normal to the surface at the point of the intersection.
   *
   * @return a new vector of unit length; null for {@link #NOHIT}
   */
  public Vector3D getNormal() {
    return hits() ? new Vector3D((float) normalX, (float) normalY, (float) normalZ) : null;
  }

  /**
   * The object whose colour is to be painted.
   *
   * @return the object; null for {@link #NOHIT}
   */
  public Object3D getObject() {
    return object;
  }

  /**
   * First coordinate of the point, in double.
   *
   * @return the number; NaN for {@link #NOHIT}, as for the other five
   */
  public double pointX() {
    return x;
  }

  /**
   * Second coordinate of the point, in double.
   *
   * @return the number
   */
  public double pointY() {
    return y;
  }

  /**
   * Third coordinate of the point, in double.
   *
   * @return the number
   */
  public double pointZ() {
    return z;
  }

  /**
   * First component of the normal, in double.
   *
   * @return the number
   */
  public double normalX() {
    return normalX;
  }

  /**
   * Second component of the normal, in double.
   *
   * @return the number
   */
  public double normalY() {
    return normalY;
  }

  /**
   * Third component of the normal, in double.
   *
   * @return the number
   */
  public double normalZ() {
    return normalZ;
  }

  @Override
  public String toString() {
    return hits() ? "Hit(t=" + t + ", P=" + getPoint() + ", n=" + getNormal() + ", " + object + ")" : "Hit.NOHIT";
  }
}
