package meshes;

import java.awt.image.BufferedImage;
import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The grey that a PNG image of fewer than 8 bits says is transparent (chunk {@code tRNS}; Portable Network Graphics
 * Specification, section 11.3.2.1). ImageIO compares it with samples that it has already scaled to 8 bits, and so makes
 * others transparent.
 */
final class TransparentGrey {

  private static final int SIGNATURE = 8;
  private static final int CHECKSUM = 4;

  /** Length of width and height in the header, before the depth. */
  private static final int SIZES = 8;

  private static final int HEADER = 0x49484452;
  private static final int TRANSPARENCY = 0x74524e53;
  private static final int DATA = 0x49444154;
  private static final int END = 0x49454e44;

  private static final int NONE = -1;

  private TransparentGrey() {
  }

  /** The image that was read from a PNG file, or, if the file declares such a grey, a corrected one. */
  static BufferedImage corrected(final Path file, final BufferedImage image) throws IOException {
    final int grey = of(file);
    if (grey == NONE) {
      return image;
    }
    final BufferedImage corrected = new BufferedImage(image.getWidth(), image.getHeight(), BufferedImage.TYPE_INT_ARGB);
    for (int y = 0; y < image.getHeight(); y++) {
      for (int x = 0; x < image.getWidth(); x++) {
        final int sample = image.getRaster().getSample(x, y, 0);
        corrected.setRGB(x, y, (sample == grey ? 0 : 0xff000000) | sample * 0x10101);
      }
    }
    return corrected;
  }

  /** The grey, scaled to 8 bits; {@link #NONE} if none. */
  private static int of(final Path file) throws IOException {
    try (DataInputStream in = new DataInputStream(new BufferedInputStream(Files.newInputStream(file)))) {
      in.skipNBytes(SIGNATURE);
      int largest = 0;
      while (true) {
        final int length = in.readInt(), type = in.readInt();
        if (type == HEADER) {
          in.skipNBytes(SIZES);
          final int depth = in.readUnsignedByte(), colours = in.readUnsignedByte();
          if (colours != 0 || depth >= Byte.SIZE) {
            return NONE;
          }
          largest = (1 << depth) - 1;
          in.skipNBytes(length - SIZES - 2 + CHECKSUM);
        } else if (type == TRANSPARENCY) {
          return (in.readUnsignedShort() & largest) * 255 / largest;
        } else if (type == DATA || type == END) {
          return NONE;
        } else {
          in.skipNBytes((long) length + CHECKSUM);
        }
      }
    }
  }
}
