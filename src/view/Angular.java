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

  /**
   * A fish-eye.
   *
   * @param omega full opening of the field of view in degrees, 0 &lt; ω &lt; 180
   * @throws IllegalArgumentException if ω is out of its range
   */
  public Angular(final float omega) {
    super(2 * rim(omega), 2 * rim(omega));
    rim2 = rim(omega) * rim(omega);
  }

  private static double rim(final float omega) {
    return StrictMath.tan(Math.toRadians(between("omega", 0, 180, omega)) / 2);
  }

  @Override
  public RayGenerator getRayGenerator(final Camera camera, final int W, final int H) {
    return new AngularRayGenerator(holding(camera), W, H);
  }

  /** Rays from the camera through the points of the cap above (x, y), whose sphere has radius 1 / cos(ω/2). */
  static class AngularRayGenerator extends RayGenerator {

    private final Camera camera;
    private final Angular projection;

    AngularRayGenerator(final Camera camera, final int W, final int H) {
      super(camera, W, H);
      this.camera = camera;
      this.projection = (Angular) camera.getProjection();
    }

    @Override
    public Ray getRay(final int m, final int n) {
      checkPixel(m, n);
      final double a = projection.columnCentre(m, getWidth()), b = projection.rowCentre(n, getHeight()), z = z(a, b);
      return z < 0 ? Ray.towards(camera.eyeX(), camera.eyeY(), camera.eyeZ(),
          camera.vectorX(a, b, z), camera.vectorY(a, b, z), camera.vectorZ(a, b, z)) : Ray.NORAY;
    }

    @Override
    public void fill(final RayTile tile, final int m, final int n) {
      checkTile(tile, m, n);
      final double eyeX = camera.eyeX(), eyeY = camera.eyeY(), eyeZ = camera.eyeZ();
      final double[] x = projection.columnCentres(m, tile.columns(), getWidth());
      for (int row = 0; row < tile.rows(); row++) {
        final double b = projection.rowCentre(n + row, getHeight());
        for (int column = 0; column < tile.columns(); column++) {
          final double a = x[column], z = z(a, b);
          if (z < 0) {
            tile.put(row * RayTile.SIZE + column, eyeX, eyeY, eyeZ,
                camera.vectorX(a, b, z), camera.vectorY(a, b, z), camera.vectorZ(a, b, z));
          }
        }
      }
    }

    /** z of the cap above a point of the window; 0 outside the circle. */
    private double z(final double a, final double b) {
      final double rho2 = a * a + b * b;
      return rho2 <= projection.rim2 ? -Math.sqrt(1 + projection.rim2 - rho2) : 0;
    }
  }
}
