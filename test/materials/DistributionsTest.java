package materials;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Function;

import org.junit.jupiter.api.Test;

import primitives.Vector3D;

class DistributionsTest {

  private static final float[] BETAS = {0.1f, 1, 5, 20, 44, 60, 75, 89, 90};

  private static final Map<String, Function<Float, NormalDistributionFunction>> NDFS = Map.of("Blinn", Blinn::new,
      "Horn", Horn::new, "Torrance", Torrance::new, "GGX", GGX::new, "Beckmann", Beckmann::new);

  /** Greatest width up to which β is the angle of half value. */
  private static final Map<String, Float> LIMITS = Map.of("Blinn", 89.9f, "Horn", 44.9f, "Torrance", 90f, "GGX", 90f,
      "Beckmann", 89f);

  private static double density(final NormalDistributionFunction ndf, final double theta) {
    final double sine = Math.sin(theta);
    return ndf.density(Math.cos(theta), sine * sine);
  }

  /** ∫ D (n·h) dω by Gauss's rule of two points, in rings that grow exponentially. */
  private static double integral(final NormalDistributionFunction ndf) {
    final int rings = 40_000;
    double sum = 0;
    for (int i = 0; i < rings; i++) {
      final double low = Math.PI / 2 * Math.expm1(14.0 * i / rings) / Math.expm1(14);
      final double high = Math.PI / 2 * Math.expm1(14.0 * (i + 1) / rings) / Math.expm1(14);
      for (final double s : new double[] {-Math.sqrt(1 / 3.0), Math.sqrt(1 / 3.0)}) {
        final double t = (low + high) / 2 + s * (high - low) / 2;
        sum += Math.PI * density(ndf, t) * Math.sin(2 * t) * (high - low) / 2;
      }
    }
    return sum;
  }

  @Test
  void distributionsAreNormalised() {
    NDFS.forEach((name, ndf) -> {
      for (final float beta : BETAS) {
        final double tolerance = name.equals("Horn") && beta >= 44 ? 1e-4 : name.equals("Beckmann") ? 1e-5 : 1e-6;
        assertEquals(1, integral(ndf.apply(beta)), tolerance, () -> name + " of " + beta);
      }
    });
  }

  @Test
  void theWidthIsTheAngleOfHalfValue() {
    NDFS.forEach((name, ndf) -> {
      for (final float beta : BETAS) {
        final NormalDistributionFunction d = ndf.apply(beta);
        assertEquals(beta, d.getBeta());
        if (beta <= LIMITS.get(name)) {
          assertEquals(0.5, density(d, Math.toRadians(beta)) / density(d, 0), 1e-9, d::toString);
        }
      }
    });
  }

  /** The formulas as they stand, where nothing cancels. */
  @Test
  void wideDistributionsAreTheirFormulas() {
    for (final double beta : new double[] {5, 20, 44, 60, 75, 89}) {
      final double b = Math.toRadians(beta), tan = Math.tan(b), sin = Math.sin(b), cos = Math.cos(b);
      final double q = -Math.log(2) / Math.log(cos), k = Math.log(2) / (b * b);
      assertFormula(new Blinn((float) beta), t -> (q + 2) / (2 * Math.PI) * Math.pow(Math.cos(t), q));
      if (beta < 45) {
        final double h = -Math.log(2) / Math.log(Math.cos(2 * b));
        assertFormula(new Horn((float) beta),
            t -> t < Math.PI / 4 ? 2 * (h + 1) / Math.PI * Math.pow(Math.cos(2 * t), h) : 0);
      }
      final double g = sin * sin / (Math.sqrt(2) - cos * cos), m = tan * tan / (Math.log(2) - 4 * Math.log(cos));
      assertFormula(new GGX((float) beta), t -> g / (Math.PI * Math.pow(g * Math.pow(Math.cos(t), 2)
          + Math.pow(Math.sin(t), 2), 2)));
      assertFormula(new Beckmann((float) beta),
          t -> Math.exp(-Math.pow(Math.tan(t), 2) / m) / (Math.PI * m * Math.pow(Math.cos(t), 4)));
      final double peak = density(new Torrance((float) beta), 0);
      assertFormula(new Torrance((float) beta), t -> peak * Math.exp(-k * t * t));
    }
  }

  private static void assertFormula(final NormalDistributionFunction ndf, final DoubleUnaryOperator formula) {
    for (double t = 0.01; t < Math.PI / 2; t += 0.0317) {
      final double expected = formula.applyAsDouble(t), angle = t;
      assertEquals(expected, density(ndf, t), 1e-9 * expected + 1e-300, () -> ndf + " at " + angle);
    }
  }

  /** Near the normal ln cos θ is a series, which does not cancel: −θ²/2 − θ⁴/12 − θ⁶/45. */
  @Test
  void narrowDistributionsAreTheirSeries() {
    final float beta = 0.1f;
    final double b = Math.toRadians(beta);
    for (double t = 1e-6; t < 0.01; t *= 1.3) {
      final double blinn = -Math.log(2) / logCosine(b), horn = -Math.log(2) / logCosine(2 * b);
      assertEquals((blinn + 2) / (2 * Math.PI) * Math.exp(blinn * logCosine(t)), density(new Blinn(beta), t),
          1e-9 * density(new Blinn(beta), t));
      assertEquals(2 * (horn + 1) / Math.PI * Math.exp(horn * logCosine(2 * t)), density(new Horn(beta), t),
          1e-9 * density(new Horn(beta), t));
    }
    assertEquals(Math.log(2) / (Math.PI * b * b), density(new Torrance(beta), 0), 1e-5 * density(new Torrance(beta), 0));
  }

  /** Near the normal they depend on the sine: a cosine in floats, for which 1 − cos θ is lost, changes nothing. */
  @Test
  void narrowDistributionsLiveByTheSine() {
    NDFS.forEach((name, ndf) -> {
      for (double t = 1e-5; t < 0.004; t *= 1.5) {
        final double sine = Math.sin(t), expected = density(ndf.apply(0.1f), t);
        assertEquals(expected, ndf.apply(0.1f).density((float) Math.cos(t), sine * sine), 1e-4 * expected, name);
      }
    });
  }

  private static double logCosine(final double t) {
    final double t2 = t * t;
    return -t2 / 2 - t2 * t2 / 12 - t2 * t2 * t2 / 45 - 17 * t2 * t2 * t2 * t2 / 2520;
  }

  @Test
  void widestDistributions() {
    for (double t = 0; t < Math.PI / 2; t += 0.01) {
      assertEquals(1 / Math.PI, density(new Blinn(90), t), 1e-12);
      assertEquals(t < Math.PI / 4 ? 2 / Math.PI : 0, density(new Horn(45), t), 1e-12);
      assertEquals(density(new Horn(45), t), density(new Horn(90), t));
      assertEquals(density(new Beckmann(89), t), density(new Beckmann(89.5f), t));
      assertEquals(density(new Beckmann(89), t), density(new Beckmann(90), t));
    }
    assertEquals(0, new Horn(90).density(Math.sqrt(0.5), 0.5));
    assertEquals(1 / Math.PI, new Blinn(90).density(Double.MIN_VALUE, 1), 1e-12);
    assertEquals(0, new Beckmann(60).density(1e-100, 1));
    assertEquals(0, new Blinn(20).density(Double.MIN_VALUE, 1));
  }

  @Test
  void vectorsOfAnyLengthAreUnderstood() {
    final double theta = 0.3;
    final double[] tilted = Directions.unit(0.2, -0.5, 0.7), across = Directions.unit(0.7, 0, -0.2);
    final Vector3D n = Directions.vector(3 * tilted[0], 3 * tilted[1], 3 * tilted[2]);
    final Vector3D h = new Vector3D();
    h.scaleAdd((float) Math.tan(theta), Directions.vector(across), Directions.vector(tilted));
    NDFS.forEach((name, ndf) -> {
      final NormalDistributionFunction d = ndf.apply(20f);
      assertEquals(density(d, theta), d.getProbability(n, h), 1e-5 * density(d, theta), name);
      assertEquals(density(d, 0), d.getProbability(n, n), 1e-12 * density(d, 0));
      h.negate();
      assertEquals(0, d.getProbability(n, h), "from behind");
      h.negate();
    });
    assertEquals(0, new Blinn(90).getProbability(new Vector3D(0, 0, 1), new Vector3D(1, 0, 0)), "across");
  }

  @Test
  void narrowDistributionsSurviveFloats() {
    final float beta = 0.1f;
    NDFS.forEach((name, ndf) -> {
      for (double t = 0; t < 0.004; t += 0.0005) {
        final double expected = density(ndf.apply(beta), t);
        final Vector3D n = Directions.vector(0, 0, 1), h = Directions.vector(Directions.polar(t, 0.4));
        assertEquals(expected, ndf.apply(beta).getProbability(n, h), 1e-3 * expected, name);
      }
    });
  }

  @Test
  void surfacesBelowATenthOfADegreeArePolished() {
    NDFS.forEach((name, ndf) -> {
      for (final float beta : new float[] {0, Float.MIN_VALUE, 0.05f, Math.nextDown(0.1f)}) {
        final NormalDistributionFunction d = ndf.apply(beta);
        assertTrue(d.isPolished(), d::toString);
        assertEquals(0, d.getProbability(new Vector3D(0, 0, 1), new Vector3D(0, 0, 1)));
      }
      assertFalse(ndf.apply(0.1f).isPolished());
      assertEquals(name + "(20.0)", ndf.apply(20f).toString());
    });
  }

  @Test
  void wrongValuesAreRefused() {
    NDFS.values().forEach(ndf -> {
      for (final float wrong : new float[] {-Float.MIN_VALUE, Math.nextUp(90f), Float.NaN, Float.POSITIVE_INFINITY}) {
        final String message = assertThrows(IllegalArgumentException.class, () -> ndf.apply(wrong)).getMessage();
        assertTrue(message.startsWith("beta must") && message.endsWith(" " + wrong), message);
      }
      final Vector3D z = new Vector3D(0, 0, 1);
      for (final Vector3D wrong : new Vector3D[] {null, new Vector3D(), new Vector3D(Float.NaN, 0, 0)}) {
        assertThrows(IllegalArgumentException.class, () -> ndf.apply(9f).getProbability(wrong, z));
        assertThrows(IllegalArgumentException.class, () -> ndf.apply(9f).getProbability(z, wrong));
      }
    });
  }

  /** A user-written distribution: all directions within β equally likely. */
  @Test
  void aDistributionOfOnesOwnWorksInMaterials() {
    final NormalDistributionFunction cap = new NormalDistributionFunction(10) {
      @Override
      protected double density(final double cosine, final double sine2) {
        final double edge = Math.pow(Math.sin(Math.toRadians(getBeta())), 2);
        return sine2 <= edge ? 1 / (Math.PI * edge) : 0;
      }
    };
    assertEquals(1, integral(cap), 1e-3);
    final BRDF phong = new PhongLafortune(null, new radiometry.ReflectanceRGB(1, 1, 1), cap);
    final double[] n = {0, 0, 1}, wo = Directions.polar(0.5, 0);
    for (final double theta : new double[] {0.5, 0.5 + 2 * 0.17, 0.5 - 2 * 0.17}) {
      assertTrue(Directions.f(phong, Directions.polar(theta, Math.PI), wo, n, true)[0] > 1);
    }
    assertEquals(0, Directions.f(phong, Directions.polar(0.5 + 2 * 0.18, Math.PI), wo, n, true)[0]);
  }
}
