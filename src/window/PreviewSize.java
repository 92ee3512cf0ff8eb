package window;

/**
 * How many pixels a coarse picture may have so that enough of them are shown in a second. The speed is the mean of the last
 * few pictures, as other programs may delay single ones. Thread-safe.
 */
final class PreviewSize {

  /** Duration of a picture, in seconds, that leaves time to show 25 of them a second. */
  static final double SECONDS = 0.03;

  /** Least number of pixels. */
  private static final double LEAST = 1500;

  /** Limits of the ratio of a number of pixels to the last one. */
  private static final double SMALLEST_STEP = 0.3;
  private static final double LARGEST_STEP = 1.6;

  /** Factor by which the weight of earlier pictures decreases with each new one. */
  private static final double MEMORY = 0.8;

  private double pixels = 30_000;
  private double rendered;
  private double seconds;

  /** The number of pixels for the next picture. */
  synchronized double pixels() {
    return pixels;
  }

  /** Takes note of the time that a picture took. */
  synchronized void add(final double itsPixels, final double itsSeconds) {
    rendered = MEMORY * rendered + itsPixels;
    seconds = MEMORY * seconds + itsSeconds;
    final double wanted = SECONDS * rendered / Math.max(seconds, Double.MIN_NORMAL);
    pixels = Math.max(LEAST, Math.max(SMALLEST_STEP * itsPixels, Math.min(LARGEST_STEP * itsPixels, wanted)));
  }
}
