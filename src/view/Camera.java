package view;

import static arguments.Arguments.finite;
import static arguments.Arguments.notNull;
import static arguments.Arguments.notParallel;
import static arguments.Arguments.wrong;
import static arguments.Arguments.wrongState;

import javax.vecmath.AxisAngle4d;
import javax.vecmath.Matrix4d;
import javax.vecmath.Vector3d;

import acceleration.Pencil;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.RayGenerator;

/**
 * A camera: its position, its orientation, and the projection (its optics) through which it sees.
 *
 * <p>In the camera's frame the eye is the origin and the camera looks along −z: with the look vector from V to C, x is
 * look × up normalised, y is x × look, z is −look. The matrix from this frame to the scene is the inverse of the view
 * matrix. Only the projection of a camera can be changed.
 */
public class Camera {

  private final Point3D position;
  private final Point3D lookAt;
  private final Vector3D up;
  private final Matrix4d toScene;
  private Projection optics;

  /**
   * A camera that does not have a projection yet.
   *
   * @param V position of the camera
   * @param C the point that it looks at, other than V
   * @param up vector that appears upright in the picture, of any length but 0, not along the view
   * @throws IllegalArgumentException if an argument is null or not finite, if C equals V, or if up is zero or along the
   *     view
   */
  public Camera(final Point3D V, final Point3D C, final Vector3D up) {
    position = new Point3D(finite("V", V));
    if (finite("C", C).equals(V)) {
      throw wrong("samePoint", "C", "V", C);
    }
    final Vector3d look = new Vector3d((double) C.x - V.x, (double) C.y - V.y, (double) C.z - V.z);
    look.normalize();
    notParallel("up", up, "C - V", new Vector3D((float) look.x, (float) look.y, (float) look.z));
    lookAt = new Point3D(C);
    this.up = new Vector3D(up);
    final Vector3d x = new Vector3d(), y = new Vector3d();
    x.cross(look, new Vector3d(up));
    x.normalize();
    y.cross(x, look);
    toScene = new Matrix4d(
        x.x, y.x, -look.x, V.x,
        x.y, y.y, -look.y, V.y,
        x.z, y.z, -look.z, V.z,
        0, 0, 0, 1);
  }

  /**
   * Sets the projection, replacing the previous one.
   *
   * @param projection the projection
   * @throws IllegalArgumentException if the projection is null
   */
  public void setProjection(final Projection projection) {
    optics = notNull("projection", projection);
  }

  /**
   * The projection.
   *
   * @return the projection
   * @throws IllegalStateException if the camera has none
   */
  public Projection getProjection() {
    if (optics == null) {
      throw wrongState("noProjection");
    }
    return optics;
  }

  /**
   * This camera after it has gone around the point that it looks at, about the axis through that point along up: to its own
   * right for positive angles. What it looks at, up, and the projection stay.
   *
   * @param degrees angle in degrees, finite
   * @return a new camera
   * @throws IllegalArgumentException if the angle is not finite, or if no float can hold the new position
   */
  public Camera turned(final double degrees) {
    finite("degrees", (float) degrees);
    final Vector3d axis = new Vector3d(up);
    axis.normalize();
    final Matrix4d about = new Matrix4d();
    about.set(new AxisAngle4d(axis, Math.toRadians(degrees)));
    final Vector3d arm = new Vector3d((double) position.x - lookAt.x, (double) position.y - lookAt.y,
        (double) position.z - lookAt.z);
    about.transform(arm);
    final Camera turned = new Camera(new Point3D((float) (lookAt.x + arm.x), (float) (lookAt.y + arm.y),
        (float) (lookAt.z + arm.z)), lookAt, up);
    turned.optics = optics;
    return turned;
  }

  /**
   * Transforms a point from the camera's frame to the scene, in place.
   *
   * @param P the point; it is changed
   * @throws IllegalArgumentException if the point is null or not finite
   */
  public void toSceneCoordinates(final Point3D P) {
    toScene.transform(finite("P", P));
  }

  /**
   * Transforms a vector from the camera's frame to the scene, in place: it is rotated, not translated.
   *
   * @param v the vector; it is changed
   * @throws IllegalArgumentException if the vector is null or not finite
   */
  public void toSceneCoordinates(final Vector3D v) {
    toScene.transform(finite("v", v));
  }

  /**
   * The rays of this camera through its projection.
   *
   * @param W width of the image in pixels, at least 1
   * @param H height of the image in pixels, at least 1
   * @return the generator of the rays
   * @throws IllegalArgumentException if the image has no pixel
   * @throws IllegalStateException if the camera has no projection
   */
  public RayGenerator getRayGenerator(final int W, final int H) {
    return getProjection().getRayGenerator(this, W, H);
  }

  /**
   * The position of the camera.
   *
   * @return a new point
   */
  public Point3D getPosition() {
    return new Point3D(position);
  }

  /**
   * The direction in which the camera looks.
   *
   * @return a new vector of unit length
   */
  public Vector3D getLook() {
    return new Vector3D((float) -toScene.m02, (float) -toScene.m12, (float) -toScene.m22);
  }

  /**
   * The point that the camera looks at, as it was given.
   *
   * @return a new point
   */
  public Point3D getLookAt() {
    return new Point3D(lookAt);
  }

  /**
   * The vector that appears upright in the picture, as it was given.
   *
   * @return a new vector, of any length
   */
  public Vector3D getUp() {
    return new Vector3D(up);
  }

  /** First coordinate of the position; the other two below. */
  double eyeX() {
    return toScene.m03;
  }

  double eyeY() {
    return toScene.m13;
  }

  double eyeZ() {
    return toScene.m23;
  }

  /** First component in the scene of a vector of the camera's frame; the other two below. */
  double vectorX(final double x, final double y, final double z) {
    return toScene.m00 * x + (toScene.m01 * y + toScene.m02 * z);
  }

  double vectorY(final double x, final double y, final double z) {
    return toScene.m10 * x + (toScene.m11 * y + toScene.m12 * z);
  }

  double vectorZ(final double x, final double y, final double z) {
    return toScene.m20 * x + (toScene.m21 * y + toScene.m22 * z);
  }

  /** First coordinate in the scene of the point (x, y, 0) of the camera's frame; the other two below. */
  double pointX(final double x, final double y) {
    return toScene.m00 * x + (toScene.m01 * y + toScene.m03);
  }

  double pointY(final double x, final double y) {
    return toScene.m10 * x + (toScene.m11 * y + toScene.m13);
  }

  double pointZ(final double x, final double y) {
    return toScene.m20 * x + (toScene.m21 * y + toScene.m23);
  }

  /** The rays from the camera through the points (a, b, −1) of its frame. */
  Pencil pencil() {
    return new Pencil(column(3), column(0), column(1), new double[] {-toScene.m02, -toScene.m12, -toScene.m22});
  }

  private double[] column(final int k) {
    return new double[] {toScene.getElement(0, k), toScene.getElement(1, k), toScene.getElement(2, k)};
  }
}
