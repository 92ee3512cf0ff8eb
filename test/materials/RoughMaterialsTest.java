package materials;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.function.Function;

import org.junit.jupiter.api.Test;

import radiometry.ReflectanceRGB;

/** Laws of the three BRDFs with a lobe, for each distribution: energy, and the ideal limit of narrow lobes. */
class RoughMaterialsTest {

  private static final List<Function<Float, NormalDistributionFunction>> NDFS = List.of(Blinn::new, Horn::new, Torrance::new,
      GGX::new, Beckmann::new);
  private static final ReflectanceRGB KD = new ReflectanceRGB(0, 0.5f, 0.9f), KS = new ReflectanceRGB(1, 0.5f, 0.1f);

  private static List<BRDF> materials(final NormalDistributionFunction ndf) {
    return List.of(new PhongLafortune(KD, KS, ndf), new ReflectiveCookTorrance(KD, KS, ndf),
        new AshikhminShirley(KD, KS, ndf));
  }

  @Test
  void noMoreIsReflectedThanArrives() {
    for (final Function<Float, NormalDistributionFunction> ndf : NDFS) {
      for (final float beta : new float[] {5, 20, 45, 70, 90}) {
        for (final BRDF material : materials(ndf.apply(beta))) {
          for (final double theta : new double[] {0, 45, 75, 89}) {
            final double[] albedo = Albedo.ofLobe(material, Math.toRadians(theta));
            assertTrue(albedo[0] <= 1.001 && albedo[1] <= 1.001 && albedo[2] <= 1.001,
                () -> material + " at " + theta + ": " + Arrays.toString(albedo));
          }
        }
      }
    }
  }

  /** The narrower the lobe, the more it reflects what a polished surface does: within 3 and 1 %, GGX 6 and 1.5 %. */
  @Test
  void narrowLobesTendToTheMirror() {
    final ReflectanceRGB black = new ReflectanceRGB(0, 0, 0), ks = new ReflectanceRGB(0.9f, 0.5f, 0.1f);
    for (final Function<Float, NormalDistributionFunction> ndf : NDFS) {
      for (final float beta : new float[] {2, 0.5f}) {
        final boolean tail = ndf.apply(beta) instanceof GGX;
        final double tolerance = beta == 2 ? tail ? 0.06 : 0.03 : tail ? 0.015 : 0.01;
        for (final Function<NormalDistributionFunction, BRDF> material : List.<Function<NormalDistributionFunction, BRDF>>of(
            d -> new PhongLafortune(black, ks, d), d -> new ReflectiveCookTorrance(black, ks, d))) {
          for (final double theta : new double[] {0, 20, 40}) {
            assertLimit(material.apply(ndf.apply(0f)), material.apply(ndf.apply(beta)), Math.toRadians(theta), tolerance);
          }
        }
      }
    }
  }

  private static void assertLimit(final BRDF polished, final BRDF rough, final double theta, final double tolerance) {
    final double[] albedo = Albedo.ofLobe(rough, theta);
    final ReflectanceRGB factor = polished.mirror(Math.cos(theta));
    assertEquals(factor.getR(), albedo[0], tolerance * factor.getR(), rough::toString);
    assertEquals(factor.getG(), albedo[1], tolerance * factor.getG(), rough::toString);
    assertEquals(factor.getB(), albedo[2], tolerance * factor.getB(), rough::toString);
  }

  /** The lobe of the coat of Ashikhmin and Shirley is the difference to the light from below. */
  @Test
  void theCoatTendsToTheMirrorToo() {
    final ReflectanceRGB faint = new ReflectanceRGB(1e-6f, 1e-6f, 1e-6f), ks = new ReflectanceRGB(0.9f, 0.5f, 0.1f);
    for (final Function<Float, NormalDistributionFunction> ndf : NDFS) {
      for (final double theta : new double[] {0, 20, 40}) {
        assertLimit(new AshikhminShirley(faint, ks, null), new AshikhminShirley(faint, ks, ndf.apply(0.5f)),
            Math.toRadians(theta), ndf.apply(1f) instanceof GGX ? 0.015 : 0.01);
      }
    }
  }

  @Test
  void polishedSurfacesHaveTheFresnelFactorOfTheirLobes() {
    final double cosine = 0.25, rise = Math.pow(0.75, 5);
    for (final Function<Float, NormalDistributionFunction> ndf : NDFS) {
      assertMirror(1, 0.5, 0.1, new PhongLafortune(KD, KS, ndf.apply(0f)), cosine);
      assertMirror(1, 0.5, 0.1, new ReflectiveCookTorrance(KD, KS, ndf.apply(0.09f)), cosine);
      assertMirror(1, 0.5 + 0.5 * rise, 0.1 + 0.9 * rise, new AshikhminShirley(KD, KS, ndf.apply(0f)), cosine);
    }
    final ReflectanceRGB kd = new ReflectanceRGB(0.25f, 0, 0.5f), ks = new ReflectanceRGB(0.25f, 0.5f, 0);
    assertMirror(0.25 + 0.5 * rise, 0.5 + 0.5 * rise, 0.5 * rise, new ReflectiveCookTorrance(kd, ks, null), cosine);
    assertMirror(0.75, 1, 0.5, new ReflectiveCookTorrance(kd, ks, null), 0);
    assertMirror(0.25, 0.5, 0, new ReflectiveCookTorrance(kd, ks, null), 1);
    assertMirror(0.25, 0.5, 0, new PhongLafortune(kd, ks, null), 0);
  }

  private static void assertMirror(final double r, final double g, final double b, final BRDF material,
      final double cosine) {
    final ReflectanceRGB factor = material.mirror(cosine);
    assertNotNull(factor, material::toString);
    assertArrayEquals(new double[] {r, g, b}, new double[] {factor.getR(), factor.getG(), factor.getB()}, 1e-7,
        material::toString);
    final SpecularRays rays = new SpecularRays();
    rays.refract(7, 8, 9, 2, 0.5);
    assertTrue(material.specular(cosine, false, rays));
    assertEquals("1.0 1.0", rays.ratio() + " " + rays.refractedCosine(), "nothing is bent");
    assertArrayEquals(new double[] {r, g, b, 0, 0, 0}, new double[] {rays.reflectedR(), rays.reflectedG(), rays.reflectedB(),
      rays.refractedR(), rays.refractedG(), rays.refractedB()}, 1e-7);
  }

  @Test
  void polishedSurfacesKeepTheirDiffusePartAndLoseTheLobe() {
    final double[] n = {0, 0, 1}, wo = Directions.polar(0.5, 0), mirrored = Directions.polar(0.5, Math.PI);
    final double[] lambert = Directions.f(new Lambertian(KD), mirrored, wo, n, true);
    assertArrayEquals(lambert, Directions.f(new PhongLafortune(KD, KS, null), mirrored, wo, n, true), 1e-15);
    final BRDF polished = new ReflectiveCookTorrance(KD, KS, new GGX(0.05f));
    assertArrayEquals(lambert, Directions.f(polished, mirrored, wo, n, true), 1e-15);
    assertTrue(Directions.f(new PhongLafortune(KD, KS, new GGX(0.1f)), mirrored, wo, n, true)[0] > 1e4);
    assertNull(new PhongLafortune(KD, KS, new GGX(0.1f)).mirror(1));
    assertTrue(new PhongLafortune(KD, KS, null).scatters());
    assertFalse(new PhongLafortune(null, KS, null).scatters(), "a mirror shows no light");
    assertTrue(new PhongLafortune(null, KS, new GGX(1)).scatters());
  }

  @Test
  void aBlackReflectanceLeavesItsPartOut() {
    final ReflectanceRGB black = new ReflectanceRGB(0, 0, 0);
    final double[] n = {0, 0, 1}, wo = Directions.polar(1.4, 0), mirrored = Directions.polar(1.4, Math.PI);
    for (final ReflectanceRGB none : new ReflectanceRGB[] {null, black}) {
      assertArrayEquals(Directions.f(new Lambertian(KD), mirrored, wo, n, true),
          Directions.f(new ReflectiveCookTorrance(KD, none, new Blinn(10)), mirrored, wo, n, true), 1e-15);
      assertNull(new ReflectiveCookTorrance(KD, none, null).mirror(0), "not even at grazing angles");
      assertNull(new PhongLafortune(KD, none, null).mirror(0.5));
      assertEquals(0.3, Albedo.ofLobe(new PhongLafortune(none, new ReflectanceRGB(0.3f, 0, 0), new Blinn(2)), 0.2)[0], 0.01);
    }
  }
}
