package radiometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;

import org.junit.jupiter.api.Test;

class ReflectanceRGBTest {

  @Test
  void factorsAreUsedAsTheyAre() {
    final ReflectanceRGB k = new ReflectanceRGB(0, 0.25f, 1);
    assertEquals(0, k.getR());
    assertEquals(0.25f, k.getG());
    assertEquals(1, k.getB());
    assertEquals("ReflectanceRGB(0.0, 0.25, 1.0)", k.toString());
  }

  @Test
  void blackReflectsInNoChannel() {
    assertTrue(new ReflectanceRGB(0, 0, 0).isBlack());
    assertFalse(new ReflectanceRGB(Float.MIN_VALUE, 0, 0).isBlack());
    assertFalse(new ReflectanceRGB(0, Float.MIN_VALUE, 0).isBlack());
    assertFalse(new ReflectanceRGB(0, 0, Float.MIN_VALUE).isBlack());
  }

  /** By IEC 61966-2-1: 188 is a little over half of white; 10 and 11 are on both sides of the knee. */
  @Test
  void coloursAreDecodedToLinear() {
    final ReflectanceRGB k = new ReflectanceRGB(new Color(255, 188, 0));
    assertEquals(1, k.getR());
    assertEquals(0.5028865f, k.getG(), 1e-6);
    assertEquals(0, k.getB());
    final ReflectanceRGB dark = new ReflectanceRGB(new Color(10, 11, 128, 0));
    assertEquals(10 / 255.0 / 12.92, dark.getR(), 1e-9);
    assertEquals(0.0033465358, dark.getG(), 1e-9);
    assertEquals(0.21586050, dark.getB(), 1e-7);
  }

  /** Decoding and encoding restores a colour. */
  @Test
  void decodingIsTheInverseOfEncoding() {
    for (int i = 0; i < 256; i++) {
      final double v = new ReflectanceRGB(new Color(i, i, i)).getG();
      final double s = v <= 0.0031308 ? 12.92 * v : 1.055 * Math.pow(v, 1 / 2.4) - 0.055;
      assertEquals(i, 255 * s, 1e-3);
    }
  }

  @Test
  void whatIsNoFactorIsRefusedWithNameAndValue() {
    for (final float wrong : new float[] {-Float.MIN_VALUE, Math.nextUp(1f), -1, 255, Float.NaN, Float.POSITIVE_INFINITY,
      Float.NEGATIVE_INFINITY}) {
      assertRefused("r", wrong, () -> new ReflectanceRGB(wrong, 1, 1));
      assertRefused("g", wrong, () -> new ReflectanceRGB(1, wrong, 1));
      assertRefused("b", wrong, () -> new ReflectanceRGB(1, 1, wrong));
    }
    assertThrows(IllegalArgumentException.class, () -> new ReflectanceRGB(null));
  }

  private static void assertRefused(final String name, final float value,
      final org.junit.jupiter.api.function.Executable call) {
    final String message = assertThrows(IllegalArgumentException.class, call).getMessage();
    assertTrue(message.startsWith(name + " ") && message.endsWith(" " + value), message);
  }
}
