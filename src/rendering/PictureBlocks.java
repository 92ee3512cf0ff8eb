package rendering;

import java.util.concurrent.ThreadFactory;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;

import models.Group3D;

/**
 * The square blocks of a picture, distributed among threads from its centre outwards. Each block is computed by one
 * thread, so its contents do not depend on the number of threads.
 */
final class PictureBlocks {

  /** Computes blocks; one for each thread. */
  @FunctionalInterface
  interface BlockRenderer {

    /**
     * Computes the block whose lowest leftmost pixel is (m, n).
     *
     * @return false if it was stopped before its end
     */
    boolean render(int m, int n, int width, int height);
  }

  private final int W;
  private final int H;
  private final int side;
  private final AtomicInteger next = new AtomicInteger();
  private final AtomicReference<Throwable> failure = new AtomicReference<>();
  private volatile boolean stopped;

  PictureBlocks(final int W, final int H, final int side) {
    this.W = W;
    this.H = H;
    this.side = side;
  }

  /**
   * Computes all blocks, once.
   *
   * @param scene the scene
   * @param rendering number of threads, and observer
   * @param factory makes the threads beside the calling one
   * @param renderers makes renderers of blocks, from settings for the parts of a block
   * @return false if the rendering was stopped before its end
   */
  boolean render(final Group3D scene, final RenderSettings rendering, final ThreadFactory factory,
      final Function<RenderSettings, BlockRenderer> renderers) {
    rendering.refresh(scene);
    final int across = (W + side - 1) / side, down = (H + side - 1) / side;
    final int[] order = TileOrder.centreOutwards(across, down);
    final RenderSettings alone = rendering.withThreads(1).withProgress((x, y, w, h) -> !stopped);
    Workers.run(Math.min(rendering.pixelLoop() ? 1 : rendering.threads(), order.length), factory, () -> {
      try {
        final BlockRenderer renderer = renderers.apply(alone);
        for (int i = next.getAndIncrement(); i < order.length && !stopped; i = next.getAndIncrement()) {
          render(order[i] % across * side, order[i] / across * side, renderer, rendering.progress());
        }
      } catch (Throwable e) {
        failure.compareAndSet(null, e);
        stopped = true;
      }
    });
    Workers.rethrow(failure.get());
    return !stopped;
  }

  private void render(final int m, final int n, final BlockRenderer renderer, final Progress progress) {
    final int width = Math.min(side, W - m), height = Math.min(side, H - n);
    if (renderer.render(m, n, width, height) && !progress.tileDone(m, H - n - height, width, height)) {
      stopped = true;
    }
  }
}
