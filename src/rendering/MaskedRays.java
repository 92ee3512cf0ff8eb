package rendering;

import acceleration.RayTile;
import tracer.Ray;
import tracer.RayGenerator;

/** The rays of some of the pixels of a rectangle; the other pixels have none. */
final class MaskedRays extends GeneratorWindow {

  private final int samples;
  private final int width;
  private final boolean[] wanted;
  private final int first;

  /**
   * The rays of some pixels.
   *
   * @param rays the rays of the whole picture
   * @param rectangle column and row of the lowest leftmost pixel, width and height in pixels
   * @param samples rays along the side of a pixel
   * @param wanted for each pixel, row by row from the lowest, whether its rays are wanted
   * @param first place of the lowest leftmost pixel among these
   */
  MaskedRays(final RayGenerator rays, final int[] rectangle, final int samples, final boolean[] wanted, final int first) {
    super(rays, new int[] {rectangle[0] * samples, rectangle[1] * samples, rectangle[2] * samples, rectangle[3] * samples},
        samples);
    this.samples = samples;
    this.width = rectangle[2];
    this.wanted = wanted;
    this.first = first;
  }

  /** Whether no pixel has rays. */
  boolean isEmpty() {
    for (int i = 0; i < width * (getHeight() / samples); i++) {
      if (wanted[first + i]) {
        return false;
      }
    }
    return true;
  }

  private boolean isWanted(final int m, final int n) {
    return wanted[first + n / samples * width + m / samples];
  }

  @Override
  public Ray getRay(final int m, final int n) {
    checkPixel(m, n);
    return isWanted(m, n) ? super.getRay(m, n) : Ray.NORAY;
  }

  /** Removes unwanted rays from a closed tile whose first ray is (m, n); returns whether any is left. */
  boolean mask(final RayTile tile, final int m, final int n) {
    boolean any = false;
    for (int row = 0; row < tile.rows(); row++) {
      for (int column = 0; column < tile.columns(); column++) {
        final boolean stays = isWanted(m + column, n + row);
        any |= stays;
        if (!stays) {
          tile.remove(row * RayTile.SIZE + column);
        }
      }
    }
    return any;
  }
}
