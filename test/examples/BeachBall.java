package examples;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;

import javax.imageio.ImageIO;

/** Draws {@code scenes/ball.png}, an image to go around a sphere. */
final class BeachBall {

  static final Path FILE = Path.of("scenes", "ball.png");

  private static final int WIDTH = 192;
  private static final int HEIGHT = 96;
  private static final int[] STRIPES = {0xE5484D, 0xFFFFFF, 0x3E63DD, 0xFFFFFF, 0xF5C02F, 0xFFFFFF};

  private BeachBall() {
  }

  /** Six stripes twice around, a white cap on either pole, and a dark spot in the middle, which faces the viewer. */
  static BufferedImage image() {
    final BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        final int stripe = STRIPES[x * 12 / WIDTH % STRIPES.length];
        final boolean cap = y < HEIGHT / 12 || y >= HEIGHT - HEIGHT / 12;
        final double dx = x + 0.5 - WIDTH / 2.0, dy = y + 0.5 - HEIGHT / 2.0;
        image.setRGB(x, y, dx * dx + dy * dy < 40 ? 0x30343A : cap ? 0xFFFFFF : stripe);
      }
    }
    return image;
  }

  public static void main(final String[] args) throws IOException {
    ImageIO.write(image(), "png", FILE.toFile());
  }
}
