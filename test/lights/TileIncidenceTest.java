package lights;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;

import org.junit.jupiter.api.Test;

import primitives.Point3D;
import radiometry.RadianceRGB;
import radiometry.SpectrumRGB;
import trials.Trials;

/** The light of many points at once is that of each point by itself, bit for bit. */
class TileIncidenceTest {

  private static final SpectrumRGB WARM = new SpectrumRGB(0.5f, 0.3f, 0.2f);
  private static final int POINTS = 50;

  /** A light as a student writes it: dark below. */
  private static final class Candle extends Light {

    Candle(final Point3D position) {
      super(position, WARM, 20);
    }

    @Override
    public RadianceRGB getIrradianceAt(final Point3D P) {
      return P.y < 0 ? RadianceRGB.NORADIANCE : getPower().times(1 / (1.0 + P.distanceSquared(getPosition())));
    }
  }

  private static Point3D point(final Random random, final double scale) {
    return new Point3D((float) (scale * random.nextGaussian()), (float) (scale * random.nextGaussian()),
        (float) (scale * random.nextGaussian()));
  }

  @Test
  void manyPointsAreLitAsEachByItself() {
    final int[] lit = {0, 0};
    final TileIncidence many = new TileIncidence(POINTS);
    Trials.of(200, random -> {
      final Point3D S = point(random, 3), C = point(random, 3);
      for (final Light light : List.of(new Omnidirectional(S, WARM, 70), new Spot(S, C, 40, WARM, 30),
          new Directional(S, C, 2, WARM, 10), new Candle(S))) {
        final int n = random.nextInt(POINTS + 1);
        final double[] x = new double[n], y = new double[n], z = new double[n];
        for (int i = 0; i < n; i++) {
          x[i] = i == 0 ? S.x : 3 * random.nextGaussian();
          y[i] = i == 0 ? S.y : 3 * random.nextGaussian();
          z[i] = i == 0 ? S.z : 3 * random.nextGaussian();
        }
        light.illuminate(n, x, y, z, many);
        for (int i = 0; i < n; i++) {
          lit[assertSame(light, x[i], y[i], z[i], many, i) ? 1 : 0]++;
        }
      }
    });
    assertTrue(lit[0] > 2000 && lit[1] > 2000, () -> lit[0] + " dark, " + lit[1] + " lit");
  }

  private static boolean assertSame(final Light light, final double x, final double y, final double z,
      final TileIncidence many, final int i) {
    final Incidence one = new Incidence();
    final boolean isLit = light.illuminate(x, y, z, one);
    assertEquals(isLit, many.isLit(i), light::toString);
    if (isLit) {
      assertEquals(text(one.irradianceR(), one.irradianceG(), one.irradianceB(), one.directionX(), one.directionY(),
          one.directionZ(), one.distance()), text(many.irradianceR(i), many.irradianceG(i), many.irradianceB(i),
          many.directionX(i), many.directionY(i), many.directionZ(i), many.distance(i)));
    }
    return isLit;
  }

  private static String text(final double... numbers) {
    return java.util.Arrays.toString(numbers);
  }

  /** A light at the very point, or so far away that no double holds the distance, brings nothing. */
  @Test
  void lightsWithoutADirectionBringNothing() {
    final TileIncidence many = new TileIncidence(3);
    final Light lamp = new Omnidirectional(new Point3D(1, 2, 3), WARM, 70);
    lamp.illuminate(3, new double[] {1, 1e200, 1}, new double[] {2, 2, 2}, new double[] {3, 3, 3.5}, many);
    assertFalse(many.isLit(0));
    assertFalse(many.isLit(1));
    assertTrue(many.isLit(2));
    assertEquals(0.5, many.distance(2));
  }

  /** However close a light is, its irradiance is a number that products do not take to infinity. */
  @Test
  void irradianceIsLimited() {
    final TileIncidence many = new TileIncidence(1);
    final Light lamp = new Omnidirectional(new Point3D(0, 0, 0), WARM, 70);
    lamp.illuminate(1, new double[] {1e-150}, new double[] {0}, new double[] {0}, many);
    assertTrue(assertSame(lamp, 1e-150, 0, 0, many, 0));
    assertTrue(many.irradianceR(0) > 1e150 && 1e100 * many.irradianceR(0) < Double.POSITIVE_INFINITY);
  }
}
