package window;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

import javax.imageio.ImageIO;

import arguments.Messages;

/** Pictures that the window reads, and names for those that it saves. */
final class PictureFile {

  private PictureFile() {
  }

  static BufferedImage read(final Path file) throws IOException {
    if (!Files.isReadable(file)) {
      throw new IOException(Messages.text("window.compare.unreadable"));
    }
    final BufferedImage picture = ImageIO.read(file.toFile());
    if (picture == null) {
      throw new IOException(Messages.text("window.compare.noPicture"));
    }
    return picture;
  }

  /** The name with the ending of a PNG file, whether or not it had that already. */
  static Path withEnding(final Path file) {
    final String name = file.getFileName().toString();
    return name.toLowerCase(java.util.Locale.ROOT).endsWith(".png") ? file : file.resolveSibling(name + ".png");
  }
}
