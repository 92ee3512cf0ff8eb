package view;

import static arguments.Arguments.between;
import static arguments.Arguments.positive;

import acceleration.Pencil;
import acceleration.RayTile;
import tracer.RayGenerator;

/**
 * The perspective of a pinhole camera: all rays start at its position. The window is at distance 1 in front of it, with h
 * = 2 tan(fov / 2) and w = a h.
 */
public class Perspective extends Projection {

  /**
   * A perspective.
   *
   * @param fov vertical angle of view in degrees, 0 &lt; fov &lt; 180
   * @param aspect width of the window divided by its height, &gt; 0
   * @throws IllegalArgumentException if an argument is out of its range
   */
  public Perspective(final float fov, final float aspect) {
    super(positive("aspect", aspect) * height(fov), height(fov));
  }

  private static double height(final float fov) {
    return 2 * StrictMath.tan(Math.toRadians(between("fov", 0, 180, fov)) / 2);
  }

  @Override
  public RayGenerator getRayGenerator(final Camera camera, final int W, final int H) {
    return new PerspectiveRayGenerator(holding(camera), W, H);
  }

  @Override
  public double zAt(final double x, final double y) {
    return -1;
  }

  /** Rays from the camera through the points of the window; a tile computes them itself, all at once. */
  static class PerspectiveRayGenerator extends CentralRayGenerator {

    private final Pencil pencil;

    PerspectiveRayGenerator(final Camera camera, final int W, final int H) {
      super(camera, W, H);
      this.pencil = camera.pencil();
    }

    @Override
    public void fill(final RayTile tile, final int m, final int n) {
      checkTile(tile, m, n);
      tile.fill(pencil, projection.columnCentres(m, tile.columns(), getWidth()), 0,
          projection.rowCentres(n, tile.rows(), getHeight()), 0);
    }
  }
}
