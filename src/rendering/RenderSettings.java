package rendering;

import static arguments.Arguments.notNull;
import static arguments.Arguments.positive;

import java.util.concurrent.ThreadFactory;

import models.Group3D;
import tracer.RayGenerator;

/**
 * How an image is computed: everything but the scene and the camera.
 *
 * @param threads number of threads, at least 1; the picture does not depend on it
 * @param shading how a hit becomes a colour
 * @param progress who watches
 * @param pixelLoop whether the pixels are computed one after the other by the loop of the assignment, on the calling thread
 *     alone; the picture does not depend on it
 */
public record RenderSettings(int threads, Shading shading, Progress progress, boolean pixelLoop) {

  /** The system property which, if true, selects the loop over the pixels, for a debugger. */
  public static final String PIXEL_LOOP = "rendering.pixelLoop";

  /** All cores, plain colours, no observer. */
  public static final RenderSettings STANDARD =
      new RenderSettings(Runtime.getRuntime().availableProcessors(), Shading.PLAIN, Progress.NONE);

  /**
   * Checks the parts.
   *
   * @param threads number of threads, at least 1; the picture does not depend on it
   * @param shading how a hit becomes a colour
   * @param progress who watches
   * @param pixelLoop whether the pixels are computed one after the other by the loop of the assignment
   * @throws IllegalArgumentException if there is no thread or a part is null
   */
  public RenderSettings {
    positive("threads", threads);
    notNull("shading", shading);
    notNull("progress", progress);
  }

  /**
   * The settings of a picture that is computed tile by tile, unless the system property {@link #PIXEL_LOOP} is true.
   *
   * @param threads number of threads, at least 1; the picture does not depend on it
   * @param shading how a hit becomes a colour
   * @param progress who watches
   * @throws IllegalArgumentException if there is no thread or a part is null
   */
  public RenderSettings(final int threads, final Shading shading, final Progress progress) {
    this(threads, shading, progress, Boolean.getBoolean(PIXEL_LOOP));
  }

  /**
   * Renders a picture.
   *
   * @param scene the scene
   * @param generator the rays of the picture, which give its size
   * @param picture what becomes of each pixel
   * @param factory makes the threads beside the calling one
   * @return false if the rendering was stopped before its end
   */
  public boolean render(final Group3D scene, final RayGenerator generator, final PixelWriter picture,
      final ThreadFactory factory) {
    refresh(scene);
    return pixelLoop ? new PixelLoop(scene, generator, progress, picture).run()
        : new TileRenderer(scene, generator, this, picture).run(factory);
  }

  /** Before a picture, queries the boxes of user-written shapes again. */
  void refresh(final Group3D scene) {
    scene.refresh();
    if (shading instanceof Illumination light) {
      light.scene().refresh();
    }
  }

  /** Renders a part of a picture, whose objects have not changed since its beginning. */
  boolean renderPart(final Group3D scene, final RayGenerator generator, final PixelWriter picture,
      final ThreadFactory factory) {
    return pixelLoop ? new PixelLoop(scene, generator, progress, picture).run()
        : new TileRenderer(scene, generator, this, picture).run(factory);
  }

  /**
   * A writer of the colours of this shading.
   *
   * @param pixels the destination, as sRGB with alpha, the top row first
   * @param background pixel without a hit
   * @return the writer
   */
  public PixelWriter colours(final int[] pixels, final int background) {
    return new ColourWriter(shading, pixels, background);
  }

  /**
   * The same with another number of threads.
   *
   * @param number number of threads, at least 1
   * @return the new settings
   */
  public RenderSettings withThreads(final int number) {
    return new RenderSettings(number, shading, progress, pixelLoop);
  }

  /**
   * The same with another shading.
   *
   * @param other the shading
   * @return the new settings
   */
  public RenderSettings withShading(final Shading other) {
    return new RenderSettings(threads, other, progress, pixelLoop);
  }

  /**
   * The same with another observer of the progress.
   *
   * @param other the watcher
   * @return the new settings
   */
  public RenderSettings withProgress(final Progress other) {
    return new RenderSettings(threads, shading, other, pixelLoop);
  }

  /**
   * The same settings with the loop of the assignment, one pixel after the other.
   *
   * @return the new settings
   */
  public RenderSettings withPixelLoop() {
    return new RenderSettings(threads, shading, progress, true);
  }
}
