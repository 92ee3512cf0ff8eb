package materials;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;

import org.junit.jupiter.api.Test;

import primitives.Vector3D;
import radiometry.RadianceRGB;
import radiometry.ReflectanceRGB;
import trials.Trials;

/** Laws of rough glass: energy, reciprocity, its ideal rays and its ideal limit. */
class GlassTest {

  private static final ReflectanceRGB WHITE = new ReflectanceRGB(1, 1, 1);
  private static final double[] N = {0, 0, 1};

  private static BTDF rough(final NormalDistributionFunction ndf) {
    return new TransmissiveCookTorrance(WHITE, 1.5f, 1, ndf);
  }

  /** Both sides together, the other without the change of radiance at an interface. */
  @Test
  void noMoreIsScatteredThanArrives() {
    for (final NormalDistributionFunction ndf : List.of(new GGX(5), new GGX(60), new Blinn(30), new Beckmann(90),
        new Torrance(45), new Horn(40))) {
      for (final boolean outside : new boolean[] {true, false}) {
        for (final double degrees : new double[] {0, 40, 75, 89}) {
          final double theta = Math.toRadians(degrees), ratio = outside ? 1 / 1.5 : 1.5;
          final double same = Albedo.ofSide(rough(ndf), theta, outside, 1, 150)[0];
          final double other = Albedo.ofSide(rough(ndf), theta, outside, -1, 250)[0] / (ratio * ratio);
          assertTrue(same + other <= 1.001, () -> ndf + ", " + outside + ", " + degrees + ": " + same + " + " + other);
        }
      }
    }
  }

  /** A narrow lobe lets through what a smooth surface does. */
  @Test
  void narrowLobesTendToTheIdealRays() {
    for (final boolean outside : new boolean[] {true, false}) {
      for (final double degrees : new double[] {0, 25}) {
        final double theta = Math.toRadians(degrees);
        final SpecularRays rays = new SpecularRays();
        rough(null).specular(Math.cos(theta), outside, rays);
        for (final NormalDistributionFunction ndf : List.of(new Blinn(2), new Beckmann(2))) {
          final double other = Albedo.ofSide(rough(ndf), theta, outside, -1, 700)[0];
          final double same = Albedo.ofSide(rough(ndf), theta, outside, 1, 700)[0];
          assertEquals(rays.refractedR(), other, 0.03 * rays.refractedR(), ndf::toString);
          assertEquals(rays.reflectedR(), same, 0.03 * rays.reflectedR(), ndf::toString);
        }
      }
    }
  }

  /** f over the square of the index on the viewer's side is the same from both ends of the path. */
  @Test
  void theBtdfIsReciprocal() {
    final int[] seen = {0};
    Trials.of(3000, random -> {
      final float in = 1 + random.nextFloat(), out = 1 + random.nextFloat();
      final BTDF glass = new TransmissiveCookTorrance(WHITE, in, out, new GGX(1 + 60 * random.nextFloat()));
      final double[] n = Directions.random(random), outer = Directions.above(n, random);
      final double[] inner = Directions.minus(Directions.above(n, random)), other = Directions.above(n, random);
      final double there = Directions.f(glass, inner, outer, n, true)[0] / ((double) out * out);
      final double back = Directions.f(glass, outer, inner, Directions.minus(n), false)[0] / ((double) in * in);
      assertEquals(there, back, 1e-6 * there);
      final double same = Directions.f(glass, other, outer, n, true)[0];
      assertEquals(same, Directions.f(glass, outer, other, n, true)[0], 1e-6 * same);
      seen[0] += there > 0 ? 1 : 0;
    });
    assertTrue(seen[0] > 200, () -> "only " + seen[0] + " pairs with light");
  }

  @Test
  void equalIndicesScatterNothing() {
    Trials.of(300, random -> {
      final BTDF nothing = new TransmissiveCookTorrance(WHITE, 1.25f, 1.25f, new Blinn(20));
      final double[] wi = Directions.random(random), wo = Directions.above(N, random);
      assertEquals(0, Directions.f(nothing, wi, wo, N, true)[0], 1e-15);
      assertEquals(0, Directions.f(nothing, Directions.minus(wo), wo, N, true)[0], "straight through");
    });
  }

  @Test
  void nothingIsSeenAlongTheSurface() {
    final double[] along = {1, 0, 0};
    for (final boolean outside : new boolean[] {true, false}) {
      assertArrayEquals(new double[3], Directions.f(rough(new Blinn(90)), along, N, N, outside));
      assertArrayEquals(new double[3], Directions.f(rough(new Blinn(90)), N, along, N, outside));
      assertArrayEquals(new double[3], Directions.f(rough(new Blinn(90)), Directions.minus(N), along, N, outside));
    }
  }

  @Test
  void polishedGlassIsIdeal() {
    for (final NormalDistributionFunction ndf : new NormalDistributionFunction[] {null, new GGX(0), new Blinn(0.09f)}) {
      assertFalse(rough(ndf).scatters());
      assertFalse(rough(ndf).transmits());
      assertEquals(0, Directions.f(rough(ndf), N, N, N, true)[0]);
      assertEquals(0, Directions.f(rough(ndf), Directions.minus(N), N, N, true)[0]);
    }
    assertEquals("TransmissiveCookTorrance(ReflectanceRGB(1.0, 1.0, 1.0), 1.5, 1.0, GGX(0.0))",
        rough(new GGX(0)).toString());
    assertEquals("IdealDielectric(null, 1.5, 1.25)", new IdealDielectric(null, 1.5f, 1.25f).toString());
    assertTrue(rough(new GGX(0.1f)).scatters() && rough(new GGX(0.1f)).transmits());
    final BTDF ideal = new IdealDielectric(WHITE, 1.5f, 1);
    assertFalse(ideal.scatters() || ideal.transmits());
    assertArrayEquals(new double[3], Directions.f(ideal, N, N, N, true));
  }

  /** Rough or not, other objects are seen along the ideal rays. */
  @Test
  void roughGlassHasTheIdealRaysOfSmoothGlass() {
    final SpecularRays smooth = new SpecularRays(), rough = new SpecularRays();
    for (final boolean outside : new boolean[] {true, false}) {
      assertTrue(new IdealDielectric(WHITE, 1.5f, 1).specular(0.8, outside, smooth));
      assertTrue(rough(new GGX(30)).specular(0.8, outside, rough));
      assertEquals(smooth.reflectedR(), rough.reflectedR());
      assertEquals(smooth.refractedR(), rough.refractedR());
      assertEquals(smooth.ratio(), rough.ratio());
      assertEquals(smooth.refractedCosine(), rough.refractedCosine());
    }
  }

  @Test
  void theOpenInterfaceKnowsBothSides() {
    final Vector3D n = new Vector3D(0, 0, 1), wo = Directions.vector(Directions.polar(0.4, 0));
    final RadianceRGB E = new RadianceRGB(1, 2, 4);
    for (final double[] wi : new double[][] {Directions.polar(0.3, Math.PI), Directions.polar(2.9, Math.PI)}) {
      for (final boolean outside : new boolean[] {true, false}) {
        final RadianceRGB L = rough(new GGX(20)).scatter(E, Directions.vector(wi), wo, n, outside);
        final double f = Directions.f(rough(new GGX(20)), wi, Directions.polar(0.4, 0), N, outside)[0];
        assertArrayEquals(new double[] {f, 2 * f, 4 * f}, new double[] {L.getR(), L.getG(), L.getB()}, 1e-4 * f);
        assertTrue(f > 0);
      }
    }
    assertEquals(0, rough(new GGX(20)).scatter(E, n, new Vector3D(0, 0, -1), n, true).getR(), "a viewer below");
    assertEquals(0, rough(new GGX(20)).scatter(E, new Vector3D(1, 0, 0), wo, n, true).getR(), "light along the surface");
  }

  @Test
  void glassWithoutAFactorIsBlack() {
    for (final ReflectanceRGB none : new ReflectanceRGB[] {null, new ReflectanceRGB(0, 0, 0)}) {
      final BTDF black = new TransmissiveCookTorrance(none, 1.5f, 1, new GGX(20));
      assertFalse(black.scatters() || black.transmits());
      assertFalse(black.specular(1, true, new SpecularRays()));
      assertFalse(new IdealDielectric(none, 1.5f, 1).specular(0.2, true, new SpecularRays()));
      assertEquals(java.awt.Color.BLACK, black.getColor());
    }
    final ReflectanceRGB tint = new ReflectanceRGB(0, 0, 0.5f);
    assertTrue(new TransmissiveCookTorrance(tint, 1.5f, 1, new GGX(20)).scatters());
    assertTrue(new IdealDielectric(tint, 1.5f, 1).specular(1, true, new SpecularRays()));
  }
}
