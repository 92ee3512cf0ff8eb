package view;

import static arguments.Arguments.notNull;
import static arguments.Arguments.wrong;
import static arguments.Arguments.wrongState;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;
import tracer.RayGenerator;

/**
 * The projection {@code angular} of scene files: a fish-eye with an opening of up to 180°, which the library's own, whose
 * window is the tangent of half the opening, cannot have.
 *
 * <p>The scene is seen through a cap of the unit sphere about the camera. The window is square, w = h = 2 sin(fov/2),
 * and the pixel at (x, y) looks through the point of the cap over it, along (x, y, −√(1 − x² − y²)): the rays of
 * {@link view.Angular}, whose picture is the same for openings below 180°. Pixels outside the circle
 * x² + y² ≤ sin²(fov/2) have no ray and get the background colour (and not white, as some readers of scene files
 * paint them), so that they look like everything else that shows nothing.
 */
public final class FishEye extends Projection {

  /** The rays through the cap. The frame of the camera is asked once; the rest is computed in double. */
  private static final class CapRays extends RayGenerator {

    private final Camera camera;
    private final double size;
    private final Vector3D x = new Vector3D(1, 0, 0);
    private final Vector3D y = new Vector3D(0, 1, 0);
    private final Vector3D z = new Vector3D(0, 0, 1);

    CapRays(final Camera camera, final int W, final int H, final double size) {
      super(camera, W, H);
      this.camera = camera;
      this.size = size;
      camera.toSceneCoordinates(x);
      camera.toSceneCoordinates(y);
      camera.toSceneCoordinates(z);
    }

    @Override
    public Ray getRay(final int m, final int n) {
      checkPixel(m, n);
      final double a = ((m + 0.5) / getWidth() - 0.5) * size;
      final double b = ((n + 0.5) / getHeight() - 0.5) * size;
      final double rho2 = a * a + b * b;
      if (rho2 > size * size / 4) {
        return Ray.NORAY;
      }
      final double c = -Math.sqrt(1 - rho2);
      final Point3D eye = camera.getPosition();
      return Ray.towards(eye.x, eye.y, eye.z,
          a * x.x + b * y.x + c * z.x, a * x.y + b * y.y + c * z.y, a * x.z + b * y.z + c * z.z);
    }
  }

  private final double size;

  /**
   * A fish-eye.
   *
   * @param fov full opening of the field of view in degrees, 0 &lt; fov ≤ 180
   * @throws IllegalArgumentException if it is out of this range
   */
  public FishEye(final float fov) {
    super(size(fov), size(fov));
    this.size = size(fov);
  }

  private static double size(final float fov) {
    if (!(fov > 0 && fov <= 180)) {
      throw wrong("fishEye", fov);
    }
    return 2 * StrictMath.sin(Math.toRadians(fov) / 2);
  }

  @Override
  public RayGenerator getRayGenerator(final Camera camera, final int W, final int H) {
    if (notNull("camera", camera).getProjection() != this) {
      throw wrongState("otherCamera");
    }
    return new CapRays(camera, W, H, size);
  }
}
