package materials;

import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.Raster;

/**
 * The pixels of an image as they are stored. {@link BufferedImage#getRGB} takes grey images for linear, returning 79 for
 * a stored 20, and applies colour profiles; so samples are read from the raster wherever it has one for each channel. The
 * four inks of a JPEG file for printing are multiplied, as they are without a profile.
 */
final class StoredTexels {

  /** Channels of an image for printing: cyan, magenta, yellow and black. */
  private static final int INKS = 4;

  private final BufferedImage image;
  private final ColorModel model;

  StoredTexels(final BufferedImage image) {
    this.image = image;
    this.model = image.getColorModel();
  }

  /** The texels row by row, the upper one first, sRGB with alpha in the highest byte. */
  int[] read() {
    final int width = image.getWidth(), height = image.getHeight();
    return hasPlainSamples() ? samples(width, height) : image.getRGB(0, 0, width, height, null, 0, width);
  }

  /** Whether each channel has a sample: grey or RGB, possibly with alpha, or CMYK, in 8 or 16 bits. */
  private boolean hasPlainSamples() {
    final int type = model.getTransferType();
    return model instanceof ComponentColorModel && !model.isAlphaPremultiplied() && model.getNumComponents() <= 4
        && (type == DataBuffer.TYPE_BYTE || type == DataBuffer.TYPE_USHORT);
  }

  private int[] samples(final int width, final int height) {
    final Raster raster = image.getRaster();
    final int bands = model.getNumComponents(), opaque = model.hasAlpha() ? bands - 1 : bands;
    final int green = opaque >= 3 ? 1 : 0, blue = opaque >= 3 ? 2 : 0;
    final int[] texels = new int[width * height], row = new int[width * bands], scales = scales(bands);
    for (int y = 0; y < height; y++) {
      raster.getPixels(raster.getMinX(), raster.getMinY() + y, width, 1, row);
      for (int x = 0; x < width; x++) {
        final int i = x * bands;
        final int alpha = model.hasAlpha() ? eight(row[i + opaque], scales[opaque]) : 255;
        final int r = eight(row[i], scales[0]), g = eight(row[i + green], scales[green]),
            b = eight(row[i + blue], scales[blue]);
        final int black = opaque == INKS ? row[i + INKS - 1] : -1;
        texels[y * width + x] = alpha << 24 | light(r, black) << 16 | light(g, black) << 8 | light(b, black);
      }
    }
    return texels;
  }

  private int[] scales(final int bands) {
    final int[] scales = new int[bands];
    for (int band = 0; band < bands; band++) {
      scales[band] = (1 << model.getComponentSize(band)) - 1;
    }
    return scales;
  }

  /** The light that an ink and the black one transmit; without inks, black being −1, the sample itself. */
  private static int light(final int sample, final int black) {
    return black < 0 ? sample : eight((255 - sample) * (255 - black), 255 * 255);
  }

  /** Scales a sample from 0 … scale to 0 … 255, rounded. */
  private static int eight(final int sample, final int scale) {
    return (510 * sample + scale) / (2 * scale);
  }
}
