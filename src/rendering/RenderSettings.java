package rendering;

import static arguments.Arguments.notNull;
import static arguments.Arguments.positive;

/**
 * How an image is computed: what does not belong to the scene or the camera.
 *
 * @param threads number of threads, at least 1; the picture does not depend on it
 * @param shading how a hit becomes a colour
 * @param progress who watches
 */
public record RenderSettings(int threads, Shading shading, Progress progress) {

  /** All cores, plain colours, nobody watching. */
  public static final RenderSettings STANDARD =
      new RenderSettings(Runtime.getRuntime().availableProcessors(), Shading.PLAIN, Progress.NONE);

  /**
   * Checks the parts.
   *
   * @param threads number of threads, at least 1; the picture does not depend on it
   * @param shading how a hit becomes a colour
   * @param progress who watches
   * @throws IllegalArgumentException if there is no thread or a part is null
   */
  public RenderSettings {
    positive("threads", threads);
    notNull("shading", shading);
    notNull("progress", progress);
  }

  /**
   * The same with another number of threads.
   *
   * @param number number of threads, at least 1
   * @return the new rendering
   */
  public RenderSettings withThreads(final int number) {
    return new RenderSettings(number, shading, progress);
  }

  /**
   * The same with another shading.
   *
   * @param other the shading
   * @return the new rendering
   */
  public RenderSettings withShading(final Shading other) {
    return new RenderSettings(threads, other, progress);
  }

  /**
   * The same with another watcher.
   *
   * @param other the watcher
   * @return the new rendering
   */
  public RenderSettings withProgress(final Progress other) {
    return new RenderSettings(threads, shading, other);
  }
}
