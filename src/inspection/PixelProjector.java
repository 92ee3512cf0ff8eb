package inspection;

import static arguments.Arguments.notNull;
import static arguments.Arguments.positive;

import java.awt.geom.Point2D;
import java.util.Optional;

import primitives.Point3D;
import primitives.Vector3D;
import view.Camera;
import view.Orthographic;
import view.Perspective;
import view.Projection;

/** Projects points of the scene into the picture of a camera: the inverse of its rays. */
public final class PixelProjector {

  private final Camera camera;
  private final Projection projection;
  private final Optional<FishEyeCap> cap;
  private final Vector3D[] axes = {new Vector3D(1, 0, 0), new Vector3D(0, 1, 0), new Vector3D(0, 0, 1)};
  private final int W;
  private final int H;

  /**
   * A projector into a picture.
   *
   * @param camera the camera, which has a projection
   * @param W width of the picture in pixels, at least 1
   * @param H height of the picture in pixels, at least 1
   * @throws IllegalArgumentException if the camera is null, or W or H is not positive
   */
  public PixelProjector(final Camera camera, final int W, final int H) {
    this.camera = notNull("camera", camera);
    this.projection = camera.getProjection();
    this.cap = FishEyeCap.of(projection);
    this.W = positive("W", W);
    this.H = positive("H", H);
    for (final Vector3D axis : axes) {
      camera.toSceneCoordinates(axis);
    }
  }

  /**
   * The place of a point in the picture.
   *
   * @param P a point of the scene
   * @return x in pixels from the left and y from the top, possibly outside the picture; empty if no ray can hit the
   *     point, or if the projection is user-written
   * @throws IllegalArgumentException if the point is null
   */
  public Optional<Point2D> project(final Point3D P) {
    final Vector3D d = new Vector3D();
    d.sub(notNull("P", P), camera.getPosition());
    final double x = d.dot(axes[0]), y = d.dot(axes[1]), z = d.dot(axes[2]);
    if (projection instanceof Orthographic) {
      return z <= 0 ? Optional.of(pixel(x, y)) : Optional.empty();
    }
    if (projection instanceof Perspective) {
      return z < 0 ? Optional.of(pixel(x / -z, y / -z)) : Optional.empty();
    }
    final double length = Math.sqrt(x * x + y * y + z * z);
    return cap.filter(fishEye -> z <= 0 && length > 0).map(fishEye -> {
      final double k = Math.sqrt(fishEye.radius2()) / length;
      return pixel(k * x, k * y);
    });
  }

  private Point2D pixel(final double x, final double y) {
    return new Point2D.Double((x / projection.getWidth() + 0.5) * W, (0.5 - y / projection.getHeight()) * H);
  }
}
