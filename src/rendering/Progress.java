package rendering;

/**
 * Watches the progress of a rendering, and may stop it. Called by the rendering threads, so it must be quick and
 * thread-safe.
 */
@FunctionalInterface
public interface Progress {

  /** Watches nothing and never stops. */
  Progress NONE = (x, y, width, height) -> true;

  /**
   * Called when a rectangle of the image is finished.
   *
   * @param x its first column in the {@code BufferedImage}
   * @param y its first row in the {@code BufferedImage}, which counts from the top
   * @param width its number of columns
   * @param height its number of rows
   * @return whether to go on; false stops after the tiles that are being computed
   */
  boolean tileDone(int x, int y, int width, int height);
}
