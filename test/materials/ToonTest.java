package materials;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;

import org.junit.jupiter.api.Test;

import primitives.Vector3D;
import radiometry.RadianceRGB;
import radiometry.ReflectanceRGB;

/** A user-written material obeys the laws that it does not opt out of, and is named in the message if it fails. */
class ToonTest implements BRDFContract {

  private static final double[] N = {0, 0, 1};

  @Override
  public BRDF brdf() {
    return new Toon(new ReflectanceRGB(1, 0.75f, 0.5f));
  }

  /** Its brightness depends on the light alone, in steps. */
  @Override
  public boolean isReciprocal() {
    return false;
  }

  /** It reflects 4/3 of its colour, as it rounds up. */
  @Override
  public boolean conservesEnergy() {
    return false;
  }

  @Test
  void theLawsItDeclinesAreBroken() {
    assertEquals(4 / 3.0, Albedo.ofSide(brdf(), 0.5, true, 1, 300)[0], 1e-2);
    final double[] high = Directions.polar(0.1, 0), low = Directions.polar(1.4, 0);
    assertTrue(Directions.f(brdf(), low, high, N, true)[0] > 1.5 * Directions.f(brdf(), high, low, N, true)[0]);
  }

  @Test
  void whatItDoesNotSayHasADefault() {
    assertNull(brdf().mirror(0.5));
    assertFalse(brdf().specular(0.5, true, new SpecularRays()));
    assertTrue(brdf().scatters());
    assertFalse(brdf().transmits());
    assertEquals(new Color(204, 204, 204), brdf().getColor());
  }

  @Test
  void itReflectsTheLightOnTheSurface() {
    final SurfaceInteraction interaction = new SurfaceInteraction();
    interaction.setView(0, 0, 1, 0, 0, 1, true);
    interaction.setIncident(0.6, 0, 0.8);
    interaction.setIrradiance(3, 2, 1);
    brdf().scatter(interaction);
    final double f = 1 / (0.8 * Math.PI);
    assertArrayEquals(new double[] {3 * f, 1.5 * f, 0.5 * f},
        new double[] {interaction.radianceR(), interaction.radianceG(), interaction.radianceB()}, 1e-6);
  }

  /** Directions so grazing that n·wi is 0 in floats are left out, so that n·wi is always positive. */
  @Test
  void lightAlongTheSurfaceIsLeftOut() {
    final double[] n = Directions.unit(0.3, 0.5, 0.7), flat = Directions.unit(0.5, -0.3, 0), above = {0, 0, 1};
    final double[] wi = Directions.unit(flat[0] + 1e-12 * n[0], flat[1] + 1e-12 * n[1], flat[2] + 1e-12 * n[2]);
    final double[] f = Directions.f(brdf(), wi, above, n, true);
    assertTrue(f[0] == 0 || f[0] > 1, () -> "f = " + f[0]);
    for (int i = -50; i < 50; i++) {
      final double[] about = Directions.unit(wi[0] + 1e-8 * i, wi[1] + 3e-9 * i * i, wi[2]);
      assertTrue(Directions.f(brdf(), about, above, n, true)[0] >= 0);
      assertTrue(Directions.f(brdf(), above, about, n, true)[0] >= 0);
    }
  }

  /** n·wi and n·wo are positive, never 0: the toon would divide by it. */
  @Test
  void lightOrViewerInTheSurfaceIsLeftOut() {
    final double[] along = {1, 0, 0};
    assertArrayEquals(new double[3], Directions.f(brdf(), along, N, N, true));
    assertArrayEquals(new double[3], Directions.f(brdf(), N, along, N, true));
  }

  @Test
  void nullIsNamed() {
    final BRDF nothing = new BRDF() {
      @Override
      public RadianceRGB reflect(final RadianceRGB E, final Vector3D wi, final Vector3D wo, final Vector3D n) {
        return null;
      }
    };
    assertEquals(nothing.getClass().getName() + ".reflect returned null",
        assertThrows(IllegalStateException.class, () -> Directions.f(nothing, N, N, N, true)).getMessage());
  }

  @Test
  void aMirrorOfOnesOwnIsFollowed() {
    final BRDF mirror = new Toon(new ReflectanceRGB(1, 1, 1)) {
      @Override
      public ReflectanceRGB mirror(final double cosine) {
        return new ReflectanceRGB((float) cosine, 0.25f, 1);
      }
    };
    final SpecularRays rays = new SpecularRays();
    rays.refract(7, 8, 9, 2, 0.5);
    assertTrue(mirror.specular(0.5, true, rays));
    assertArrayEquals(new double[] {0.5, 0.25, 1, 0, 0, 0},
        new double[] {rays.reflectedR(), rays.reflectedG(), rays.reflectedB(), rays.refractedR(), rays.refractedG(),
          rays.refractedB()});
  }
}
