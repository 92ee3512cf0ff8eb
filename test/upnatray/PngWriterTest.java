package upnatray;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Random;

import javax.imageio.ImageIO;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is written is read back by the JDK. */
class PngWriterTest {

  private static byte[] written(final BufferedImage image) throws IOException {
    final ByteArrayOutputStream out = new ByteArrayOutputStream();
    PngWriter.write(image, out);
    return out.toByteArray();
  }

  private static BufferedImage image(final int W, final int H, final long seed, final int or) {
    final BufferedImage image = new BufferedImage(W, H, BufferedImage.TYPE_INT_ARGB);
    final Random random = new Random(seed);
    for (int y = 0; y < H; y++) {
      for (int x = 0; x < W; x++) {
        image.setRGB(x, y, random.nextInt() | or);
      }
    }
    return image;
  }

  @ParameterizedTest
  @CsvSource({"1, 1", "1, 100", "100, 1", "3, 2", "17, 19", "500, 333", "1, 30000", "30000, 1"})
  void theJdkReadsTheSamePixels(final int W, final int H) throws IOException {
    for (final int or : new int[] {0xff000000, 0}) {
      final BufferedImage image = image(W, H, W + H, or);
      final BufferedImage read = ImageIO.read(new ByteArrayInputStream(written(image)));
      assertEquals(or == 0 && (long) W * H > 1, read.getColorModel().hasAlpha() && (long) W * H > 1);
      assertArrayEquals(image.getRGB(0, 0, W, H, null, 0, W), read.getRGB(0, 0, W, H, null, 0, W));
    }
  }

  @Test
  void onePixelThatIsNotOpaqueNeedsTheAlphaChannel() throws IOException {
    final Image image = new Image(50, 40, Color.WHITE);
    assertEquals(3, ImageIO.read(new ByteArrayInputStream(written(image))).getColorModel().getNumComponents());
    image.setRGB(49, 39, 0xfe123456);
    final BufferedImage read = ImageIO.read(new ByteArrayInputStream(written(image)));
    assertEquals(0xfe123456, read.getRGB(49, 39));
    assertEquals(0xffffffff, read.getRGB(48, 39));
  }

  @Test
  void aPlainPictureIsSmall() throws IOException {
    assertEquals(true, written(new Image(1000, 1000, Color.GRAY)).length < 20_000);
  }
}
