package rendering;

import models.Group3D;
import tracer.RayGenerator;

/** Renders blocks of a picture by {@link AdaptiveSampling}; working space of one thread. */
final class AdaptiveBlock {

  /** Side of a block in pixels: with the neighbours at each side it is a whole number of tiles. */
  static final int SIDE = 94;
  private static final int MARGIN = 1;

  /** Greatest number of rays of refined pixels that are held at a time. */
  private static final int MOST_RAYS = 1 << 18;

  private final Group3D scene;
  private final RayGenerator coarse;
  private final RayGenerator fine;
  private final int samples;
  private final RenderSettings settings;
  private final int[] centres = new int[(SIDE + 2 * MARGIN) * (SIDE + 2 * MARGIN)];
  private final EdgeDetector edges;
  private final boolean[] refined = new boolean[SIDE * SIDE];
  private final int[] rays = new int[MOST_RAYS];
  private final PixelWriter colours;

  AdaptiveBlock(final Group3D scene, final RayGenerator coarse, final RayGenerator fine, final int samples,
      final RenderSettings settings, final int background) {
    this.scene = scene;
    this.coarse = coarse;
    this.fine = fine;
    this.samples = samples;
    this.settings = settings;
    this.edges = new EdgeDetector(scene, settings.shading(), centres, background);
    this.colours = settings.colours(rays, background);
  }

  /**
   * Renders the block whose lowest leftmost pixel is (m, n).
   *
   * @param pixels where it goes
   * @param at place of its top left pixel there
   * @return false if it was stopped before its end
   */
  boolean render(final int m, final int n, final int width, final int height, final int[] pixels, final int at) {
    final int left = Math.max(0, m - MARGIN), right = Math.min(coarse.getWidth(), m + width + MARGIN);
    final int below = Math.max(0, n - MARGIN), above = Math.min(coarse.getHeight(), n + height + MARGIN);
    final int W = right - left, H = above - below;
    if (!settings.renderPart(scene, GeneratorWindow.ofPixels(coarse, left, below, W, H, 1), edges, Thread::new)) {
      return false;
    }
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        final int column = m - left + x, row = above - n - height + y;
        pixels[at + y * coarse.getWidth() + x] = centres[row * W + column];
        refined[(height - 1 - y) * width + x] = isAtEdge(column, row, W, H);
      }
    }
    final int most = MOST_RAYS / (width * samples * samples);
    for (int from = 0; from < height; from += most) {
      final int rows = Math.min(most, height - from);
      if (!refine(m, n, width, from, rows, pixels, at + (height - from - rows) * coarse.getWidth())) {
        return false;
      }
    }
    return true;
  }

  private boolean isAtEdge(final int column, final int row, final int W, final int H) {
    final int i = row * W + column;
    return column > 0 && edges.isEdge(i, i - 1) || column < W - 1 && edges.isEdge(i, i + 1)
        || row > 0 && edges.isEdge(i, i - W) || row < H - 1 && edges.isEdge(i, i + W);
  }

  /** Refines, in some rows of the block, the pixels that need it. */
  private boolean refine(final int m, final int n, final int width, final int from, final int rows, final int[] pixels,
      final int at) {
    final MaskedRays masked = new MaskedRays(fine, new int[] {m, n + from, width, rows}, samples, refined, from * width);
    if (masked.isEmpty()) {
      return true;
    }
    if (!settings.renderPart(scene, masked, colours, Thread::new)) {
      return false;
    }
    for (int y = 0; y < rows; y++) {
      for (int x = 0; x < width; x++) {
        if (refined[(from + rows - 1 - y) * width + x]) {
          pixels[at + y * coarse.getWidth() + x] = Supersampling.mean(rays, x, y, width, samples);
        }
      }
    }
    return true;
  }
}
