package upnatray;

import java.awt.AlphaComposite;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.awt.image.DirectColorModel;
import java.awt.image.RenderedImage;
import java.awt.image.WritableRaster;
import java.io.IOException;
import java.io.OutputStream;

import javax.imageio.IIOException;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Encodes images as PNG, row by row, with no more memory than a few rows and a block of the file. */
final class PngEncoder {

  private static final String METADATA = "javax_imageio_png_1.0";

  private PngEncoder() {
  }

  /**
   * Writes an image; one without transparent pixels as RGB.
   *
   * @param image the image
   * @param text a text that is put into the file under the program's name; null for none
   * @param out where to
   * @throws IOException if it cannot be written
   */
  static void write(final BufferedImage image, final String text, final OutputStream out) throws IOException {
    ImageIO.setUseCache(false);
    final RenderedImage writable = writable(image);
    final ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
    try (ImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
      writer.setOutput(stream);
      writer.write(new IIOImage(writable, null, text == null ? null : metadata(writer, writable, text)));
    } catch (final IIOException failure) {
      throw failure.getCause() instanceof IOException reason ? reason : failure;
    } finally {
      writer.dispose();
    }
  }

  private static IIOMetadata metadata(final ImageWriter writer, final RenderedImage image, final String text)
      throws IOException {
    final IIOMetadataNode entry = new IIOMetadataNode("tEXtEntry");
    entry.setAttribute("keyword", PngChunks.KEYWORD);
    entry.setAttribute("value", text);
    final IIOMetadataNode texts = new IIOMetadataNode("tEXt");
    texts.appendChild(entry);
    final IIOMetadataNode root = new IIOMetadataNode(METADATA);
    root.appendChild(texts);
    final IIOMetadata metadata = writer.getDefaultImageMetadata(ImageTypeSpecifier.createFromRenderedImage(image), null);
    metadata.mergeTree(METADATA, root);
    return metadata;
  }

  private static RenderedImage writable(final BufferedImage image) {
    if (!image.getColorModel().hasAlpha()) {
      return image;
    }
    final BufferedImage argb = argb(image);
    return isOpaque(argb) ? withoutAlpha(argb) : argb;
  }

  static BufferedImage argb(final BufferedImage image) {
    if (image.getType() == BufferedImage.TYPE_INT_ARGB) {
      return image;
    }
    final BufferedImage copy = new BufferedImage(image.getWidth(), image.getHeight(), BufferedImage.TYPE_INT_ARGB);
    final Graphics2D g = copy.createGraphics();
    g.setComposite(AlphaComposite.Src);
    g.drawImage(image, 0, 0, null);
    g.dispose();
    return copy;
  }

  private static boolean isOpaque(final BufferedImage image) {
    final int[] row = new int[image.getWidth()];
    for (int y = 0; y < image.getHeight(); y++) {
      image.getRaster().getDataElements(0, y, row.length, 1, row);
      int all = -1;
      for (final int argb : row) {
        all &= argb;
      }
      if (all >>> 24 != 0xff) {
        return false;
      }
    }
    return true;
  }

  /** The same pixels, not copied, as an image that has no alpha channel. */
  private static RenderedImage withoutAlpha(final BufferedImage image) {
    final DirectColorModel rgb = new DirectColorModel(24, 0xff0000, 0xff00, 0xff);
    final WritableRaster raster = image.getRaster();
    final int[] bands = {0, 1, 2};
    return new BufferedImage(rgb, raster.createWritableChild(raster.getMinX(), raster.getMinY(), raster.getWidth(),
        raster.getHeight(), 0, 0, bands), false, null);
  }
}
