package upnatray;

import static arguments.Arguments.notNull;
import static arguments.Arguments.positive;
import static arguments.Arguments.wrong;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Arrays;
import java.util.concurrent.ThreadFactory;

import lights.LightGroup;
import models.Group3D;
import rendering.AdaptiveSampling;
import rendering.Illumination;
import rendering.RenderSettings;
import rendering.Supersampling;
import tracer.RayGenerator;
import view.Camera;

/**
 * An image in sRGB with transparency that can be synthesised from a scene seen by a camera.
 *
 * <p>Row 0 of the assignment's pixels is the bottom one: pixel (m, n) of the rays is {@code getRGB(m, H - 1 - n)}.
 */
public class Image extends BufferedImage {

  private static final int RECURSION_DEPTH = 5;

  private final int background;

  /**
   * An image filled with its background.
   *
   * @param W width in pixels, at least 1
   * @param H height in pixels, at least 1
   * @param background colour of the pixels whose ray hits nothing
   * @throws IllegalArgumentException if there is no pixel, if there are more than an array can hold, or if the background is
   *     null
   */
  @SuppressWarnings("this-escape") // The raster is complete once the constructor of BufferedImage has returned.
  public Image(final int W, final int H, final Color background) {
    super(positive("W", W), height(W, H), TYPE_INT_ARGB);
    this.background = notNull("background", background).getRGB();
    Arrays.fill(pixels(), this.background);
  }

  /** The height of an image, checked: an array has to hold all pixels. */
  static int height(final int W, final int H) {
    if ((long) W * positive("H", H) > Integer.MAX_VALUE - 8) {
      throw wrong("imageSize", W, H, Integer.MAX_VALUE - 8);
    }
    return H;
  }

  /**
   * Computes all pixels: for each the ray of the camera's projection, its closest hit in the scene, and the colour of what
   * is hit, or the background. All cores work on it; the pixels are the same, bit for bit, whatever their number.
   *
   * @param scene the scene, which must not change meanwhile
   * @param camera the camera
   * @throws IllegalArgumentException if an argument is null
   * @throws IllegalStateException if the camera has no projection
   */
  public void synthesis(final Group3D scene, final Camera camera) {
    synthesis(scene, camera, RenderSettings.STANDARD);
  }

  /**
   * Computes the pixels as {@link #synthesis(Group3D, Camera)} does, with settings.
   *
   * @param scene the scene, which must not change meanwhile
   * @param camera the camera
   * @param rendering how to compute them
   * @return false if it was stopped before all pixels were computed
   * @throws IllegalArgumentException if an argument is null
   * @throws IllegalStateException if the camera has no projection
   */
  public boolean synthesis(final Group3D scene, final Camera camera, final RenderSettings rendering) {
    notNull("scene", scene);
    notNull("rendering", rendering);
    return rendering.render(scene, notNull("camera", camera).getRayGenerator(getWidth(), getHeight()),
        rendering.colours(pixels(), background), Thread::new);
  }

  /**
   * Computes all pixels of a lit scene, by {@link RenderSettings#STANDARD} and an {@link Illumination} before this image's
   * background, with rays up to depth 5.
   *
   * @param scene the scene, which must not change meanwhile
   * @param camera the camera
   * @param lights the lights
   * @throws IllegalArgumentException if an argument is null
   * @throws IllegalStateException if the camera has no projection
   */
  public void synthesis(final Group3D scene, final Camera camera, final LightGroup lights) {
    synthesis(scene, camera, RenderSettings.STANDARD.withShading(
        new Illumination(scene, lights, RECURSION_DEPTH, new Color(background, true))));
  }

  /** The same with threads from the given factory, whose time can be measured. */
  boolean synthesis(final Group3D scene, final Camera camera, final RenderSettings rendering, final ThreadFactory threads) {
    notNull("scene", scene);
    notNull("rendering", rendering);
    return rendering.render(scene, notNull("camera", camera).getRayGenerator(getWidth(), getHeight()),
        rendering.colours(pixels(), background), threads);
  }

  /** Computes the pixels by the given rays, a square of them for each pixel. */
  boolean synthesis(final Group3D scene, final RayGenerator rays, final int samples, final RenderSettings rendering) {
    return samples == 1 ? rendering.render(scene, rays, rendering.colours(pixels(), background), Thread::new)
        : new Supersampling(scene, rays, samples, rendering).render(pixels(), background, Thread::new);
  }

  /** Computes the pixels of a picture of this size, or of a band of one. */
  boolean synthesis(final Group3D scene, final Camera camera, final Resolution resolution, final RenderSettings rendering) {
    final int K = resolution.samples();
    if (resolution.adaptive()) {
      return new AdaptiveSampling(scene, camera.getRayGenerator(resolution.W(), resolution.H()),
          resolution.wholeRays(camera), K, rendering)
          .render(resolution.bottom(), resolution.rows(), pixels(), background, Thread::new);
    }
    // For one ray per pixel, not by the method above: from Main to a shape there are at most twelve calls.
    return K > 1 ? synthesis(scene, resolution.rays(camera), K, rendering)
        : rendering.render(scene, resolution.rays(camera), rendering.colours(pixels(), background), Thread::new);
  }

  private int[] pixels() {
    return ((DataBufferInt) getRaster().getDataBuffer()).getData();
  }
}
