package materials;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import primitives.Vector3D;
import radiometry.RadianceRGB;
import radiometry.ReflectanceRGB;
import trials.Trials;

/** Lobes agree with the formulas of the specification in BigDecimal, in wide and in narrow ones. */
class ExactMaterialsTest {

  private static final float[] BETAS = {0.1f, 1, 5, 20, 60, 90};
  private static final ReflectanceRGB KD = new ReflectanceRGB(0.25f, 0.5f, 0), KS = new ReflectanceRGB(0.5f, 0.125f, 0.75f);

  /** A pair of directions, mostly within the lobe. */
  private static double[][] pair(final java.util.Random random, final float beta) {
    final double[] n = Directions.random(random), wi = Directions.above(n, random);
    final double spread = 2 * Math.toRadians(beta) * random.nextDouble();
    final double[] wo = random.nextInt(4) == 0 ? Directions.above(n, random)
        : Directions.near(Directions.mirrored(wi, n), spread, random);
    return new double[][] {wi, Directions.dot(n, wo) > 0 ? wo : Directions.mirrored(wi, n), n};
  }

  @Test
  void brdfsAreTheirFormulas() {
    Trials.of(600, random -> {
      final float beta = BETAS[random.nextInt(BETAS.length)];
      final double[][] p = pair(random, beta);
      final ExactMaterials exact = new ExactMaterials(p[0], p[1], p[2], beta);
      final GGX ndf = new GGX(beta);
      final double[] phong = Directions.f(new PhongLafortune(KD, KS, ndf), p[0], p[1], p[2], true);
      final double[] torrance = Directions.f(new ReflectiveCookTorrance(KD, KS, ndf), p[0], p[1], p[2], true);
      final double[] ashikhmin = Directions.f(new AshikhminShirley(KD, KS, ndf), p[0], p[1], p[2], true);
      final double[] kd = {KD.getR(), KD.getG(), KD.getB()}, ks = {KS.getR(), KS.getG(), KS.getB()};
      for (int c = 0; c < 3; c++) {
        assertClose(exact.phong(kd[c], ks[c]), phong[c], 1e-9);
        assertClose(exact.cookTorrance(kd[c], ks[c]), torrance[c], 1e-9);
        assertClose(exact.ashikhmin(kd[c], ks[c]), ashikhmin[c], 1e-9);
      }
    });
  }

  /** Through vectors of floats: 1e-5, and 1e-3 of narrow lobes. */
  @Test
  void theOpenInterfaceIsExactEnough() {
    Trials.of(600, random -> {
      final float beta = BETAS[random.nextInt(BETAS.length)];
      final double[][] p = pair(random, beta);
      final Vector3D wi = Directions.vector(p[0]), wo = Directions.vector(p[1]), n = Directions.vector(p[2]);
      if (Directions.dot(p[2], p[0]) > 0.1 && Directions.dot(p[2], p[1]) > 0.1) {
        final double expected = new ExactMaterials(p[0], p[1], p[2], beta).cookTorrance(0.25, 0.5);
        assertClose(expected, new ReflectiveCookTorrance(KD, KS, new GGX(beta)).reflect(new RadianceRGB(1, 1, 1), wi, wo, n)
            .getR(), beta < 1 ? 1e-3 : beta < 5 ? 1e-4 : 1e-5);
      }
    });
  }

  @Test
  void glassIsItsFormulaOnBothSides() {
    final int[] seen = {0};
    Trials.of(1500, random -> {
      final float beta = BETAS[random.nextInt(BETAS.length)], in = 1 + random.nextFloat(), out = 1 + random.nextFloat() / 2;
      final boolean outside = random.nextBoolean();
      final double o = outside ? out : in, t = outside ? in : out;
      final double[][] p = pair(random, beta);
      final BTDF glass = new TransmissiveCookTorrance(new ReflectanceRGB(0.5f, 0.25f, 0), in, out, new GGX(beta));
      final double[] same = Directions.f(glass, p[0], p[1], p[2], outside);
      assertClose(new ExactMaterials(p[0], p[1], p[2], beta).glassReflection(o, t) / 2, same[0], 1e-8);
      assertEquals(same[0] / 2, same[1]);
      assertEquals(0, same[2]);
      final double[] wi = refractedNear(p[1], p[2], o / t, beta, random);
      if (wi != null) {
        final double[] other = Directions.f(glass, wi, p[1], p[2], outside);
        final double expected = new ExactMaterials(wi, p[1], p[2], beta).glassTransmission(o, t) / 2;
        assertClose(expected, other[0], 1e-8);
        assertEquals(other[0] / 2, other[1]);
        seen[0] += expected > 0 ? 1 : 0;
      }
    });
    assertTrue(seen[0] > 300, () -> "only " + seen[0] + " pairs with light");
  }

  /** A direction on the other side near the refracted one; null if none. */
  private static double[] refractedNear(final double[] wo, final double[] n, final double ratio, final float beta,
      final java.util.Random random) {
    final double co = Directions.dot(n, wo), square = 1 - ratio * ratio * (1 - co * co);
    if (square < 0) {
      return null;
    }
    final double k = ratio * co - Math.sqrt(square);
    final double[] exact = Directions.unit(-ratio * wo[0] + k * n[0], -ratio * wo[1] + k * n[1], -ratio * wo[2] + k * n[2]);
    final double[] wi = Directions.near(exact, Math.abs(ratio - 1) * Math.toRadians(beta) * random.nextDouble(), random);
    return Directions.dot(n, wi) < 0 ? wi : null;
  }

  private static void assertClose(final double expected, final double actual, final double tolerance) {
    assertEquals(expected, actual, tolerance * Math.abs(expected));
  }
}
