package rendering;

import static arguments.Arguments.notNull;
import static arguments.Arguments.positive;

/**
 * How an image is computed: what does not belong to the scene or the camera.
 *
 * @param threads number of threads, at least 1; the picture does not depend on it
 * @param shading how a hit becomes a colour
 * @param progress who watches
 * @param pixelLoop whether the pixels are computed one after the other by the loop of the assignment, on the calling thread
 *     alone; the picture does not depend on it
 */
public record RenderSettings(int threads, Shading shading, Progress progress, boolean pixelLoop) {

  /** The system property which, if true, has the pixels computed one after the other: for a debugger. */
  public static final String PIXEL_LOOP = "rendering.pixelLoop";

  /** All cores, plain colours, nobody watching. */
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
   * The same by the loop of the assignment, one pixel after the other.
   *
   * @return the new settings
   */
  public RenderSettings withPixelLoop() {
    return new RenderSettings(threads, shading, progress, true);
  }
}
