package upnatray;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;

import javax.imageio.ImageIO;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import arguments.Messages;

class PngFileTest {

  private static BufferedImage image(final int type) {
    final BufferedImage image = new BufferedImage(3, 2, type);
    image.setRGB(2, 1, 0xff204060);
    return image;
  }

  private static BufferedImage random(final int W, final int H, final int or) {
    final BufferedImage image = new BufferedImage(W, H, BufferedImage.TYPE_INT_ARGB);
    final Random random = new Random(W + H);
    for (int y = 0; y < H; y++) {
      for (int x = 0; x < W; x++) {
        image.setRGB(x, y, random.nextInt() | or);
      }
    }
    return image;
  }

  private static byte[] written(final BufferedImage image) throws IOException {
    final ByteArrayOutputStream out = new ByteArrayOutputStream();
    PngEncoder.write(image, null, out);
    return out.toByteArray();
  }

  private static int[] pixels(final BufferedImage image) {
    return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
  }

  @ParameterizedTest
  @CsvSource({"1, 1", "1, 100", "100, 1", "3, 2", "17, 19", "500, 333", "1, 30000", "30000, 1"})
  void pixelsAreReadBackAsTheyWere(final int W, final int H) throws IOException {
    for (final int or : new int[] {0xff000000, 0x01000000, 0}) {
      final BufferedImage image = random(W, H, or);
      assertArrayEquals(pixels(image), pixels(ImageIO.read(new ByteArrayInputStream(written(image)))));
    }
  }

  @Test
  void onlyAPictureThatIsNotOpaqueHasAnAlphaChannel() throws IOException {
    final Image image = new Image(50, 40, Color.WHITE);
    assertEquals(2, written(image)[25], "colour type RGB");
    image.setRGB(49, 39, 0xfe123456);
    final byte[] bytes = written(image);
    assertEquals(6, bytes[25], "colour type RGBA");
    final BufferedImage read = ImageIO.read(new ByteArrayInputStream(bytes));
    assertEquals(0xfe123456, read.getRGB(49, 39));
    assertEquals(0xffffffff, read.getRGB(48, 39));
  }

  @Test
  void aPlainPictureIsSmall() throws IOException {
    assertTrue(written(new Image(1000, 1000, Color.GRAY)).length < 20_000);
  }

  /** An image that takes more than half of the memory is written within the rest. */
  @Test
  void aLargePictureNeedsNoSecondCopy(@TempDir final Path folder) throws Exception {
    final CommandLine.Result result = new CommandLine(folder).with("-Xmx96m", "-XX:+UseSerialGC")
        .run(Path.of("scenes", "orthographic.xml").toAbsolutePath().toString(), "--width", "4000", "--height", "4000",
            "-o", "large.png");
    assertEquals(0, result.status(), result.err());
    try (var stream = ImageIO.createImageInputStream(folder.resolve("large.png").toFile())) {
      final var reader = ImageIO.getImageReaders(stream).next();
      reader.setInput(stream);
      assertEquals(4000, reader.getHeight(0));
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {BufferedImage.TYPE_INT_ARGB, BufferedImage.TYPE_INT_RGB, BufferedImage.TYPE_4BYTE_ABGR,
      BufferedImage.TYPE_INT_ARGB_PRE, BufferedImage.TYPE_3BYTE_BGR})
  void imagesOfAnyTypeAreSavedInTheirColours(final int type, @TempDir final Path folder) throws Exception {
    final Path file = folder.resolve("new folder").resolve("picture.png");
    final BufferedImage image = image(type);
    PngFile.save(image, file);
    assertArrayEquals(pixels(image), pixels(ImageIO.read(file.toFile())));
    try (var files = Files.list(file.getParent())) {
      assertEquals(1, files.count());
    }
  }

  @Test
  void whyAnImageCannotBeSavedIsReported(@TempDir final Path folder) throws Exception {
    final BufferedImage image = image(BufferedImage.TYPE_INT_ARGB);
    final String message = assertThrows(SaveException.class, () -> PngFile.save(image, folder)).getMessage();
    assertTrue(message.startsWith(folder.toString()) && message.endsWith(Messages.text("upnatray.isFolder")), message);
    final Path file = Files.createFile(folder.resolve("file"));
    final String other = assertThrows(SaveException.class, () -> PngFile.save(image, file.resolve("a.png"))).getMessage();
    assertTrue(other.endsWith(Messages.text("upnatray.noFolder", file)), other);
    assertThrows(IllegalArgumentException.class, () -> PngFile.save(null, file));
    assertThrows(IllegalArgumentException.class, () -> PngFile.save(image, null));
    assertThrows(IllegalArgumentException.class, () -> PngFile.check(null, java.util.List.of()));
    assertThrows(IllegalArgumentException.class, () -> PngFile.check(file, null));
  }

  @Test
  void aStreamThatFailsLeavesItsFailure() {
    final OutputStream full = new OutputStream() {
      @Override
      public void write(final int b) throws IOException {
        throw new IOException("disk full");
      }
    };
    assertEquals("disk full", assertThrows(IOException.class,
        () -> PngEncoder.write(image(BufferedImage.TYPE_INT_ARGB), null, full)).getMessage());
  }

  /** On Windows a file that another program has open cannot be replaced; the exception of the system is simulated here. */
  @Test
  void aFileInUseIsCalledSo() {
    final String inUse = Messages.text("upnatray.inUse");
    assertEquals(inUse, SaveFailure.reason(new AccessDeniedException("a.tmp", "a.png", null)));
    assertTrue(SaveFailure.reason(new FileSystemException("a.tmp", "a.png", "used by another process")).startsWith(inUse));
    assertEquals(Messages.text("upnatray.denied", "a"), SaveFailure.reason(new AccessDeniedException("a")));
    assertEquals("no space", SaveFailure.reason(new FileSystemException("a", null, "no space")));
  }
}
