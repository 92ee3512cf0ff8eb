package tracer;

import static arguments.Arguments.index;
import static arguments.Arguments.notNull;
import static arguments.Arguments.positive;
import static arguments.Arguments.wrongState;

import acceleration.RayTile;
import primitives.Vector3D;
import view.Camera;

/**
 * The rays that a camera sends through the pixels of an image, by its projection.
 *
 * <p>Columns are numbered from the left and rows from the bottom, both from 0. A subclass implements {@link #getRay} and
 * nothing else; one that can make many rays at less cost overrides {@link #fill} too.
 */
public abstract class RayGenerator {

  private final Camera camera;
  private final int W;
  private final int H;

  /**
   * The rays of a camera for an image of W × H pixels.
   *
   * @param camera the camera
   * @param W width of the image in pixels, at least 1
   * @param H height of the image in pixels, at least 1
   * @throws IllegalArgumentException if the camera is null or the image has no pixel
   */
  protected RayGenerator(final Camera camera, final int W, final int H) {
    this.camera = notNull("camera", camera);
    this.W = positive("W", W);
    this.H = positive("H", H);
  }

  /**
   * The ray through the centre of a pixel.
   *
   * @param m column, 0 … W − 1 from the left
   * @param n row, 0 … H − 1 from the bottom
   * @return the ray; {@link Ray#NORAY} if the projection sends none through this pixel
   * @throws IllegalArgumentException if there is no such pixel
   */
  public abstract Ray getRay(int m, int n);

  /**
   * Fills a tile with the rays of a rectangle of pixels: those that {@link #getRay} returns, bit for bit.
   *
   * @param tile the tile, opened for the size of the rectangle; the caller closes it
   * @param m column of its first pixel
   * @param n row of its first pixel; rows of the tile count upwards, as those of the image do
   * @throws IllegalArgumentException if the tile is null or extends beyond the image
   */
  public void fill(final RayTile tile, final int m, final int n) {
    checkTile(tile, m, n);
    for (int row = 0; row < tile.rows(); row++) {
      for (int column = 0; column < tile.columns(); column++) {
        final Ray ray = getRay(m + column, n + row);
        if (ray == null) {
          throw wrongState("nullRay", getClass().getName(), m + column, n + row);
        }
        if (ray != Ray.NORAY) {
          final Vector3D v = ray.getDirection();
          tile.putUnit(row * RayTile.SIZE + column, ray.startX(), ray.startY(), ray.startZ(), v.x, v.y, v.z);
        }
      }
    }
  }

  /**
   * Checks a pixel, as {@link #getRay} does.
   *
   * @param m column
   * @param n row
   * @throws IllegalArgumentException if there is no such pixel
   */
  protected final void checkPixel(final int m, final int n) {
    index("m", W, m);
    index("n", H, n);
  }

  /**
   * Checks a tile, as {@link #fill} does.
   *
   * @param tile the tile
   * @param m column of its first pixel
   * @param n row of its first pixel
   * @throws IllegalArgumentException if the tile is null or extends beyond the image
   */
  protected final void checkTile(final RayTile tile, final int m, final int n) {
    notNull("tile", tile);
    checkPixel(m, n);
    checkPixel(m + tile.columns() - 1, n + tile.rows() - 1);
  }

  /**
   * The camera whose rays these are.
   *
   * @return the camera
   */
  public final Camera getCamera() {
    return camera;
  }

  /**
   * Width of the image.
   *
   * @return number of columns
   */
  public final int getWidth() {
    return W;
  }

  /**
   * Height of the image.
   *
   * @return number of rows
   */
  public final int getHeight() {
    return H;
  }
}
