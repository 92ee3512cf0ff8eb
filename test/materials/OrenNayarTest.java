package materials;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import radiometry.ReflectanceRGB;
import trials.Trials;

class OrenNayarTest implements BRDFContract {

  private static final ReflectanceRGB KD = new ReflectanceRGB(1, 0.5f, 0.25f);
  private static final double[] N = {0, 0, 1};

  @Override
  public BRDF brdf() {
    return new OrenNayar(KD, 30);
  }

  /** The formula as in the paper, with its angles. */
  @Test
  void itIsThePapersFormula() {
    Trials.of(2000, random -> {
      final float degrees = 90 * random.nextFloat();
      final double sigma2 = Math.pow(Math.toRadians(degrees), 2);
      final double a = 1 - 0.5 * sigma2 / (sigma2 + 0.33), b = 0.45 * sigma2 / (sigma2 + 0.09);
      final double ti = 1.57 * random.nextDouble(), to = 1.57 * random.nextDouble();
      final double pi = 7 * random.nextDouble(), po = 7 * random.nextDouble();
      final double alpha = Math.max(ti, to), beta = Math.min(ti, to);
      final double f = (a + b * Math.max(0, Math.cos(pi - po)) * Math.sin(alpha) * Math.tan(beta)) / Math.PI;
      final double[] actual = Directions.f(new OrenNayar(KD, degrees), Directions.polar(ti, pi), Directions.polar(to, po), N,
          true);
      assertArrayEquals(new double[] {f, f / 2, f / 4}, actual, 1e-11 * f);
    });
  }

  /** σ = 30°: A = 0.773108, B = 0.338784, worked out by hand. */
  @Test
  void aWorkedExample() {
    final double[] wi = Directions.polar(Math.PI / 3, 0), wo = Directions.polar(Math.PI / 4, 0);
    final double expected = (0.773108 + 0.338784 * Math.sqrt(0.75)) / Math.PI;
    assertEquals(expected, Directions.f(brdf(), wi, wo, N, true)[0], 1e-6);
    assertEquals(0.773108 / Math.PI, Directions.f(brdf(), Directions.polar(1, Math.PI), wo, N, true)[0], 1e-6, "opposite");
  }

  @Test
  void aSmoothOneIsLamberts() {
    Trials.of(500, random -> {
      final double[] n = Directions.random(random), wi = Directions.above(n, random), wo = Directions.above(n, random);
      assertArrayEquals(Directions.f(new Lambertian(KD), wi, wo, n, true),
          Directions.f(new OrenNayar(KD, 0), wi, wo, n, true), 1e-15);
    });
  }

  /** The paper's formula keeps the law of energy from σ = 20° on, and below up to 60°; else all but 1.5 %. */
  @Test
  void noMoreIsReflectedThanArrivesButALittleAtGrazingAngles() {
    for (final float sigma : new float[] {2, 5, 10, 15, 20, 60, 90}) {
      for (final double degrees : new double[] {0, 40, 60, 75, 89}) {
        final double most = sigma >= 20 || degrees <= 60 ? 1.001 : 1.015;
        final double albedo = Albedo.ofSide(new OrenNayar(KD, sigma), Math.toRadians(degrees), true, 1, 150)[0];
        assertTrue(albedo <= most, () -> sigma + " at " + degrees + ": " + albedo);
      }
    }
  }

  @Test
  void itDoesNotMirror() {
    assertNull(brdf().mirror(0.1));
    assertTrue(brdf().scatters());
    assertEquals(new java.awt.Color(255, 128, 64), brdf().getColor());
    assertEquals("OrenNayar(ReflectanceRGB(1.0, 0.5, 0.25), 30.0)", brdf().toString());
  }
}
