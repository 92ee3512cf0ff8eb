package rendering;

import static arguments.Arguments.notNull;
import static arguments.Arguments.within;

import java.util.concurrent.ThreadFactory;

import models.Group3D;
import tracer.RayGenerator;

/**
 * A picture with K × K rays for each pixel, in a regular grid: those of the camera for a picture K times as wide and K
 * times as high. A pixel is the mean of their colours in linear light, with alpha premultiplied. The picture is computed
 * in blocks, each by one thread, in the order of their rays, so its bits do not depend on the number of threads. Only a
 * block of the K² times larger picture is in memory.
 *
 * <p><img src="doc-files/Supersampling.png" width="320" height="106" alt="Jagged edges, and smooth ones">
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
    final int W = generator.getWidth() / samples, H = generator.getHeight() / samples;
    return new PictureBlocks(W, H, BLOCK / samples).render(scene, rendering, factory, settings -> {
      final int[] rays = new int[BLOCK * BLOCK];
      final PixelWriter colours = rendering.colours(rays, background);
      return (m, n, width, height) -> {
        final GeneratorWindow window = GeneratorWindow.ofPixels(generator, m, n, width, height, samples);
        if (!settings.renderPart(scene, window, colours, Thread::new)) {
          return false;
        }
        for (int y = 0; y < height; y++) {
          for (int x = 0; x < width; x++) {
            pixels[(H - n - height + y) * W + m + x] = mean(rays, x, y, width, samples);
          }
        }
        return true;
      };
    });
  }

  /**
   * The mean colour of the rays of a pixel.
   *
   * @param rays the colours of the rays of a rectangle of pixels, row by row
   * @param x column of the pixel in the rectangle
   * @param y row of the pixel in the rectangle
   * @param width width of the rectangle in pixels
   * @param samples rays along the side of a pixel
   */
  static int mean(final int[] rays, final int x, final int y, final int width, final int samples) {
    final int row = width * samples, first = y * samples * row + x * samples;
    double r = 0, g = 0, b = 0;
    int alpha = 0, different = 0;
    for (int j = 0; j < samples; j++) {
      for (int i = first + j * row; i < first + j * row + samples; i++) {
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
