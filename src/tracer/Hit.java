package tracer;

import static arguments.Arguments.direction;
import static arguments.Arguments.finite;
import static arguments.Arguments.notNull;
import static arguments.Arguments.positive;

import javax.vecmath.TexCoord2f;

import models.Object3D;
import primitives.Point3D;
import primitives.Vector3D;

/**
 * What is known of the intersection of a ray with an object: the parameter t, the point, the normals to the surface
 * there, texture coordinates, and the object.
 *
 * <p>Immutable. Normals are of unit length and belong to the surface: they point out of a closed object and are never
 * turned towards the ray. There are two of them. The geometric normal is that of the surface itself; what is outside, and
 * where rays start, depends on it. The normal that shades differs from it on smooth meshes only; it is never turned away
 * from the geometric one.
 *
 * <p>A hit also makes the rays that leave its point ({@link #leave}): they start off the surface by the error bound of the
 * point, so that they do not hit the surface that they leave.
 */
public final class Hit {

  /** No intersection, at infinite distance. It has neither point nor normal nor object. */
  public static final Hit NOHIT = new Hit();

  /** A shading normal that is shorter than this after it was cut is replaced by the geometric normal. */
  private static final double SHORTEST = 1e-6;

  /** Greatest offset from the surface at which a ray starts, relative to the largest number of the hit. */
  private static final double GREATEST_OFFSET = 1e-6;

  /**
   * Relative distance within which a ray ignores the object that it leaves, if hits of that object have float accuracy
   * only.
   */
  private static final double BLIND = 1e-4;

  private final double t;
  private final double x;
  private final double y;
  private final double z;
  private final double normalX;
  private final double normalY;
  private final double normalZ;
  private final double geometricX;
  private final double geometricY;
  private final double geometricZ;
  private final double u;
  private final double v;
  private final double error;
  private final Object3D object;

  /**
   * An intersection with a surface that is shaded by its geometric normal.
   *
   * @param t distance from the start of the ray in scene units, &gt; 0 and finite
   * @param P point of the intersection
   * @param n normal to the surface at that point, of any length but 0
   * @param object object whose colour is to be painted
   * @throws IllegalArgumentException if t is not positive or not finite, if the point or the normal is null or
   *     not finite, if the normal is zero, or if the object is null
   */
  public Hit(final float t, final Point3D P, final Vector3D n, final Object3D object) {
    this(t, P, n, n, null, object);
  }

  /**
   * An intersection with a surface that has a shading normal or a texture. The normal that shades is cut to the front:
   * where n·g &lt; 0 it loses its part along the geometric normal g.
   *
   * @param t distance from the start of the ray in scene units, &gt; 0 and finite
   * @param P point of the intersection
   * @param n normal that shades, of any length but 0
   * @param geometric normal to the surface at that point, of any length but 0
   * @param uv texture coordinates; null if there are none
   * @param object object whose colour is to be painted
   * @throws IllegalArgumentException if t is not positive or not finite, if the point, a normal, or the texture coordinates
   *     are not finite, if the point, a normal, or the object is null, or if a normal is zero
   */
  public Hit(final float t, final Point3D P, final Vector3D n, final Vector3D geometric, final TexCoord2f uv,
      final Object3D object) {
    this(shaded(positive("t", t), finite("P", P).x, P.y, P.z, direction("geometric", geometric).x, geometric.y, geometric.z,
        Double.POSITIVE_INFINITY, notNull("object", object), direction("n", n).x, n.y, n.z,
        uv == null ? Double.NaN : finite("uv.x", uv.x), uv == null ? Double.NaN : finite("uv.y", uv.y)), t);
  }

  private Hit(final double t, final double x, final double y, final double z,
      final double nx, final double ny, final double nz, final double error, final Object3D object) {
    final double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
    this.t = t;
    this.x = x;
    this.y = y;
    this.z = z;
    this.normalX = nx / length;
    this.normalY = ny / length;
    this.normalZ = nz / length;
    this.geometricX = normalX;
    this.geometricY = normalY;
    this.geometricZ = normalZ;
    this.u = Double.NaN;
    this.v = Double.NaN;
    this.error = error;
    this.object = object;
    assert object == null || isDistance(t) : t;
    assert object == null || isUnit(normalX, normalY, normalZ) : "no unit normal: " + nx + ", " + ny + ", " + nz;
  }

  /** The same hit at another distance. */
  private Hit(final Hit hit, final double t) {
    this.t = t;
    this.x = hit.x;
    this.y = hit.y;
    this.z = hit.z;
    this.normalX = hit.normalX;
    this.normalY = hit.normalY;
    this.normalZ = hit.normalZ;
    this.geometricX = hit.geometricX;
    this.geometricY = hit.geometricY;
    this.geometricZ = hit.geometricZ;
    this.u = hit.u;
    this.v = hit.v;
    this.error = hit.error;
    this.object = hit.object;
  }

  /** A hit with two normals, both of unit length, and texture coordinates. */
  private Hit(final double t, final double x, final double y, final double z, final double error, final Object3D object,
      final double gx, final double gy, final double gz, final double nx, final double ny, final double nz,
      final double u, final double v) {
    this.t = t;
    this.x = x;
    this.y = y;
    this.z = z;
    this.normalX = nx;
    this.normalY = ny;
    this.normalZ = nz;
    this.geometricX = gx;
    this.geometricY = gy;
    this.geometricZ = gz;
    this.u = u;
    this.v = v;
    this.error = error;
    this.object = object;
    assert isUnit(nx, ny, nz) : "no unit normal: " + nx + ", " + ny + ", " + nz;
  }

  /** This hit with another normal that shades, of unit length. */
  private Hit with(final double nx, final double ny, final double nz, final double textureU, final double textureV) {
    return new Hit(t, x, y, z, error, object, geometricX, geometricY, geometricZ, nx, ny, nz, textureU, textureV);
  }

  /** This hit with a normal that shades, of any length, which is cut to the front. */
  private Hit withCut(final double nx, final double ny, final double nz, final double textureU, final double textureV) {
    final double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
    final double behind = Math.min(0, (nx * geometricX + ny * geometricY + nz * geometricZ) / length);
    final double cx = nx / length - behind * geometricX, cy = ny / length - behind * geometricY,
        cz = nz / length - behind * geometricZ, cut = Math.sqrt(cx * cx + cy * cy + cz * cz);
    return cut >= SHORTEST ? with(cx / cut, cy / cut, cz / cut, textureU, textureV)
        : with(geometricX, geometricY, geometricZ, textureU, textureV);
  }

  private static boolean isUnit(final double x, final double y, final double z) {
    return Math.abs(x * x + y * y + z * z - 1) < 1e-12;
  }

  private Hit() {
    this(Double.POSITIVE_INFINITY, Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN,
        Double.POSITIVE_INFINITY, null);
  }

  /**
   * The intersection that a shape has computed, of unknown accuracy: see {@link #of(double, double, double, double, double,
   * double, double, double, Object3D)}.
   *
   * @param t distance from the start of the ray
   * @param x first coordinate of the point
   * @param y second coordinate of the point
   * @param z third coordinate of the point
   * @param nx first component of the normal, of any length
   * @param ny second component of the normal
   * @param nz third component of the normal
   * @param object object whose colour is to be painted
   * @return the intersection, or {@link #NOHIT}
   */
  public static Hit of(final double t, final double x, final double y, final double z,
      final double nx, final double ny, final double nz, final Object3D object) {
    return of(t, x, y, z, nx, ny, nz, Double.POSITIVE_INFINITY, object);
  }

  /**
   * The intersection that a shape has computed in double. Where a number overflows float, or there is no normal, it
   * counts as a miss.
   *
   * @param t distance from the start of the ray
   * @param x first coordinate of the point
   * @param y second coordinate of the point
   * @param z third coordinate of the point
   * @param nx first component of the normal, of any length
   * @param ny second component of the normal
   * @param nz third component of the normal
   * @param error see {@link #errorBound()}
   * @param object object whose colour is to be painted
   * @return the intersection, or {@link #NOHIT} if t is not a positive float, the point not finite in floats, or
   *     the normal zero or not finite
   */
  public static Hit of(final double t, final double x, final double y, final double z,
      final double nx, final double ny, final double nz, final double error, final Object3D object) {
    return isSound(t, x, y, z, nx * nx + ny * ny + nz * nz) ? new Hit(t, x, y, z, nx, ny, nz, error, object) : NOHIT;
  }

  /**
   * The intersection that a shape has computed in double, with a normal that shades, which is cut to the front, and with
   * texture coordinates. The geometric normal stands in for one that is zero or not finite.
   *
   * @param t distance from the start of the ray
   * @param x first coordinate of the point
   * @param y second coordinate of the point
   * @param z third coordinate of the point
   * @param gx first component of the geometric normal, of any length
   * @param gy second component of the geometric normal
   * @param gz third component of the geometric normal
   * @param error see {@link #errorBound()}
   * @param object object whose colour is to be painted
   * @param nx first component of the normal that shades, of any length
   * @param ny second component of the normal that shades
   * @param nz third component of the normal that shades
   * @param u first texture coordinate; NaN if there are none
   * @param v second texture coordinate; NaN if there are none
   * @return the intersection, or {@link #NOHIT} as without them
   */
  public static Hit shaded(final double t, final double x, final double y, final double z,
      final double gx, final double gy, final double gz, final double error, final Object3D object,
      final double nx, final double ny, final double nz, final double u, final double v) {
    final double length2 = gx * gx + gy * gy + gz * gz;
    if (!isSound(t, x, y, z, length2)) {
      return NOHIT;
    }
    final boolean isOwn = nx == gx && ny == gy && nz == gz;
    final double shading2 = nx * nx + ny * ny + nz * nz;
    if (isOwn || !(nx * gx + ny * gy + nz * gz >= 0 && shading2 > 0 && shading2 < Double.POSITIVE_INFINITY)) {
      final Hit flat = new Hit(t, x, y, z, gx, gy, gz, error, object);
      return isOwn ? flat.with(flat.geometricX, flat.geometricY, flat.geometricZ, u, v) : flat.withCut(nx, ny, nz, u, v);
    }
    final double length = Math.sqrt(length2), inverse = 1 / Math.sqrt(shading2);
    return new Hit(t, x, y, z, error, object, gx / length, gy / length, gz / length,
        nx * inverse, ny * inverse, nz * inverse, u, v);
  }

  /**
   * This hit with a normal that shades, which is cut to the front, and with texture coordinates. The geometric normal stands
   * in for one that is zero or not finite.
   *
   * @param nx first component of the normal, of any length
   * @param ny second component of the normal
   * @param nz third component of the normal
   * @param textureU first texture coordinate; NaN if there are none
   * @param textureV second texture coordinate; NaN if there are none
   * @return the new hit; its geometric normal is the one of this hit
   */
  public Hit withShading(final double nx, final double ny, final double nz, final double textureU, final double textureV) {
    return hits() ? shaded(t, x, y, z, geometricX, geometricY, geometricZ, error, object, nx, ny, nz, textureU, textureV)
        : NOHIT;
  }

  private static boolean isSound(final double t, final double x, final double y, final double z, final double length2) {
    return isDistance(t) && Float.isFinite((float) x) && Float.isFinite((float) y) && Float.isFinite((float) z)
        && length2 > 0 && length2 < Double.POSITIVE_INFINITY;
  }

  /**
   * The same hit as seen from a ray that starts farther back.
   *
   * @param distance how much farther back, in scene units
   * @return the hit with the distance added to t; {@link #NOHIT} if that overflows float
   */
  public Hit seenFromBehind(final double distance) {
    return isDistance(t + distance) ? new Hit(this, t + distance) : NOHIT;
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
    return getT() < notNull("hit", hit).getT();
  }

  /**
   * The parameter t.
   *
   * @return distance from the start of the ray in scene units; infinity for {@link #NOHIT}
   */
  public float getT() {
    return (float) t;
  }

  /**
   * The parameter t, in double.
   *
   * @return distance from the start of the ray in scene units; infinity for {@link #NOHIT}
   */
  public double distance() {
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
   * The normal that shades at the point of the intersection.
   *
   * @return a new vector of unit length; null for {@link #NOHIT}
   */
  public Vector3D getNormal() {
    return hits() ? new Vector3D((float) normalX, (float) normalY, (float) normalZ) : null;
  }

  /**
   * The normal to the surface itself. Except on smooth meshes it is {@link #getNormal()}.
   *
   * @return a new vector of unit length; null for {@link #NOHIT}
   */
  public Vector3D getGeometricNormal() {
    return hits() ? new Vector3D((float) geometricX, (float) geometricY, (float) geometricZ) : null;
  }

  /**
   * The texture coordinates.
   *
   * @return a new pair, u to the right and v upwards; null if there are none
   */
  public TexCoord2f getTexCoord() {
    return Double.isNaN(u + v) ? null : new TexCoord2f((float) u, (float) v);
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

  /**
   * First component of the geometric normal, in double.
   *
   * @return the number
   */
  public double geometricX() {
    return geometricX;
  }

  /**
   * Second component of the geometric normal, in double.
   *
   * @return the number
   */
  public double geometricY() {
    return geometricY;
  }

  /**
   * Third component of the geometric normal, in double.
   *
   * @return the number
   */
  public double geometricZ() {
    return geometricZ;
  }

  /**
   * First texture coordinate, in double.
   *
   * @return u; NaN if none
   */
  public double textureU() {
    return u;
  }

  /**
   * Second texture coordinate, in double.
   *
   * @return v; NaN if none
   */
  public double textureV() {
    return v;
  }

  /**
   * How far the point can be off the surface, with a margin: a ray that starts this far from the point along the
   * geometric normal starts on that side of the surface, in the object's own arithmetic too.
   *
   * @return a distance in scene units; infinity if the accuracy is unknown, as for hits made by a public constructor,
   *     which takes floats
   */
  public double errorBound() {
    return error;
  }

  /** The largest magnitude among the numbers of a hit: the coordinates of the point and the distance. */
  private double scale() {
    return Math.max(Math.max(Math.abs(x), Math.abs(y)), Math.max(Math.abs(z), t));
  }

  /**
   * The offset from the surface at which rays start that leave this hit.
   *
   * @return the error bound, at most 10<sup>−6</sup> of the largest number of the hit
   */
  public double offset() {
    return Math.min(error, GREATEST_OFFSET * scale());
  }

  /**
   * The ray that leaves the point of this hit. It starts off the surface by {@link #offset()}, on the side it goes to. If
   * the accuracy of the hit is unknown, the ray ignores the object that it leaves within 10<sup>−4</sup> of the largest
   * number of the hit: see {@link Ray#isBlindTo}.
   *
   * @param outside whether it starts on the outer side, where the geometric normal points
   * @param dx first component of its direction, of unit length
   * @param dy second component of the direction
   * @param dz third component of the direction
   * @return the ray, in double
   */
  public Ray leave(final boolean outside, final double dx, final double dy, final double dz) {
    final double k = outside ? offset() : -offset();
    final double startX = x + k * geometricX, startY = y + k * geometricY, startZ = z + k * geometricZ;
    return error < Double.POSITIVE_INFINITY ? Ray.exactly(startX, startY, startZ, dx, dy, dz)
        : Ray.leaving(startX, startY, startZ, dx, dy, dz, object, BLIND * scale());
  }

  @Override
  public String toString() {
    return hits() ? "Hit(t=" + getT() + ", P=" + getPoint() + ", n=" + getNormal() + ", " + object + ")" : "Hit.NOHIT";
  }
}
