package models;

import static arguments.Arguments.direction;
import static arguments.Arguments.finite;
import static arguments.Arguments.notNull;
import static arguments.Arguments.wrong;

import java.awt.Color;
import java.util.List;

import javax.vecmath.AxisAngle4d;
import javax.vecmath.Matrix3d;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;

import acceleration.RayTile;
import acceleration.TileWindow;
import materials.Material;
import primitives.BoundingBox;
import tracer.Hit;
import tracer.Ray;

/**
 * An object scaled, then rotated, then translated: p becomes M p = T·R·S·p.
 *
 * <p><img src="doc-files/AffineTransformation.png" width="320" height="240" alt="A torus that was stretched and turned">
 *
 * <p>The ray is transformed to the object's frame by the inverse, where its direction has the length k = |M⁻¹ v|; it is
 * normalised there, and the t found is divided by k. The normal is transformed back by the inverse transpose, as M itself
 * would tilt it (Turkowski, "Properties of surface-normal transformations", Graphics Gems, 1990). Distance, point and
 * normal of a hit are those of the scene; its object is the one that was hit.
 */
public class AffineTransformation extends Object3D {

  private static final Vector3f NO_SCALE = new Vector3f(1, 1, 1);
  private static final Vector3f NO_AXIS = new Vector3f(0, 1, 0);
  private static final Vector3f NO_SHIFT = new Vector3f();

  /** Rounding of a matrix times a point, with a margin of 2 digits. */
  private static final double ROUNDING = 0x1p-46;

  private final Object3D object;
  private final Object3D asked;
  private final Vector3f scale;
  private final Vector3f axis;
  private final float theta;
  private final Matrix3d toScene;
  private final Matrix3d toObject;
  private final double shiftX;
  private final double shiftY;
  private final double shiftZ;
  /** The norm of the inverse, see {@link #norm(Matrix3d)}. */
  private final double norm;

  /**
   * Scale, rotation and translation.
   *
   * @param s factors of scale along x, y and z; negative ones mirror, 0 is not allowed
   * @param axis direction of the axis of rotation through the origin, of any length but 0
   * @param theta angle in degrees, counter-clockwise seen from the tip of the axis
   * @param d translation in scene units
   * @param object object to act on
   * @throws IllegalArgumentException if an argument is null or not finite, if a factor is 0, if the axis is zero
   */
  public AffineTransformation(final Vector3f s, final Vector3f axis, final float theta,
      final Vector3f d, final Object3D object) {
    this.object = notNull("object", object);
    this.asked = OverridingShape.asked(object);
    object.markContained();
    this.shiftX = finite("d", d).x;
    this.shiftY = d.y;
    this.shiftZ = d.z;
    this.theta = theta;
    final Matrix3d rotation = rotation(direction("axis", axis), finite("theta", theta));
    this.toScene = product(rotation, factors(s));
    rotation.transpose();
    this.toObject = product(new Matrix3d(1.0 / s.x, 0, 0, 0, 1.0 / s.y, 0, 0, 0, 1.0 / s.z), rotation);
    this.norm = norm(toObject);
    this.scale = new Vector3f(s);
    this.axis = new Vector3f(axis);
  }

  /**
   * Scale and rotation.
   *
   * @param s factors of scale along x, y and z; negative ones mirror, 0 is not allowed
   * @param axis direction of the axis of rotation through the origin, of any length but 0
   * @param theta angle in degrees, counter-clockwise seen from the tip of the axis
   * @param object object to act on
   * @throws IllegalArgumentException if an argument is null or not finite, if a factor is 0, if the axis is zero
   */
  public AffineTransformation(final Vector3f s, final Vector3f axis, final float theta, final Object3D object) {
    this(s, axis, theta, NO_SHIFT, object);
  }

  /**
   * Rotation and translation.
   *
   * @param axis direction of the axis of rotation through the origin, of any length but 0
   * @param theta angle in degrees, counter-clockwise seen from the tip of the axis
   * @param d translation in scene units
   * @param object object to act on
   * @throws IllegalArgumentException if an argument is null or not finite, if the axis is zero
   */
  public AffineTransformation(final Vector3f axis, final float theta, final Vector3f d, final Object3D object) {
    this(NO_SCALE, axis, theta, d, object);
  }

  /**
   * Scale and translation.
   *
   * @param s factors of scale along x, y and z; negative ones mirror, 0 is not allowed
   * @param d translation in scene units
   * @param object object to act on
   * @throws IllegalArgumentException if an argument is null or not finite, if a factor is 0
   */
  public AffineTransformation(final Vector3f s, final Vector3f d, final Object3D object) {
    this(s, NO_AXIS, 0, d, object);
  }

  /**
   * Rotation.
   *
   * @param axis direction of the axis of rotation through the origin, of any length but 0
   * @param theta angle in degrees, counter-clockwise seen from the tip of the axis
   * @param object object to act on
   * @throws IllegalArgumentException if an argument is null or not finite, if the axis is zero
   */
  public AffineTransformation(final Vector3f axis, final float theta, final Object3D object) {
    this(NO_SCALE, axis, theta, NO_SHIFT, object);
  }

  /**
   * Scale.
   *
   * @param s factors of scale along x, y and z; negative ones mirror, 0 is not allowed
   * @param object object to act on
   * @throws IllegalArgumentException if an argument is null or not finite, if a factor is 0
   */
  public AffineTransformation(final Vector3f s, final Object3D object) {
    this(s, NO_AXIS, 0, NO_SHIFT, object);
  }

  /** M = R·S and d in double precision. */
  private AffineTransformation(final Vector3d s, final Matrix3d rotation, final Vector3d d, final Object3D object) {
    super();
    this.object = notNull("object", object);
    this.asked = OverridingShape.asked(object);
    object.markContained();
    this.shiftX = notNull("d", d).x;
    this.shiftY = d.y;
    this.shiftZ = d.z;
    this.theta = Float.NaN;
    final Matrix3d inverse = new Matrix3d(notNull("rotation", rotation));
    inverse.transpose();
    this.toScene = product(rotation, new Matrix3d(notNull("s", s).x, 0, 0, 0, s.y, 0, 0, 0, s.z));
    this.toObject = product(new Matrix3d(1 / s.x, 0, 0, 0, 1 / s.y, 0, 0, 0, 1 / s.z), inverse);
    this.norm = norm(toObject);
    this.scale = new Vector3f(s);
    this.axis = new Vector3f();
  }

  /**
   * Scale, rotation and translation in double precision, for coordinates beyond the precision of floats.
   *
   * @param s factors of scale along x, y and z, none of them 0
   * @param rotation matrix of a rotation
   * @param d translation in scene units
   * @param object object to act on
   * @return the transformed object
   * @throws IllegalArgumentException if an argument is null
   */
  public static AffineTransformation of(final Vector3d s, final Matrix3d rotation, final Vector3d d, final Object3D object) {
    return new AffineTransformation(s, rotation, d, object);
  }

  /** The maximum norm: the greatest sum of absolute values in a row. */
  private static double norm(final Matrix3d m) {
    return Math.max(Math.abs(m.m00) + Math.abs(m.m01) + Math.abs(m.m02),
        Math.max(Math.abs(m.m10) + Math.abs(m.m11) + Math.abs(m.m12), Math.abs(m.m20) + Math.abs(m.m21) + Math.abs(m.m22)));
  }

  private static Matrix3d rotation(final Vector3f axis, final float theta) {
    final double length = Axis.length(axis);
    final Matrix3d rotation = new Matrix3d();
    rotation.set(new AxisAngle4d(axis.x / length, axis.y / length, axis.z / length, Math.toRadians(theta)));
    return rotation;
  }

  private static Matrix3d factors(final Vector3f s) {
    if (finite("s", s).x == 0 || s.y == 0 || s.z == 0) {
      throw wrong("scale", "s", s);
    }
    return new Matrix3d(s.x, 0, 0, 0, s.y, 0, 0, 0, s.z);
  }

  private static Matrix3d product(final Matrix3d a, final Matrix3d b) {
    final Matrix3d product = new Matrix3d();
    product.mul(a, b);
    return product;
  }

  @Override
  void markContained() {
    object.markContained();
  }

  @Override
  void addContainer(final Group3D container) {
    object.addContainer(container);
  }

  @Override
  void refreshParts() {
    object.refreshParts();
  }

  @Override
  public Color getColor() {
    return object.getColor();
  }

  @Override
  public Material getMaterial() {
    return object.getMaterial();
  }

  @Override
  public Hit intersectionWith(final Ray ray) {
    if (notNull("ray", ray) == Ray.NORAY) {
      return Hit.NOHIT;
    }
    final double t = distance(ray.startX(), ray.startY(), ray.startZ(),
        ray.directionX(), ray.directionY(), ray.directionZ());
    if (Double.isNaN(t)) {
      final Hit hit = askFor(asked, toObject(ray));
      return inScene(hit, hit.distance() / stretch(ray.directionX(), ray.directionY(), ray.directionZ()));
    }
    return Hit.isDistance(t) ? hitAt(ray, t, 0) : Hit.NOHIT;
  }

  @Override
  double distance(final double x, final double y, final double z, final double dx, final double dy, final double dz) {
    final double k = stretch(dx, dy, dz), px = x - shiftX, py = y - shiftY, pz = z - shiftZ;
    return asked.distance(firstOf(px, py, pz), secondOf(px, py, pz), thirdOf(px, py, pz),
        firstOf(dx, dy, dz) / k, secondOf(dx, dy, dz) / k, thirdOf(dx, dy, dz) / k) / k;
  }

  @Override
  Hit hitAt(final Ray ray, final double t, final int part) {
    final double k = stretch(ray.directionX(), ray.directionY(), ray.directionZ());
    return inScene(asked.hitAt(toObject(ray), t * k, part), t);
  }

  /** Length in the object's frame of a unit vector of the scene. */
  private double stretch(final double dx, final double dy, final double dz) {
    final double x = firstOf(dx, dy, dz), y = secondOf(dx, dy, dz), z = thirdOf(dx, dy, dz);
    return Math.sqrt(x * x + y * y + z * z);
  }

  private double firstOf(final double x, final double y, final double z) {
    return toObject.m00 * x + toObject.m01 * y + toObject.m02 * z;
  }

  private double secondOf(final double x, final double y, final double z) {
    return toObject.m10 * x + toObject.m11 * y + toObject.m12 * z;
  }

  private double thirdOf(final double x, final double y, final double z) {
    return toObject.m20 * x + toObject.m21 * y + toObject.m22 * z;
  }

  /**
   * A ray in the frame of the transformed object.
   *
   * @param ray a ray of the scene
   * @return the ray, its direction of unit length there; {@link Ray#NORAY} for {@link Ray#NORAY}
   * @throws IllegalArgumentException if the ray is null
   */
  public Ray rayToObject(final Ray ray) {
    return notNull("ray", ray) == Ray.NORAY ? Ray.NORAY : toObject(ray);
  }

  @Override
  public List<Object3D> parts() {
    return List.of(object);
  }

  @Override
  public Ray rayToParts(final Ray ray) {
    return rayToObject(ray);
  }

  @Override
  public Hit hitFromParts(final Ray ray, final Hit hit) {
    return hitToScene(ray, hit);
  }

  /**
   * Transforms a hit from the object's frame to the scene: distance, point and normal.
   *
   * @param ray the ray of the scene whose {@link #rayToObject} was hit
   * @param hit the hit there
   * @return the hit in the scene; {@link Hit#NOHIT} for {@link Hit#NOHIT}
   * @throws IllegalArgumentException if an argument is null
   */
  public Hit hitToScene(final Ray ray, final Hit hit) {
    notNull("ray", ray);
    return notNull("hit", hit).hits()
        ? inScene(hit, hit.distance() / stretch(ray.directionX(), ray.directionY(), ray.directionZ())) : Hit.NOHIT;
  }

  private Ray toObject(final Ray ray) {
    final double dx = ray.directionX(), dy = ray.directionY(), dz = ray.directionZ(), k = stretch(dx, dy, dz);
    final double px = ray.startX() - shiftX, py = ray.startY() - shiftY, pz = ray.startZ() - shiftZ;
    return ray.inFrame(firstOf(px, py, pz), secondOf(px, py, pz), thirdOf(px, py, pz),
        firstOf(dx, dy, dz) / k, secondOf(dx, dy, dz) / k, thirdOf(dx, dy, dz) / k, k);
  }

  /** A hit of the object's frame at a distance of the scene; the normal is transformed by the inverse transpose. */
  private Hit inScene(final Hit hit, final double t) {
    final double x = hit.pointX(), y = hit.pointY(), z = hit.pointZ();
    final double gx = hit.geometricX(), gy = hit.geometricY(), gz = hit.geometricZ();
    final double px = toScene.m00 * x + toScene.m01 * y + toScene.m02 * z + shiftX,
        py = toScene.m10 * x + toScene.m11 * y + toScene.m12 * z + shiftY,
        pz = toScene.m20 * x + toScene.m21 * y + toScene.m22 * z + shiftZ;
    final double ax = columnOf(0, gx, gy, gz), ay = columnOf(1, gx, gy, gz), az = columnOf(2, gx, gy, gz);
    final double error = errorBound(hit.errorBound(), Math.abs(px) + Math.abs(py) + Math.abs(pz),
        Math.sqrt(ax * ax + ay * ay + az * az));
    final double nx = hit.normalX(), ny = hit.normalY(), nz = hit.normalZ();
    return gx == nx && gy == ny && gz == nz && Double.isNaN(hit.textureU())
        ? Hit.of(t, px, py, pz, ax, ay, az, error, hit.getObject())
        : Hit.shaded(t, px, py, pz, ax, ay, az, error, hit.getObject(),
            columnOf(0, nx, ny, nz), columnOf(1, nx, ny, nz), columnOf(2, nx, ny, nz), hit.textureU(), hit.textureV());
  }

  /** A component of a normal transformed by the inverse transpose. */
  private double columnOf(final int column, final double x, final double y, final double z) {
    return column == 0 ? toObject.m00 * x + toObject.m10 * y + toObject.m20 * z
        : column == 1 ? toObject.m01 * x + toObject.m11 * y + toObject.m21 * z
        : toObject.m02 * x + toObject.m12 * y + toObject.m22 * z;
  }

  /**
   * Error bound in the scene of a point of the object. A step along the scene's unit normal leads off the surface in the
   * object's frame by the length of the normal before it was normalised. There it must exceed the object's bound and the
   * rounding of the start of a ray that is transformed to the object's frame.
   */
  private double errorBound(final double local, final double size, final double lengthOfNormal) {
    return (local + ROUNDING * norm * (size + Math.abs(shiftX) + Math.abs(shiftY) + Math.abs(shiftZ))) / lengthOfNormal
        + ROUNDING * size;
  }

  @Override
  boolean intersectsBefore(final Ray ray, final double tmax) {
    final double t = distance(ray.startX(), ray.startY(), ray.startZ(),
        ray.directionX(), ray.directionY(), ray.directionZ());
    return Double.isNaN(t)
        ? asked.intersectsBefore(toObject(ray), tmax * stretch(ray.directionX(), ray.directionY(), ray.directionZ()))
        : t > 0 && t < tmax;
  }

  @Override
  void block(final ShadowTile tile) {
    if (answersTiles()) {
      tile.askInFrame(this);
    } else {
      super.block(tile);
    }
  }

  /** Puts a ray of the scene into a tile of the object's frame, as {@link #intersectsBefore} transforms it. */
  void putInFrame(final ShadowTile tile, final Ray ray, final double distance, final double tmax) {
    final double k = stretch(ray.directionX(), ray.directionY(), ray.directionZ());
    tile.put(toObject(ray), distance * k, tmax * k);
  }

  /** The same for a ray of plain numbers. */
  void putInFrame(final ShadowTile tile, final double x, final double y, final double z,
      final double dx, final double dy, final double dz, final double distance, final double tmax) {
    final double k = stretch(dx, dy, dz), px = x - shiftX, py = y - shiftY, pz = z - shiftZ;
    tile.put(firstOf(px, py, pz), secondOf(px, py, pz), thirdOf(px, py, pz),
        firstOf(dx, dy, dz) / k, secondOf(dx, dy, dz) / k, thirdOf(dx, dy, dz) / k, distance * k, tmax * k);
  }

  /** The object that rays in its frame are tested with. */
  Object3D asked() {
    return asked;
  }

  @Override
  boolean isTextured() {
    return object.isTextured() || Pattern.isOn(object.getClass());
  }

  @Override
  boolean answersTiles() {
    return asked.answersTiles();
  }

  @Override
  void closestHits(final RayTile rays, final TileHits hits) {
    if (!answersTiles()) {
      super.closestHits(rays, hits);
      return;
    }
    final TileHits local = hits.nested();
    fill(local.rays(), rays);
    local.clear();
    asked.closestHits(local.rays(), local);
    final TileWindow window = rays.window();
    for (int row = window.firstRow(); row <= window.lastRow(); row++) {
      for (int i = row * RayTile.SIZE + window.firstColumn(); i <= row * RayTile.SIZE + window.lastColumn(); i++) {
        if (local.hits(i)) {
          final double t = local.distance(i) / stretch(rays.directionX(i), rays.directionY(i), rays.directionZ(i));
          if (hits.isCloser(i, t, local.part(i))) {
            hits.take(i, t, hits.source(this, local.painted(i)), local.part(i));
          }
        }
      }
    }
  }

  private void fill(final RayTile local, final RayTile rays) {
    local.open(rays.columns(), rays.rows());
    final TileWindow window = rays.window();
    for (int row = window.firstRow(); row <= window.lastRow(); row++) {
      for (int i = row * RayTile.SIZE + window.firstColumn(); i <= row * RayTile.SIZE + window.lastColumn(); i++) {
        final double dx = rays.directionX(i), dy = rays.directionY(i), dz = rays.directionZ(i), k = stretch(dx, dy, dz);
        final double px = rays.startX(i) - shiftX, py = rays.startY(i) - shiftY, pz = rays.startZ(i) - shiftZ;
        local.putExactly(i, firstOf(px, py, pz), secondOf(px, py, pz), thirdOf(px, py, pz),
            firstOf(dx, dy, dz) / k, secondOf(dx, dy, dz) / k, thirdOf(dx, dy, dz) / k);
      }
    }
    local.close();
  }

  @Override
  public BoundingBox getBoundingBox() {
    final BoundingBox box = FlatGroup.boxOf(object);
    if (!box.isFinite()) {
      return box;
    }
    final double x = 0.5 * ((double) box.minX() + box.maxX()), y = 0.5 * ((double) box.minY() + box.maxY()),
        z = 0.5 * ((double) box.minZ() + box.maxZ());
    final double hx = 0.5 * ((double) box.maxX() - box.minX()), hy = 0.5 * ((double) box.maxY() - box.minY()),
        hz = 0.5 * ((double) box.maxZ() - box.minZ());
    return BoundingBox.around(
        toScene.m00 * x + toScene.m01 * y + toScene.m02 * z + shiftX,
        toScene.m10 * x + toScene.m11 * y + toScene.m12 * z + shiftY,
        toScene.m20 * x + toScene.m21 * y + toScene.m22 * z + shiftZ,
        Math.abs(toScene.m00) * hx + Math.abs(toScene.m01) * hy + Math.abs(toScene.m02) * hz,
        Math.abs(toScene.m10) * hx + Math.abs(toScene.m11) * hy + Math.abs(toScene.m12) * hz,
        Math.abs(toScene.m20) * hx + Math.abs(toScene.m21) * hy + Math.abs(toScene.m22) * hz);
  }

  /**
   * The object that is transformed.
   *
   * @return the object, in its own frame
   */
  public Object3D getObject() {
    return object;
  }

  @Override
  int cost(final Ray ray) {
    return object.cost(toObject(ray));
  }

  @Override
  public List<Object> constructorArguments() {
    return Float.isNaN(theta) ? List.of() : List.of(new Vector3f(scale), new Vector3f(axis), theta,
        new Vector3f((float) shiftX, (float) shiftY, (float) shiftZ), object);
  }

  @Override
  public String toString() {
    return "AffineTransformation(" + object + ")";
  }
}
