package materials;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;

import org.junit.jupiter.api.Test;

import radiometry.ReflectanceRGB;
import trials.Trials;

class FresnelTest {

  private static final ReflectanceRGB WHITE = new ReflectanceRGB(1, 1, 1);
  private static final float[] ETAS = {1.0002926f, 1.33f, 1.5f, 2.417f, 0.8f};

  private static BTDF glass(final float in, final float out) {
    return new IdealDielectric(WHITE, in, out);
  }

  /** Hecht, "Optics", chapter 4: glass in air 4 % at normal incidence, water 2 %; diamond 17.2 %. */
  @Test
  void publishedReflectances() {
    assertEquals(0.04, glass(1.5f, 1).getReflectance(1, true), 1e-9);
    assertEquals(0.0200593, glass(1.33f, 1).getReflectance(1, true), 1e-6);
    assertEquals(0.172, glass(2.417f, 1).getReflectance(1, true), 1e-3);
    assertEquals(0.0502, glass(1.5f, 1).getReflectance(Math.sqrt(0.5), true), 1e-4);
    assertEquals(0.0892, glass(1.5f, 1).getReflectance(0.5, true), 1e-4);
    assertEquals(0.3878, glass(1.5f, 1).getReflectance(Math.cos(Math.toRadians(80)), true), 1e-3);
  }

  @Test
  void frontallyAndAlongTheSurface() {
    for (final float in : ETAS) {
      for (final float out : ETAS) {
        final double d = ((double) in - out) / ((double) in + out);
        for (final boolean outside : new boolean[] {true, false}) {
          assertEquals(d * d, glass(in, out).getReflectance(1, outside), 1e-12);
          assertEquals(in == out ? 0 : 1, glass(in, out).getReflectance(in == out ? 1e-9 : 0, outside), 0);
        }
      }
    }
  }

  /** Only the part across the plane of incidence is reflected, ((n² − 1) / (n² + 1))² of it, half of all. */
  @Test
  void atBrewstersAngleOnePolarisationIsMissing() {
    for (final float eta : ETAS) {
      final double brewster = Math.atan(eta), n2 = (double) eta * eta, across = (n2 - 1) / (n2 + 1);
      assertEquals(across * across / 2, glass(eta, 1).getReflectance(Math.cos(brewster), true), 1e-12);
    }
  }

  @Test
  void reflectionIsTotalFromTheCriticalAngle() {
    for (final float eta : new float[] {1.0002926f, 1.33f, 1.5f, 2.417f}) {
      final double critical = Math.asin(1 / (double) eta);
      final SpecularRays rays = new SpecularRays();
      assertEquals(1, glass(eta, 1).getReflectance(Math.cos(critical + 1e-6), false));
      assertTrue(glass(eta, 1).getReflectance(Math.cos(critical - 1e-6), false) < 1);
      assertTrue(glass(eta, 1).specular(Math.cos(critical + 1e-6), false, rays));
      assertEquals("1.0 1.0 1.0 0.0 0.0 0.0", factors(rays));
      assertEquals("1.0 1.0", rays.ratio() + " " + rays.refractedCosine(), "nothing is bent");
      assertTrue(glass(eta, 1).specular(Math.cos(critical - 1e-6), false, rays));
      assertTrue(rays.refractedR() > 0 && rays.refractedG() > 0 && rays.refractedB() > 0);
      assertTrue(glass(eta, 1).getReflectance(0.01, true) < 1, "never from outside");
      assertEquals(1, glass(1 / eta, 1).getReflectance(Math.cos(critical + 1e-6), true), "a bubble");
    }
  }

  private static String factors(final SpecularRays rays) {
    return rays.reflectedR() + " " + rays.reflectedG() + " " + rays.reflectedB() + " " + rays.refractedR() + " "
        + rays.refractedG() + " " + rays.refractedB();
  }

  /** Both ends of a path see the same reflectance; there and back the radiance is as it was, less what is reflected. */
  @Test
  void bothSidesSeeTheSameAlongOnePath() {
    Trials.of(1000, random -> {
      final float in = 0.5f + 2 * random.nextFloat(), out = 0.5f + 2 * random.nextFloat();
      final double cosine = random.nextDouble();
      final SpecularRays there = new SpecularRays(), back = new SpecularRays();
      glass(in, out).specular(cosine, true, there);
      if (there.refractedR() > 0) {
        glass(in, out).specular(there.refractedCosine(), false, back);
        assertEquals(there.reflectedG(), back.reflectedG(), 1e-9);
        assertEquals(cosine, back.refractedCosine(), 1e-9);
        assertEquals(1, there.ratio() * back.ratio(), 1e-12);
        final double passing = 1 - there.reflectedB();
        assertEquals(passing * passing, there.refractedB() * back.refractedB(), 1e-9);
        assertEquals(passing * there.ratio() * there.ratio(), there.refractedB(), 1e-12);
      }
    });
  }

  @Test
  void reflectancesAreTheirFormulaInBigDecimal() {
    Trials.of(500, random -> {
      final float in = 0.5f + 2 * random.nextFloat(), out = 0.5f + 2 * random.nextFloat();
      final double cosine = random.nextDouble();
      final double expected = ExactMaterials.fresnel(new BigDecimal(cosine), new BigDecimal(out), new BigDecimal(in))
          .doubleValue();
      assertEquals(expected, glass(in, out).getReflectance(cosine, true), 1e-10);
      assertEquals(expected, glass(out, in).getReflectance(cosine, false), 1e-10);
    });
  }

  /** Snell's law, for the direction that a renderer makes of the numbers: r d + (r co − cos θt) n. */
  @Test
  void refractedRaysObeySnell() {
    Trials.of(1000, random -> {
      final float in = 1 + random.nextFloat(), out = 1 + random.nextFloat();
      final boolean outside = random.nextBoolean();
      final double[] n = Directions.random(random), wo = Directions.above(n, random);
      final SpecularRays rays = new SpecularRays();
      final double co = Directions.dot(n, wo), r = (outside ? out : in) / (double) (outside ? in : out);
      glass(in, out).specular(co, outside, rays);
      if (rays.refractedR() > 0) {
        assertEquals(r, rays.ratio(), 1e-12);
        final double k = r * co - rays.refractedCosine();
        final double[] t = {-r * wo[0] + k * n[0], -r * wo[1] + k * n[1], -r * wo[2] + k * n[2]};
        assertEquals(1, Directions.dot(t, t), 1e-12, "a unit vector");
        assertEquals(-rays.refractedCosine(), Directions.dot(t, n), 1e-12);
        final double sine = Math.sqrt(1 - co * co), refracted = Math.sqrt(1 - Math.pow(Directions.dot(t, n), 2));
        assertEquals(r * sine, refracted, 1e-7, "Snell");
        final double along = (Directions.dot(t, wo) - Directions.dot(t, n) * co);
        assertTrue(along <= 1e-12, "on the other side of the normal");
      }
    });
  }

  @Test
  void cosinesBeyondOneByRoundingCountAsOne() {
    final SpecularRays rays = new SpecularRays();
    glass(1.5f, 1).specular(1 + 0x1p-40, true, rays);
    assertEquals(0.04, rays.reflectedR(), 1e-12);
    assertEquals(1, rays.refractedCosine());
    assertEquals(0, Fresnel.schlick(1 + 0x1p-40));
    assertEquals(1, Fresnel.schlick(0));
    assertEquals(1 / 32.0, Fresnel.schlick(0.5));
  }

  /** An index of 1 to 1 is invisible but for k; k acts on both rays. */
  @Test
  void theFactorActsOnBothRays() {
    final SpecularRays rays = new SpecularRays();
    final BTDF nothing = new IdealDielectric(new ReflectanceRGB(1, 0.5f, 0), 1.25f, 1.25f);
    assertTrue(nothing.specular(0.3, true, rays));
    assertEquals("0.0 0.0 0.0 1.0 0.5 0.0", factors(rays));
    assertEquals(0.3, rays.refractedCosine(), 1e-12);
    assertEquals(1, nothing.getReflectance(0, true), "along the surface everything is");
    final BTDF tinted = new IdealDielectric(new ReflectanceRGB(1, 0.5f, 0), 1.5f, 1);
    assertTrue(tinted.specular(1, false, rays));
    assertEquals(0.04, rays.reflectedR(), 1e-12);
    assertEquals(0.02, rays.reflectedG(), 1e-12);
    assertEquals(0, rays.reflectedB());
    assertEquals(0.96 * 2.25, rays.refractedR(), 1e-12);
    assertEquals(0.48 * 2.25, rays.refractedG(), 1e-12);
  }
}
