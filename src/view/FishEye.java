package view;

import static arguments.Arguments.wrong;

import primitives.Vector3D;
import tracer.Ray;
import tracer.RayGenerator;

/**
 * The projection {@code angular} of scene files: a fish-eye of up to 180°. {@link Angular} cannot reach that, as its
 * window is the tangent of half the angle.
 *
 * <p>The scene is seen through a cap of the unit sphere about the camera. The window is square, w = h = 2 sin(fov/2), and
 * the pixel at (x, y) looks through the point of the cap in front of it, along (x, y, −√(1 − x² − y²)). These are the
 * rays of {@link Angular}, and for angles below 180° the picture is the same. Pixels outside the circle x² + y² ≤
 * sin²(fov/2) have no ray and get the background colour.
 */
public final class FishEye extends Projection {

  /** The rays through the cap. The axes are rounded to floats, as {@link Camera#toSceneCoordinates} returns them. */
  private static final class CapRays extends RayGenerator {

    private final Camera camera;
    private final FishEye projection;
    private final Vector3D i = new Vector3D(1, 0, 0);
    private final Vector3D j = new Vector3D(0, 1, 0);
    private final Vector3D k = new Vector3D(0, 0, 1);

    CapRays(final Camera camera, final int W, final int H, final FishEye projection) {
      super(camera, W, H);
      this.camera = camera;
      this.projection = projection;
      camera.toSceneCoordinates(i);
      camera.toSceneCoordinates(j);
      camera.toSceneCoordinates(k);
    }

    @Override
    public Ray getRay(final int m, final int n) {
      checkPixel(m, n);
      final double x = ((m + 0.5) / getWidth() - 0.5) * projection.size;
      final double y = ((n + 0.5) / getHeight() - 0.5) * projection.size, z = projection.zAt(x, y);
      return Double.isNaN(z) ? Ray.NORAY : Ray.towards(camera.eyeX(), camera.eyeY(), camera.eyeZ(),
          x * i.x + y * j.x + z * k.x, x * i.y + y * j.y + z * k.y, x * i.z + y * j.z + z * k.z);
    }
  }

  private final double size;

  /**
   * A fish-eye.
   *
   * @param fov full angle of view in degrees, 0 &lt; fov ≤ 180
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
    return new CapRays(holding(camera), W, H, this);
  }

  /** The cap of the unit sphere; at 180° its rim is at z = −0. */
  @Override
  public double zAt(final double x, final double y) {
    final double rho2 = x * x + y * y;
    return rho2 <= size * size / 4 ? -Math.sqrt(1 - rho2) : Double.NaN;
  }
}
