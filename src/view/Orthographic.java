package view;

import static arguments.Arguments.positive;

import acceleration.RayTile;
import tracer.Ray;
import tracer.RayGenerator;

/**
 * The parallel projection along the camera's view: all rays have the direction of the view and start in the window,
 * which is centred on the camera.
 */
public class Orthographic extends Projection {

  /**
   * A parallel projection. Here, and only here, the aspect is height divided by width.
   *
   * @param h height of the window in scene units, &gt; 0
   * @param aspect height of the window divided by its width, &gt; 0, so that w = h / aspect
   * @throws IllegalArgumentException if an argument is not positive or not finite
   */
  public Orthographic(final float h, final float aspect) {
    super(positive("h", h) / (double) positive("aspect", aspect), h);
  }

  @Override
  public RayGenerator getRayGenerator(final Camera camera, final int W, final int H) {
    return new OrthographicRayGenerator(holding(camera), W, H);
  }

  /** The window contains the camera. */
  @Override
  public double zAt(final double x, final double y) {
    return 0;
  }

  /** Rays along the view from the points (x, y, 0) of the camera's frame. */
  static class OrthographicRayGenerator extends RayGenerator {

    private final Camera camera;
    private final Projection projection;

    OrthographicRayGenerator(final Camera camera, final int W, final int H) {
      super(camera, W, H);
      this.camera = camera;
      this.projection = camera.getProjection();
    }

    @Override
    public Ray getRay(final int m, final int n) {
      checkPixel(m, n);
      final double x = projection.columnCentre(m, getWidth()), y = projection.rowCentre(n, getHeight());
      return Ray.towards(camera.pointX(x, y), camera.pointY(x, y), camera.pointZ(x, y),
          camera.vectorX(0, 0, -1), camera.vectorY(0, 0, -1), camera.vectorZ(0, 0, -1));
    }

    @Override
    public void fill(final RayTile tile, final int m, final int n) {
      checkTile(tile, m, n);
      final double dx = camera.vectorX(0, 0, -1), dy = camera.vectorY(0, 0, -1), dz = camera.vectorZ(0, 0, -1);
      final double[] columns = projection.columnCentres(m, tile.columns(), getWidth());
      for (int row = 0; row < tile.rows(); row++) {
        final double y = projection.rowCentre(n + row, getHeight());
        for (int column = 0; column < tile.columns(); column++) {
          final double x = columns[column];
          tile.put(row * RayTile.SIZE + column, camera.pointX(x, y), camera.pointY(x, y), camera.pointZ(x, y), dx, dy, dz);
        }
      }
    }
  }
}
