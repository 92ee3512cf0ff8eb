package radiometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class RadianceRGBTest {

  private static final RadianceRGB L = new RadianceRGB(1, 2.5, 4);

  private static void assertRadiance(final double r, final double g, final double b, final RadianceRGB actual) {
    assertEquals(r, actual.getR(), "red");
    assertEquals(g, actual.getG(), "green");
    assertEquals(b, actual.getB(), "blue");
  }

  @Test
  void channelsAreKeptInOrder() {
    assertRadiance(1, 2.5, 4, L);
    assertRadiance(0, 0, 0, RadianceRGB.NORADIANCE);
    assertRadiance(Double.MAX_VALUE, Double.MIN_VALUE, 0, new RadianceRGB(Double.MAX_VALUE, Double.MIN_VALUE, 0));
    assertEquals("RadianceRGB(1.0, 2.5, 4.0)", L.toString());
  }

  @Test
  void sumsAndProductsAreThoseOfTheChannels() {
    assertRadiance(9, 10.5, 10, L.plus(new RadianceRGB(8, 8, 6)));
    assertRadiance(3, 7.5, 12, L.times(3));
    assertRadiance(0, 0, 0, L.times(0));
    assertRadiance(0.5, 0, 1, L.times(new ReflectanceRGB(0.5f, 0, 0.25f)));
    assertRadiance(1, 2.5, 4, L);
  }

  @Test
  void whatIsNoRadianceIsRefusedWithNameAndValue() {
    for (final double wrong : new double[] {-1e-300, -1, Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY}) {
      assertRefused("r", wrong, () -> new RadianceRGB(wrong, 1, 1));
      assertRefused("g", wrong, () -> new RadianceRGB(1, wrong, 1));
      assertRefused("b", wrong, () -> new RadianceRGB(1, 1, wrong));
      assertRefused("factor", wrong, () -> L.times(wrong));
    }
    assertRefused("b", Double.POSITIVE_INFINITY, () -> L.times(Double.MAX_VALUE / 3));
    assertThrows(IllegalArgumentException.class, () -> L.plus(null));
    assertThrows(IllegalArgumentException.class, () -> L.times(null));
  }

  private static void assertRefused(final String name, final double value,
      final org.junit.jupiter.api.function.Executable call) {
    final String message = assertThrows(IllegalArgumentException.class, call).getMessage();
    assertTrue(message.startsWith(name + " ") && message.endsWith(" " + value), message);
  }
}
