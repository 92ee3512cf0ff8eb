package window;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

import javax.imageio.ImageIO;

import arguments.Messages;

/** Reads reference pictures, and names the files of pictures to be saved. */
final class PictureFile {

  private PictureFile() {
  }

  static BufferedImage read(final Path file) throws IOException {
    if (!Files.isReadable(file)) {
      throw new IOException(Messages.text("window.compare.unreadable"));
    }
    final BufferedImage picture = ImageIO.read(file.toFile());
    if (picture == null) {
      throw new IOException(Messages.text("window.compare.notAnImage"));
    }
    return picture;
  }

  /** The file name with the extension .png, which is added if it is missing. */
  static Path withExtension(final Path file) {
    final String name = file.getFileName().toString();
    return name.toLowerCase(java.util.Locale.ROOT).endsWith(".png") ? file : file.resolveSibling(name + ".png");
  }
}
