package radiometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class SpectrumRGBTest {

  @Test
  void equalSharesAreWhiteLightOfTheWholePower() {
    final RadianceRGB white = new SpectrumRGB(1 / 3f, 1 / 3f, 1 / 3f).distribute(1500);
    assertEquals(1500, white.getR(), 1e-9);
    assertEquals(1500, white.getG(), 1e-9);
    assertEquals(1500, white.getB(), 1e-9);
  }

  @Test
  void eachChannelHasThreeTimesItsShare() {
    final RadianceRGB channels = new SpectrumRGB(0.5f, 0.25f, 0.25f).distribute(8);
    assertEquals(12, channels.getR(), 1e-12);
    assertEquals(6, channels.getG(), 1e-12);
    assertEquals(6, channels.getB(), 1e-12);
    assertEquals(0, new SpectrumRGB(0, 0.75f, 0.25f).distribute(8).getR(), "a share of 0");
    assertEquals(24, new SpectrumRGB(0, 0, 1).distribute(8).getB(), 1e-12);
    assertEquals(0, new SpectrumRGB(0, 0, 1).distribute(0).getB());
  }

  @Test
  void sharesAreDividedByTheirSum() {
    for (final float g : new float[] {0.2501f - 2e-6f, 0.2499f + 2e-6f}) {
      final RadianceRGB channels = new SpectrumRGB(0.5f, g, 0.25f).distribute(100);
      assertEquals(300, channels.getR() + channels.getG() + channels.getB(), 1e-9);
      assertEquals(g / 0.5, channels.getG() / channels.getR(), 1e-6);
    }
  }

  @Test
  void sharesThatAreNoneOrDoNotAddUpAreRefusedWithTheirValues() {
    for (final float wrong : new float[] {-Float.MIN_VALUE, -0.5f, Float.NaN, Float.POSITIVE_INFINITY,
      Float.NEGATIVE_INFINITY}) {
      assertRefused("r ", wrong, () -> new SpectrumRGB(wrong, 0.5f, 0.5f));
      assertRefused("g ", wrong, () -> new SpectrumRGB(0.5f, wrong, 0.5f));
      assertRefused("b ", wrong, () -> new SpectrumRGB(0.5f, 0.5f, wrong));
    }
    assertRefused("the shares ", 0.75f, () -> new SpectrumRGB(0.25f, 0.25f, 0.25f));
    assertRefused("the shares ", 1.25f, () -> new SpectrumRGB(0.25f, 0.75f, 0.25f));
    assertRefused("the shares ", 0, () -> new SpectrumRGB(0, 0, 0));
    assertThrows(IllegalArgumentException.class, () -> new SpectrumRGB(0.5f, 0.25f, 0.2502f));
    assertThrows(IllegalArgumentException.class, () -> new SpectrumRGB(0.5f, 0.25f, 0.2498f));
    final String message = assertThrows(IllegalArgumentException.class, () -> new SpectrumRGB(0.5f, 0.125f, 0.125f))
        .getMessage();
    assertTrue(message.contains("SpectrumRGB(0.5, 0.125, 0.125)"), message);
  }

  @Test
  void aPowerThatIsNoneIsRefused() {
    final SpectrumRGB white = new SpectrumRGB(0.25f, 0.5f, 0.25f);
    for (final double wrong : new double[] {-1e-300, Double.NaN, Double.POSITIVE_INFINITY}) {
      final String message = assertThrows(IllegalArgumentException.class, () -> white.distribute(wrong)).getMessage();
      assertTrue(message.startsWith("power "), message);
    }
  }

  private static void assertRefused(final String name, final float value,
      final org.junit.jupiter.api.function.Executable call) {
    final String message = assertThrows(IllegalArgumentException.class, call).getMessage();
    assertTrue(message.startsWith(name) && message.endsWith(" " + value), message);
  }
}
