package rendering;

import static arguments.Arguments.notNull;
import static arguments.Arguments.within;

import java.util.concurrent.ThreadFactory;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;

import models.Group3D;
import tracer.RayGenerator;

/**
 * A picture with K × K rays for each pixel, in a regular grid: those of the camera for a picture K times as wide and K times
 * as high. A pixel is the mean of their colours in linear light, with alpha premultiplied. The picture is computed in
 * blocks, each by one thread, in the order of their rays, so its bits do not depend on the number of threads; a block is all
 * that is held of the K² times larger picture.
 */
public final class Supersampling {

  /** Greatest K. */
  public static final int MOST = 16;

  /** Rays along the side of a block: at K = 16 eight pixels. */
  private static final int BLOCK = 128;

  private final Group3D scene;
  private final RayGenerator generator;
  private final RenderSettings rendering;
  private final int samples;
  /** Side of a block, and size of the picture, in pixels. */
  private final int side;
  private final int W;
  private final int H;
  private final AtomicInteger next = new AtomicInteger();
  private final AtomicReference<Throwable> failure = new AtomicReference<>();
  private volatile boolean stopped;

  /**
   * A picture to be rendered.
   *
   * @param scene the scene
   * @param generator the rays, of a picture K times as wide and as high
   * @param samples K, 1 … {@value #MOST}
   * @param rendering how colours come about, by how many threads, and who watches
   * @throws IllegalArgumentException if an argument is null, or K out of range
   */
  public Supersampling(final Group3D scene, final RayGenerator generator, final int samples,
      final RenderSettings rendering) {
    this.scene = notNull("scene", scene);
    this.generator = notNull("generator", generator);
    within("samples", 1, MOST, (double) samples);
    this.samples = samples;
    this.rendering = notNull("rendering", rendering);
    this.side = BLOCK / samples;
    this.W = generator.getWidth() / samples;
    this.H = generator.getHeight() / samples;
  }

  /**
   * Renders the picture.
   *
   * @param pixels where it goes, as sRGB with alpha, the top row first
   * @param background pixel of rays without a hit
   * @param factory makes the threads beside the calling one
   * @return false if the rendering was stopped before its end
   */
  public boolean render(final int[] pixels, final int background, final ThreadFactory factory) {
    rendering.refresh(scene);
    final int across = (W + side - 1) / side, down = (H + side - 1) / side;
    final int[] order = TileOrder.centreOutwards(across, down);
    Workers.run(Math.min(rendering.pixelLoop() ? 1 : rendering.threads(), order.length), factory, () -> {
      final int[] rays = new int[side * samples * side * samples];
      try {
        for (int i = next.getAndIncrement(); i < order.length && !stopped; i = next.getAndIncrement()) {
          block(order[i] % across * side, order[i] / across * side, rays, pixels, background);
        }
      } catch (Throwable e) {
        failure.compareAndSet(null, e);
        stopped = true;
      }
    });
    Workers.rethrow(failure.get());
    return !stopped;
  }

  /** Renders the block whose lowest leftmost pixel is (m, n). */
  private void block(final int m, final int n, final int[] rays, final int[] pixels, final int background) {
    final int width = Math.min(side, W - m), height = Math.min(side, H - n);
    final int[] rectangle = {m * samples, n * samples, width * samples, height * samples};
    final RenderSettings alone = rendering.withThreads(1).withProgress((x, y, w, h) -> !stopped);
    if (!alone.renderPart(scene, new GeneratorWindow(generator, rectangle, samples), rendering.colours(rays, background),
        Thread::new)) {
      return;
    }
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        pixels[(H - n - height + y) * W + m + x] = mean(rays, y * samples * width * samples + x * samples, width * samples);
      }
    }
    if (!rendering.progress().tileDone(m, H - n - height, width, height)) {
      stopped = true;
    }
  }

  /** The mean colour of a square of rays. */
  private int mean(final int[] rays, final int first, final int row) {
    double r = 0, g = 0, b = 0;
    int alpha = 0, different = 0;
    for (int y = 0; y < samples; y++) {
      for (int i = first + y * row; i < first + y * row + samples; i++) {
        final int argb = rays[i], a = argb >>> 24;
        different |= argb ^ rays[first];
        alpha += a;
        r += a * SrgbEncoding.number(argb >> 16 & 0xff);
        g += a * SrgbEncoding.number(argb >> 8 & 0xff);
        b += a * SrgbEncoding.number(argb & 0xff);
      }
    }
    if (different == 0) {
      return rays[first];
    }
    final int count = samples * samples;
    return alpha == 0 ? 0
        : (alpha + count / 2) / count << 24 | SrgbEncoding.argb(r / alpha, g / alpha, b / alpha) & 0xffffff;
  }
}
