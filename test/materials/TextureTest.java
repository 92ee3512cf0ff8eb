package materials;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.color.ICC_ColorSpace;
import java.awt.color.ICC_Profile;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;

import javax.imageio.ImageIO;

import org.junit.jupiter.api.Test;

import trials.Trials;

class TextureTest {

  /** An image whose texels all differ. */
  private static BufferedImage image(final int width, final int height) {
    final BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        image.setRGB(x, y, 0x80402000 + 0x01010000 * y + 0x0101 * x);
      }
    }
    return image;
  }

  /** An image, written and read again. */
  private static BufferedImage file(final BufferedImage image, final String format) throws IOException {
    final ByteArrayOutputStream out = new ByteArrayOutputStream();
    assertTrue(ImageIO.write(image, format, out), format);
    return ImageIO.read(new ByteArrayInputStream(out.toByteArray()));
  }

  private static void assertTexel(final int r, final int g, final int b, final int alpha, final BufferedImage image,
      final double u, final double v) {
    assertEquals(new Color(r, g, b, alpha), new Texture(image).getColor(u, v), () -> image.toString());
    assertEquals(alpha, new Texture(image).getColor(u, v).getAlpha());
  }

  /** u to the right, v upwards, (0, 0) the lower left corner. */
  @Test
  void eachTexelIsWhereItIsInTheImage() {
    final BufferedImage image = image(8, 5);
    final Texture texture = new Texture(image);
    for (int x = 0; x < 8; x++) {
      for (int y = 0; y < 5; y++) {
        for (final double part : new double[] {1e-9, 0.5, 1 - 1e-9}) {
          final double u = (x + part) / 8, v = (4 - y + part) / 5;
          assertEquals(image.getRGB(x, y), texture.getARGB(u, v));
          assertEquals(image.getRGB(x, y), texture.getColor(u + 1, v - 2).getRGB());
          assertEquals(image.getRGB(x, y), texture.getColor(u - 3, v + 7).getRGB());
        }
      }
    }
    assertEquals(8, texture.getWidth());
    assertEquals(5, texture.getHeight());
    assertEquals("Texture(8 x 5)", texture.toString());
  }

  @Test
  void edgesBelongToTheTexelBeyondThem() {
    final BufferedImage image = image(4, 2);
    final Texture texture = new Texture(image);
    assertEquals(image.getRGB(0, 1), texture.getARGB(0, 0));
    assertEquals(image.getRGB(0, 1), texture.getARGB(1, 1), "it repeats");
    assertEquals(image.getRGB(2, 0), texture.getARGB(0.5, 0.5));
    assertEquals(image.getRGB(3, 0), texture.getARGB(-1e-20, -1e-20), "a fraction that rounds to 1");
    assertEquals(image.getRGB(3, 0), texture.getARGB(Math.nextDown(1.0), Math.nextDown(1.0)));
  }

  /** Coordinates that are not finite give some texel, but never an exception. */
  @Test
  void coordinatesNeedNotBeNumbers() {
    final Texture texture = new Texture(image(3, 3));
    for (final double wrong : new double[] {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 1e300, -1e300}) {
      assertEquals(texture.getARGB(0, 0), texture.getARGB(wrong, wrong));
    }
  }

  @Test
  void theMeanIsThatOfEachChannelRounded() {
    final BufferedImage image = new BufferedImage(2, 2, BufferedImage.TYPE_INT_ARGB);
    image.setRGB(0, 0, 0xFF0A0000);
    image.setRGB(1, 0, 0xFF0B00FF);
    image.setRGB(0, 1, 0xFE0B01FF);
    image.setRGB(1, 1, 0x00000000);
    final Color mean = new Texture(image).getMeanColor();
    assertEquals("8 0 128 191", mean.getRed() + " " + mean.getGreen() + " " + mean.getBlue() + " " + mean.getAlpha());
    image.setRGB(1, 1, 0xFF000100);
    assertEquals(1, new Texture(image).getMeanColor().getGreen(), "a half is rounded up");
  }

  @Test
  void theImageIsCopied() {
    final BufferedImage image = image(2, 2);
    final Texture texture = new Texture(image);
    image.setRGB(0, 0, 0xFFFFFFFF);
    assertEquals(0x80402000, texture.getARGB(0.25, 0.75));
  }

  @Test
  void opacityMultipliesAlphaAlone() {
    final Texture texture = new Texture(image(2, 1)), half = texture.withOpacity(0.5), none = texture.withOpacity(0);
    assertEquals(0x40402000, half.getARGB(0.25, 0.5));
    assertEquals(0x40402101, half.getARGB(0.75, 0.5));
    assertEquals(0x00402101, none.getARGB(0.75, 0.5));
    assertEquals(0x80402101, texture.withOpacity(1).getARGB(0.75, 0.5));
    assertEquals(0x80402101, texture.getARGB(0.75, 0.5), "the texture itself stays");
    assertEquals(64, half.getMeanColor().getAlpha());
    assertEquals("Texture(2 x 1)", half.toString());
    assertEquals(0x26402000, texture.withOpacity(0.3).getARGB(0.25, 0.5), "128 · 0.3 = 38.4");
    assertEquals(0x27402000, texture.withOpacity(0.305).getARGB(0.25, 0.5), "128 · 0.305 = 39.04");
    assertEquals(0x4D402000, texture.withOpacity(0.6).getARGB(0.25, 0.5), "128 · 0.6 = 76.8, rounded");
    for (final double wrong : new double[] {-Double.MIN_VALUE, Math.nextUp(1.0), Double.NaN}) {
      final String message = assertThrows(IllegalArgumentException.class, () -> texture.withOpacity(wrong)).getMessage();
      assertTrue(message.startsWith("opacity must"), message);
    }
  }

  @Test
  void greyIsWhatIsStored() throws IOException {
    final BufferedImage grey = new BufferedImage(256, 1, BufferedImage.TYPE_BYTE_GRAY);
    for (int i = 0; i < 256; i++) {
      grey.getRaster().setSample(i, 0, 0, i);
    }
    final BufferedImage png = file(grey, "png"), bmp = file(grey, "bmp");
    for (int i = 0; i < 256; i++) {
      assertTexel(i, i, i, 255, grey, (i + 0.5) / 256, 0.5);
      assertTexel(i, i, i, 255, png, (i + 0.5) / 256, 0.5);
      assertTexel(i, i, i, 255, bmp, (i + 0.5) / 256, 0.5);
    }
    final BufferedImage flat = new BufferedImage(16, 16, BufferedImage.TYPE_BYTE_GRAY);
    flat.getGraphics().dispose();
    for (int i = 0; i < 256; i++) {
      flat.getRaster().setSample(i % 16, i / 16, 0, 20);
    }
    final Color color = new Texture(file(flat, "jpg")).getColor(0.5, 0.5);
    assertEquals(20, color.getRed(), 1, "a grey JPEG");
    assertEquals(color.getRed(), color.getBlue());
  }

  @Test
  void sixteenBitsAreRoundedToEight() throws IOException {
    final BufferedImage grey = new BufferedImage(3, 1, BufferedImage.TYPE_USHORT_GRAY);
    final int[] samples = {128, 129, 65535};
    for (int i = 0; i < 3; i++) {
      grey.getRaster().setSample(i, 0, 0, samples[i]);
    }
    for (final BufferedImage image : new BufferedImage[] {grey, file(grey, "png")}) {
      assertTexel(0, 0, 0, 255, image, 0.1, 0.5);
      assertTexel(1, 1, 1, 255, image, 0.5, 0.5);
      assertTexel(255, 255, 255, 255, image, 0.9, 0.5);
    }
    final BufferedImage rgba = components(DataBuffer.TYPE_USHORT, ColorSpace.getInstance(ColorSpace.CS_sRGB), 4);
    rgba.getRaster().setPixel(0, 0, new int[] {257 * 10 + 128, 257 * 20 + 129, 257 * 30, 257 * 40});
    assertTexel(10, 21, 30, 40, rgba, 0.5, 0.5);
    assertTexel(10, 21, 30, 40, file(rgba, "png"), 0.5, 0.5);
  }

  private static BufferedImage components(final int type, final ColorSpace space, final int bands) {
    final boolean alpha = bands > space.getNumComponents();
    final ComponentColorModel model = new ComponentColorModel(space, alpha, false,
        alpha ? Transparency.TRANSLUCENT : Transparency.OPAQUE, type);
    final WritableRaster raster = Raster.createInterleavedRaster(type, 1, 1, bands, null);
    return new BufferedImage(model, raster, false, null);
  }

  @Test
  void greyMayHaveAlpha() throws IOException {
    final BufferedImage image = components(DataBuffer.TYPE_BYTE, ColorSpace.getInstance(ColorSpace.CS_GRAY), 2);
    image.getRaster().setPixel(0, 0, new int[] {128, 50});
    assertTexel(128, 128, 128, 50, image, 0.5, 0.5);
    assertTexel(128, 128, 128, 50, file(image, "png"), 0.5, 0.5);
  }

  @Test
  void palettesAreResolved() throws IOException {
    final byte[] r = {10, 20, (byte) 200, 40}, g = {50, 60, 70, 80}, b = {90, (byte) 150, 110, 120};
    for (final int bits : new int[] {2, 8}) {
      final int size = 1 << bits;
      final BufferedImage image = new BufferedImage(4, 1, bits == 8 ? BufferedImage.TYPE_BYTE_INDEXED
          : BufferedImage.TYPE_BYTE_BINARY, new IndexColorModel(bits, size, Arrays.copyOf(r, size),
              Arrays.copyOf(g, size), Arrays.copyOf(b, size)));
      for (int i = 0; i < 4; i++) {
        image.getRaster().setSample(i, 0, 0, i);
      }
      for (final String format : new String[] {"png", "gif", "bmp"}) {
        if (bits == 8 || !format.equals("bmp")) {
          assertTexel(200, 70, 110, 255, file(image, format), 0.6, 0.5);
          assertTexel(20, 60, 150, 255, file(image, format), 0.3, 0.5);
        }
      }
    }
    final BufferedImage blackAndWhite = new BufferedImage(2, 1, BufferedImage.TYPE_BYTE_BINARY);
    blackAndWhite.setRGB(1, 0, 0xFFFFFFFF);
    assertTexel(255, 255, 255, 255, file(blackAndWhite, "png"), 0.9, 0.5);
    assertTexel(0, 0, 0, 255, file(blackAndWhite, "png"), 0.1, 0.5);
  }

  /** The stored numbers count, not the colours that a profile makes of them. */
  @Test
  void profilesAreIgnored() {
    final ColorSpace linear = new ICC_ColorSpace(ICC_Profile.getInstance(ColorSpace.CS_LINEAR_RGB));
    final BufferedImage image = components(DataBuffer.TYPE_BYTE, linear, 3);
    image.getRaster().setPixel(0, 0, new int[] {20, 100, 200});
    assertTexel(20, 100, 200, 255, image, 0.5, 0.5);
    final BufferedImage translucent = components(DataBuffer.TYPE_BYTE, linear, 4);
    translucent.getRaster().setPixel(0, 0, new int[] {20, 100, 200, 30});
    assertTexel(20, 100, 200, 30, translucent, 0.5, 0.5);
  }

  /** All kinds of images in memory with 8 bits a channel keep a colour. */
  @Test
  void kindsOfImagesAgree() {
    Trials.of(50, random -> {
      final int rgb = random.nextInt() | 0xFF000000;
      for (final int type : new int[] {BufferedImage.TYPE_INT_RGB, BufferedImage.TYPE_INT_ARGB,
        BufferedImage.TYPE_INT_ARGB_PRE, BufferedImage.TYPE_INT_BGR, BufferedImage.TYPE_3BYTE_BGR,
        BufferedImage.TYPE_4BYTE_ABGR, BufferedImage.TYPE_4BYTE_ABGR_PRE}) {
        final BufferedImage image = new BufferedImage(2, 3, type);
        image.setRGB(1, 2, rgb);
        assertEquals(rgb, new Texture(image).getARGB(0.75, 0.1), () -> "type " + type);
        assertEquals(rgb, new Texture(image.getSubimage(1, 1, 1, 2)).getARGB(0.5, 0.25), () -> "a part, type " + type);
      }
    });
    final BufferedImage half = new BufferedImage(1, 1, BufferedImage.TYPE_4BYTE_ABGR_PRE);
    half.setRGB(0, 0, 0x80FF0000);
    assertEquals(0x80FF0000, new Texture(half).getARGB(0, 0), "as much red as there was");
  }

  @Test
  void nullIsNoImage() {
    final String message = assertThrows(IllegalArgumentException.class, () -> new Texture(null)).getMessage();
    assertTrue(message.startsWith("image "), message);
  }
}
