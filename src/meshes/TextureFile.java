package meshes;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicBoolean;

import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;

import arguments.Messages;
import materials.Texture;

/**
 * Reads the files of textures: PNG, JPEG, GIF (its first frame) and BMP, which are recognised by their content, whatever
 * their names.
 *
 * <p><img src="doc-files/TextureFile.png" width="320" height="200" alt="Beach balls: an image on spheres">
 */
public final class TextureFile {

  /** An image of more pixels is not read: its texels alone would take a quarter of a gigabyte. */
  static final long MOST_PIXELS = 1L << 26;

  private static final int LONGEST_MARK = 8;

  private TextureFile() {
  }

  /** A file cannot be used as a texture; the message says why, in the language of the default locale. */
  public static final class UnusableException extends IOException {
    private static final long serialVersionUID = 1L;

    UnusableException(final String key, final Object... parts) {
      super(Messages.text("meshes." + key, parts));
    }
  }

  /**
   * Reads a texture.
   *
   * @param file the file
   * @return the texture
   * @throws UnusableException if the file cannot be read, is not an image of these formats, or has no pixels or too many
   */
  public static Texture read(final Path file) throws UnusableException {
    final String format = format(file);
    if (format == null) {
      throw new UnusableException("notImage");
    }
    final ImageReader reader = ImageIO.getImageReadersByFormatName(format).next();
    try (ImageInputStream in = ImageIO.createImageInputStream(file.toFile())) {
      reader.setInput(in, false, true);
      final BufferedImage image = image(reader, format);
      return new Texture(format.equals("png") ? TransparentGrey.corrected(file, image) : image);
    } catch (final UnusableException known) {
      throw known;
    } catch (final IOException | RuntimeException damaged) {
      throw new UnusableException("imageDamaged", format.toUpperCase(Locale.ROOT));
    } catch (final OutOfMemoryError tooLarge) {
      throw new UnusableException("imageMemory");
    } finally {
      reader.dispose();
    }
  }

  private static BufferedImage image(final ImageReader reader, final String format) throws IOException {
    final long width = reader.getWidth(0), height = reader.getHeight(0);
    if (width < 1 || height < 1) {
      throw new UnusableException("imageEmpty");
    }
    if (width * height > MOST_PIXELS) {
      throw new UnusableException("imageLarge", width, height, MOST_PIXELS / 1_000_000);
    }
    final AtomicBoolean truncated = new AtomicBoolean();
    reader.addIIOReadWarningListener((source, warning) -> {
      if (warning.startsWith("Premature end") || warning.startsWith("Corrupt JPEG")) {
        truncated.set(true);
      }
    });
    final BufferedImage image = reader.read(0);
    if (truncated.get()) {
      throw new UnusableException("imageDamaged", format.toUpperCase(Locale.ROOT));
    }
    return image;
  }

  /** The name of the format by the first bytes; null if it is none of the four. */
  private static String format(final Path file) throws UnusableException {
    final byte[] start;
    try (InputStream in = Files.newInputStream(file)) {
      start = in.readNBytes(LONGEST_MARK);
    } catch (final IOException failure) {
      throw new UnusableException("unreadable", failure.getClass().getSimpleName() + ": " + failure.getMessage());
    }
    final String[][] marks = {{"png", "\u0089PNG\r\n\u001a\n"}, {"jpeg", "\u00ff\u00d8\u00ff"}, {"gif", "GIF87a"},
        {"gif", "GIF89a"}, {"bmp", "BM"}};
    final String text = new String(start, StandardCharsets.ISO_8859_1);
    for (final String[] mark : marks) {
      if (text.startsWith(mark[1])) {
        return mark[0];
      }
    }
    return null;
  }
}
