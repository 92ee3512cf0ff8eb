package window;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;

import javax.imageio.ImageIO;

/** PNG files of the window. One that is written appears whole or not at all. */
final class PictureFile {

  private PictureFile() {
  }

  static void save(final BufferedImage picture, final Path file) throws IOException {
    final Path target = file.toAbsolutePath();
    final Path temporary = Files.createTempFile(target.getParent(), ".upnatray", ".png");
    try {
      if (!ImageIO.write(picture, "png", temporary.toFile())) {
        throw new IOException(Messages.text("save.noWriter"));
      }
      Files.move(temporary, target, StandardCopyOption.REPLACE_EXISTING);
    } finally {
      Files.deleteIfExists(temporary);
    }
  }

  static BufferedImage read(final Path file) throws IOException {
    final BufferedImage picture = ImageIO.read(file.toFile());
    if (picture == null) {
      throw new IOException(Messages.text("compare.noPicture", file));
    }
    return picture;
  }

  /** The name with the ending of a PNG file, whether or not it had that already. */
  static Path withEnding(final Path file) {
    final String name = file.getFileName().toString();
    return name.toLowerCase(java.util.Locale.ROOT).endsWith(".png") ? file : file.resolveSibling(name + ".png");
  }
}
