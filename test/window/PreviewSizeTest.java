package window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;

import org.junit.jupiter.api.Test;

class PreviewSizeTest {

  /** Mean time of a picture at a speed, where one in ten is delayed by a factor. */
  private static double meanSeconds(final double pixelsPerSecond, final double delay) {
    final SplittableRandom random = new SplittableRandom(25);
    final PreviewSize size = new PreviewSize();
    double sum = 0;
    final int pictures = 2000;
    for (int i = 0; i < pictures; i++) {
      final double seconds = size.pixels() / pixelsPerSecond * (random.nextInt(10) == 0 ? delay : 1);
      sum += seconds;
      size.add(size.pixels(), seconds);
    }
    return sum / pictures;
  }

  @Test
  void picturesTakeTheirTimeAtAnySpeed() {
    for (final double speed : new double[] {1e5, 1e6, 1e8}) {
      assertEquals(PreviewSize.SECONDS, meanSeconds(speed, 1), 0.02 * PreviewSize.SECONDS, "speed " + speed);
    }
  }

  /** If the time of each picture alone determined the next, the mean would be 0.048 s for the greater delay. */
  @Test
  void delaysOfSinglePicturesDoNotLowerTheRate() {
    for (final double delay : new double[] {3, 10}) {
      final double mean = meanSeconds(1e6, delay);
      assertTrue(mean < 1.25 * PreviewSize.SECONDS && mean > 0.8 * PreviewSize.SECONDS, delay + ": " + mean);
    }
  }

  @Test
  void aSlowMachineShowsAFewPixelsAtLeast() {
    assertEquals(1500 / 1e3, meanSeconds(1e3, 1), 0.05);
  }
}
