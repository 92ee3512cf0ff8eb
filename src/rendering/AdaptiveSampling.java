package rendering;

import static arguments.Arguments.notNull;
import static arguments.Arguments.within;

import java.util.concurrent.ThreadFactory;

import models.Group3D;
import tracer.RayGenerator;

/**
 * A picture with K × K rays for only those pixels that an edge may cross; see {@link Supersampling}. First each pixel
 * gets one ray, through its centre. Those are refined whose red, green, blue or alpha, in sRGB of 255, differs from that
 * of the neighbour at the left, at the right, above or below by more than {@value #STEP}; or by more than {@value #EDGE}
 * where they show different objects, or lie in the shadow of different lights (of the first 64). Four neighbours are
 * enough: of a straight edge a x + b y = c across the pixel about the origin, |c| ≤ (|a| + |b|) / 2 ≤ max(|a|, |b|), the
 * centre of one of them lies on the other side, or on the edge.
 *
 * <p>A pixel that is refined has exactly the value of {@link Supersampling}, any other exactly that of the picture with
 * one ray. (For even K the ray through the centre is not one of the K × K. Using one of these instead would shift unrefined
 * pixels by a fraction of a pixel against refined ones.) Details smaller than the distance between rays can be missed.
 *
 * <p>Sources: Whitted, "An improved illumination model for shaded display", Communications of the ACM 23(6), 1980, which
 * samples a pixel more densely where the samples about it differ; Mitchell, "Generating antialiased images at low
 * sampling densities", SIGGRAPH 1987, whose test is the contrast of neighbouring samples in each channel. Instead of
 * contrasts of light this class uses differences of sRGB, which is perceptually about uniform.
 */
public final class AdaptiveSampling {

  /** The difference of a channel up to which neighbours count as equal, of 255. */
  public static final int STEP = 96;

  /** The same for neighbours of different objects, or in different shadows. */
  public static final int EDGE = 64;

  private final Group3D scene;
  private final RayGenerator coarse;
  private final RayGenerator fine;
  private final int samples;
  private final RenderSettings rendering;

  /**
   * A picture to be rendered.
   *
   * @param scene the scene
   * @param coarse the rays of the picture, one for each pixel
   * @param fine the rays of a picture K times as wide and as high
   * @param samples K, 1 … {@value Supersampling#MOST}
   * @param rendering how pixels are coloured, the number of threads, and the observer
   * @throws IllegalArgumentException if an argument is null, or K out of range
   */
  public AdaptiveSampling(final Group3D scene, final RayGenerator coarse, final RayGenerator fine, final int samples,
      final RenderSettings rendering) {
    this.scene = notNull("scene", scene);
    this.coarse = notNull("coarse", coarse);
    this.fine = notNull("fine", fine);
    within("samples", 1, Supersampling.MOST, (double) samples);
    this.samples = samples;
    this.rendering = notNull("rendering", rendering);
  }

  /**
   * Renders a band of the picture. Its pixels do not depend on where it ends, as neighbours outside it are examined too.
   *
   * @param bottom its lowest row, from 0
   * @param rows number of rows
   * @param pixels where it goes, as sRGB with alpha, the top row first
   * @param background pixel of rays without a hit
   * @param factory makes the threads beside the calling one
   * @return false if the rendering was stopped before its end
   */
  public boolean render(final int bottom, final int rows, final int[] pixels, final int background,
      final ThreadFactory factory) {
    final int W = coarse.getWidth();
    return new PictureBlocks(W, rows, AdaptiveBlock.SIDE).render(scene, rendering, factory, settings -> {
      final AdaptiveBlock block = new AdaptiveBlock(scene, coarse, fine, samples, settings, background);
      return (m, n, width, height) -> block.render(m, bottom + n, width, height, pixels, (rows - n - height) * W + m);
    });
  }
}
