package view;

import static arguments.Arguments.between;

import acceleration.RayTile;
import tracer.Ray;
import tracer.RayGenerator;

/**
 * A fish-eye: the scene is projected onto the cap of a sphere about the camera whose rim, of half-angle ω/2, lies in the
 * plane z = −1 of the camera's frame. So the window is square with w = h = 2 tan(ω/2), and pixels outside the circle of
 * the rim have no ray.
 */
public class Angular extends Projection {

  private final double rim2;
  private final double radius2;

  /**
   * A fish-eye.
   *
   * @param omega full opening of the field of view in degrees, 0 &lt; ω &lt; 180
   * @throws IllegalArgumentException if ω is out of its range
   */
  public Angular(final float omega) {
    super(2 * rim(omega), 2 * rim(omega));
    rim2 = rim(omega) * rim(omega);
    radius2 = 1 + rim2;
  }

  private static double rim(final float omega) {
    return Math.tan(Math.toRadians(between("omega", 0, 180, omega)) / 2);
  }

  @Override
  public RayGenerator getRayGenerator(final Camera camera, final int W, final int H) {
    return new AngularRayGenerator(holding(camera), W, H);
  }

  /** Rays from the camera through the points of the cap above (x, y), whose sphere has radius 1 / cos(ω/2). */
  static class AngularRayGenerator extends RayGenerator {

    private final Angular projection;
    private final Camera camera;

    AngularRayGenerator(final Camera camera, final int W, final int H) {
      super(camera, W, H);
      projection = (Angular) camera.getProjection();
      this.camera = camera;
    }

    @Override
    public Ray getRay(final int m, final int n) {
      checkPixel(m, n);
      final double x = projection.windowX(m, getWidth()), y = projection.windowY(n, getHeight());
      if (x * x + y * y > projection.rim2) {
        return Ray.NORAY;
      }
      final double z = -Math.sqrt(projection.radius2 - (x * x + y * y));
      return Ray.towards(camera.eyeX(), camera.eyeY(), camera.eyeZ(), camera.vectorX(x, y, z), camera.vectorY(x, y, z), camera.vectorZ(x, y, z));
    }

    @Override
    public void fill(final RayTile tile, final int m, final int n) {
      checkTile(tile, m, n);
      for (int row = 0; row < tile.rows(); row++) {
        final double y = projection.windowY(n + row, getHeight());
        for (int column = 0; column < tile.columns(); column++) {
          final double x = projection.windowX(m + column, getWidth());
          if (x * x + y * y <= projection.rim2) {
            final double z = -Math.sqrt(projection.radius2 - (x * x + y * y));
            tile.put(row * RayTile.SIZE + column, camera.eyeX(), camera.eyeY(), camera.eyeZ(),
                camera.vectorX(x, y, z), camera.vectorY(x, y, z), camera.vectorZ(x, y, z));
          }
        }
      }
    }
  }
}
