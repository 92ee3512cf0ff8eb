package inspection;

import static arguments.Arguments.notNull;

import java.awt.image.BufferedImage;
import java.util.Optional;

/**
 * The difference between two pictures of the same size. The difference between two pixels is the largest of those of their
 * four channels (sRGB and alpha), 0 … 255.
 *
 * @param differing number of pixels that differ
 * @param largest the largest difference, 0 … 255
 * @param mean mean difference of all pixels
 * @param worstX column of the first pixel with the largest difference
 * @param worstY row of that pixel, from the top
 * @param mask black where the pictures are equal, else from red to white with growing difference
 */
public record Difference(long differing, int largest, double mean, int worstX, int worstY, BufferedImage mask) {

  /** Brightness of the smallest difference in the mask, chosen so that it is visible. */
  private static final double MIN_BRIGHTNESS = 0.25;

  /**
   * Compares two pictures.
   *
   * @param picture a picture
   * @param reference the picture to compare it with
   * @return their difference; empty if their sizes differ
   * @throws IllegalArgumentException if a picture is null
   */
  public static Optional<Difference> between(final BufferedImage picture, final BufferedImage reference) {
    final int W = notNull("picture", picture).getWidth(), H = picture.getHeight();
    if (notNull("reference", reference).getWidth() != W || reference.getHeight() != H) {
      return Optional.empty();
    }
    final BufferedImage mask = new BufferedImage(W, H, BufferedImage.TYPE_INT_RGB);
    long differing = 0, sum = 0;
    int largest = 0, worst = 0;
    for (int y = 0; y < H; y++) {
      final int[] row = picture.getRGB(0, y, W, 1, null, 0, W), other = reference.getRGB(0, y, W, 1, null, 0, W);
      for (int x = 0; x < W; x++) {
        final int difference = difference(row[x], other[x]);
        row[x] = difference == 0 ? 0 : rendering.ColourScale.heat(MIN_BRIGHTNESS + (1 - MIN_BRIGHTNESS) * difference / 255);
        differing += difference == 0 ? 0 : 1;
        sum += difference;
        if (difference > largest) {
          largest = difference;
          worst = y * W + x;
        }
      }
      mask.setRGB(0, y, W, 1, row, 0, W);
    }
    return Optional.of(new Difference(differing, largest, (double) sum / ((long) W * H), worst % W, worst / W, mask));
  }

  private static int difference(final int a, final int b) {
    int largest = 0;
    for (int shift = 0; shift < Integer.SIZE; shift += Byte.SIZE) {
      largest = Math.max(largest, Math.abs((a >>> shift & 0xff) - (b >>> shift & 0xff)));
    }
    return largest;
  }
}
