package inspection;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;

import org.junit.jupiter.api.Test;

class DifferenceTest {

  private static final int BLACK = 0xff000000;

  private static BufferedImage picture(final int... pixels) {
    final BufferedImage picture = new BufferedImage(2, 2, BufferedImage.TYPE_INT_ARGB);
    picture.setRGB(0, 0, 2, 2, pixels, 0, 2);
    return picture;
  }

  @Test
  void equalPicturesDifferNowhere() {
    final Difference difference = Difference.between(picture(1, 2, 3, 4), picture(1, 2, 3, 4)).orElseThrow();
    assertEquals(0, difference.differing());
    assertEquals(0, difference.largest());
    assertEquals(0, difference.mean());
    assertEquals(BLACK, difference.mask().getRGB(1, 1));
  }

  @Test
  void theWorstPixelIsTheOneThatDiffersMostInAnyChannel() {
    final Difference difference = Difference.between(picture(0xff000000, 0xff000000, 0xff000000, 0xff000000),
        picture(0xff000005, 0xff000000, 0xff006400, 0xfa000000)).orElseThrow();
    assertEquals(3, difference.differing());
    assertEquals(100, difference.largest());
    assertEquals((5 + 100 + 5) / 4.0, difference.mean());
    assertEquals(0, difference.worstX());
    assertEquals(1, difference.worstY());
    assertEquals(BLACK, difference.mask().getRGB(1, 0));
    assertNotEquals(BLACK, difference.mask().getRGB(0, 0));
  }

  @Test
  void picturesOfOtherSizesAreNotCompared() {
    final BufferedImage wide = new BufferedImage(3, 2, BufferedImage.TYPE_INT_ARGB);
    assertTrue(Difference.between(picture(1, 2, 3, 4), wide).isEmpty());
  }
}
