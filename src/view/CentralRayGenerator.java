package view;

import acceleration.RayTile;
import tracer.Ray;
import tracer.RayGenerator;

/** Rays from the camera through the points (x, y, z) of its frame, z being given by {@link Projection#zAt}. */
abstract class CentralRayGenerator extends RayGenerator {

  final Projection projection;
  private final Camera camera;

  /** The rays of a camera by the projection that it holds. */
  CentralRayGenerator(final Camera camera, final int W, final int H) {
    super(camera, W, H);
    this.camera = camera;
    this.projection = camera.getProjection();
  }

  @Override
  public Ray getRay(final int m, final int n) {
    checkPixel(m, n);
    final double x = projection.columnCentre(m, getWidth()), y = projection.rowCentre(n, getHeight());
    final double z = projection.zAt(x, y);
    return Double.isNaN(z) ? Ray.NORAY : Ray.towards(camera.eyeX(), camera.eyeY(), camera.eyeZ(),
        camera.vectorX(x, y, z), camera.vectorY(x, y, z), camera.vectorZ(x, y, z));
  }

  @Override
  public void fill(final RayTile tile, final int m, final int n) {
    checkTile(tile, m, n);
    final double eyeX = camera.eyeX(), eyeY = camera.eyeY(), eyeZ = camera.eyeZ();
    final double[] columns = projection.columnCentres(m, tile.columns(), getWidth());
    for (int row = 0; row < tile.rows(); row++) {
      final double y = projection.rowCentre(n + row, getHeight());
      for (int column = 0; column < tile.columns(); column++) {
        final double x = columns[column], z = projection.zAt(x, y);
        if (!Double.isNaN(z)) {
          tile.put(row * RayTile.SIZE + column, eyeX, eyeY, eyeZ,
              camera.vectorX(x, y, z), camera.vectorY(x, y, z), camera.vectorZ(x, y, z));
        }
      }
    }
  }
}
