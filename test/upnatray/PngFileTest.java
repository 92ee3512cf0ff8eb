package upnatray;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;

import javax.imageio.ImageIO;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import arguments.Messages;

class PngFileTest {

  private static BufferedImage image(final int type) {
    final BufferedImage image = new BufferedImage(3, 2, type);
    image.setRGB(2, 1, 0xff204060);
    return image;
  }

  @Test
  void imagesOfAnyTypeAreSavedInTheirColours(@TempDir final Path folder) throws Exception {
    final Path file = folder.resolve("new folder").resolve("picture.png");
    for (final int type : new int[] {BufferedImage.TYPE_INT_ARGB, BufferedImage.TYPE_INT_RGB,
        BufferedImage.TYPE_4BYTE_ABGR}) {
      final BufferedImage image = image(type);
      PngFile.save(image, file);
      final BufferedImage read = ImageIO.read(file.toFile());
      assertEquals(0xff204060, read.getRGB(2, 1));
      assertEquals(image.getRGB(0, 0), read.getRGB(0, 0));
    }
    try (var files = Files.list(file.getParent())) {
      assertEquals(1, files.count());
    }
  }

  @Test
  void whyAnImageCannotBeSavedIsTold(@TempDir final Path folder) throws Exception {
    final BufferedImage image = image(BufferedImage.TYPE_INT_ARGB);
    final String message = assertThrows(SaveException.class, () -> PngFile.save(image, folder)).getMessage();
    assertTrue(message.startsWith(folder.toString()) && message.endsWith(Messages.text("upnatray.isFolder")), message);
    final Path file = Files.createFile(folder.resolve("file"));
    final String other = assertThrows(SaveException.class, () -> PngFile.save(image, file.resolve("a.png"))).getMessage();
    assertTrue(other.endsWith(Messages.text("upnatray.noFolder", file)), other);
    assertThrows(IllegalArgumentException.class, () -> PngFile.save(null, file));
    assertThrows(IllegalArgumentException.class, () -> PngFile.save(image, null));
  }
}
