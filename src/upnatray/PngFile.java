package upnatray;

import static arguments.Arguments.notNull;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.awt.image.DirectColorModel;
import java.awt.image.RenderedImage;
import java.awt.image.WritableRaster;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Collection;
import java.util.List;

import javax.imageio.IIOException;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/**
 * Saves images as PNG files that appear whole or not at all: an image is written to a hidden temporary file beside its
 * target, which is then moved into place in one step. Any failure before that leaves the old file, or none.
 *
 * <p>Nothing but a PNG file is ever replaced.
 */
public final class PngFile {

  private PngFile() {
  }

  /**
   * Checks, before a picture is rendered, whether it may be saved in a file. The file has to be missing, or a PNG by its
   * first bytes, or empty with a name in {@code .png}; it must not be an input; its name must not claim another format.
   *
   * @param target where the picture is to go
   * @param inputs the files of which it is made, such as the scene and its meshes: compared as files, not as names
   * @throws SaveException if the picture cannot or must not be saved there; its message says why
   * @throws IllegalArgumentException if an argument is null
   */
  public static void check(final Path target, final Collection<Path> inputs) throws SaveException {
    new PngTarget(notNull("target", target)).check(new InputFiles(notNull("inputs", inputs)));
  }

  /**
   * Saves an image; the folder is made if it is missing. The target of a symbolic link is replaced, not the link.
   *
   * @param image image of any type, such as an {@link Image}; a picture without transparent pixels is written as RGB
   * @param target where to; a PNG file that is there is replaced, any other file is not
   * @throws SaveException if it cannot be saved; its message says why
   * @throws IllegalArgumentException if an argument is null
   */
  public static void save(final BufferedImage image, final Path target) throws SaveException {
    notNull("image", image);
    final PngTarget checked = new PngTarget(notNull("target", target));
    checked.check(new InputFiles(List.of()));
    try {
      write(image, checked.place());
    } catch (final IOException failure) {
      throw new SaveException("notSaved", target, SaveFailure.reason(failure), failure);
    }
  }

  private static void write(final BufferedImage image, final Path place) throws IOException {
    final Path temporary = place.resolveSibling(".upnatray-" + Long.toString(System.nanoTime(), 36) + ".tmp");
    try {
      if (place.getParent() != null) {
        Files.createDirectories(place.getParent());
      }
      try (OutputStream out = Files.newOutputStream(temporary, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE)) {
        write(image, out);
      }
      Files.move(temporary, place, StandardCopyOption.ATOMIC_MOVE);
    } catch (final IOException failure) {
      remove(temporary, failure);
      throw failure;
    }
  }

  /** Writes an image row by row, with no more memory than a few rows and a block of the file. */
  static void write(final BufferedImage image, final OutputStream out) throws IOException {
    ImageIO.setUseCache(false);
    final ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
    try (ImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
      writer.setOutput(stream);
      writer.write(writable(image));
    } catch (final IIOException failure) {
      throw failure.getCause() instanceof IOException reason ? reason : failure;
    } finally {
      writer.dispose();
    }
  }

  private static RenderedImage writable(final BufferedImage image) {
    if (!image.getColorModel().hasAlpha()) {
      return image;
    }
    final BufferedImage argb = argb(image);
    return isOpaque(argb) ? withoutAlpha(argb) : argb;
  }

  private static BufferedImage argb(final BufferedImage image) {
    if (image.getType() == BufferedImage.TYPE_INT_ARGB) {
      return image;
    }
    final BufferedImage copy = new BufferedImage(image.getWidth(), image.getHeight(), BufferedImage.TYPE_INT_ARGB);
    final Graphics2D g = copy.createGraphics();
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

  private static void remove(final Path temporary, final IOException failure) {
    try {
      Files.deleteIfExists(temporary);
    } catch (final IOException left) {
      failure.addSuppressed(left);
    }
  }
}
