package upnatray;

import static arguments.Arguments.index;
import static arguments.Arguments.positive;
import static arguments.Arguments.within;
import static arguments.Arguments.wrong;

import rendering.GeneratorWindow;
import rendering.Supersampling;
import tracer.RayGenerator;
import view.Camera;

/**
 * How many pixels a picture has, and how many rays each pixel.
 *
 * @param W width of the picture in pixels, at least 1
 * @param H height of the whole picture in pixels, at least 1
 * @param samples K for K × K rays per pixel, 1 … 16
 * @param adaptive whether only the pixels at edges get them, and the others one
 * @param top the first row to be rendered, from 0 at the top
 * @param rows number of rows that are rendered, at least 1
 */
record Resolution(int W, int H, int samples, boolean adaptive, int top, int rows) {

  Resolution {
    positive("W", W);
    positive("H", H);
    within("samples", 1, Supersampling.MOST, (double) samples);
    if ((long) Math.max(W, H) * samples > Integer.MAX_VALUE) {
      throw wrong("imageSize", (long) W * samples, (long) H * samples, Integer.MAX_VALUE);
    }
    index("top", H, top);
    index("rows", H - top, positive("rows", rows) - 1);
  }

  /** A picture, or a band of one, with the same number of rays for each pixel. */
  Resolution(final int W, final int H, final int samples, final int top, final int rows) {
    this(W, H, samples, false, top, rows);
  }

  /** A whole picture of one ray per pixel. */
  static Resolution of(final int W, final int H) {
    return new Resolution(W, H, 1, 0, positive("H", H));
  }

  /** The lowest of the rows that are rendered, from 0 at the bottom. */
  int bottom() {
    return H - top - rows;
  }

  /** The rays of the rows that are rendered, K × K for each pixel. */
  RayGenerator rays(final Camera camera) {
    return GeneratorWindow.rows(wholeRays(camera), bottom() * samples, rows * samples);
  }

  /** The rays of the whole picture, K × K for each pixel. */
  RayGenerator wholeRays(final Camera camera) {
    return camera.getRayGenerator(W * samples, H * samples);
  }
}
