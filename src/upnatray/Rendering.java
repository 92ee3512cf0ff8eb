package upnatray;

import static arguments.Arguments.notNull;
import static arguments.Arguments.positive;

/**
 * How an image is computed: what does not belong to the scene or the camera.
 *
 * @param threads number of threads, at least 1; the picture does not depend on it
 * @param shading how a hit becomes a colour
 * @param progress who watches
 */
public record Rendering(int threads, Shading shading, Progress progress) {

  /** All cores, plain colours, nobody watching. */
  public static final Rendering STANDARD =
      new Rendering(Runtime.getRuntime().availableProcessors(), Shading.PLAIN, Progress.NONE);

  /**
   * Checks the parts.
   *
   * @param threads number of threads, at least 1; the picture does not depend on it
   * @param shading how a hit becomes a colour
   * @param progress who watches
   * @throws IllegalArgumentException if there is no thread or a part is null
   */
  public Rendering {
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
  public Rendering withThreads(final int number) {
    return new Rendering(number, shading, progress);
  }

  /**
   * The same with another shading.
   *
   * @param other the shading
   * @return the new rendering
   */
  public Rendering withShading(final Shading other) {
    return new Rendering(threads, other, progress);
  }

  /**
   * The same with another watcher.
   *
   * @param other the watcher
   * @return the new rendering
   */
  public Rendering withProgress(final Progress other) {
    return new Rendering(threads, shading, other);
  }
}
