package window;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The requested size of a picture: a percentage of the size given by the scene, or a size in pixels.
 *
 * @param percent percentage of the scene's size; 0 if width or height is given
 * @param width width in pixels; 0 if a percentage is given, or to preserve the aspect ratio
 * @param height height in pixels; 0 as for the width
 */
record PictureSize(int percent, int width, int height) {

  /** The size given by the scene. */
  static final PictureSize OWN = new PictureSize(100, 0, 0);

  private static final Pattern PERCENT = Pattern.compile("\\s*(\\d{1,4})\\s*%\\s*");
  private static final Pattern PIXELS = Pattern.compile("\\s*([1-9]\\d{0,5}|\\?)\\s*[x×*,; ]\\s*([1-9]\\d{0,5}|\\?)\\s*");

  /** Parses a size such as {@code 50 %}, {@code 640 x 480} or {@code 640 x ?}; empty if the text is invalid. */
  static Optional<PictureSize> of(final String text) {
    final Matcher percent = PERCENT.matcher(text), pixels = PIXELS.matcher(text);
    if (percent.matches() && Integer.parseInt(percent.group(1)) > 0) {
      return Optional.of(new PictureSize(Integer.parseInt(percent.group(1)), 0, 0));
    }
    if (pixels.matches()) {
      final PictureSize size = new PictureSize(0, number(pixels.group(1)), number(pixels.group(2)));
      return size.width > 0 || size.height > 0 ? Optional.of(size) : Optional.empty();
    }
    return Optional.empty();
  }

  private static int number(final String text) {
    return text.equals("?") ? 0 : Integer.parseInt(text);
  }

  private static String text(final int number) {
    return number == 0 ? "?" : String.valueOf(number);
  }

  int widthOf(final int sceneWidth, final int sceneHeight) {
    return percent > 0 ? part(sceneWidth) : width > 0 ? width : scaled(sceneWidth, height, sceneHeight);
  }

  int heightOf(final int sceneWidth, final int sceneHeight) {
    return percent > 0 ? part(sceneHeight) : height > 0 ? height : scaled(sceneHeight, width, sceneWidth);
  }

  private int part(final int size) {
    return (int) Math.max(1, Math.round(size * (percent / 100.0)));
  }

  private static int scaled(final int size, final int wanted, final int other) {
    return (int) Math.max(1, Math.min(Integer.MAX_VALUE, Math.round((double) size * wanted / other)));
  }

  @Override
  public String toString() {
    return percent > 0 ? percent + " %" : text(width) + " x " + text(height);
  }
}
