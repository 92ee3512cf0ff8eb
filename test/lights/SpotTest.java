package lights;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import primitives.Point3D;
import radiometry.RadianceRGB;
import radiometry.SpectrumRGB;
import trials.Trials;

class SpotTest implements LightContract {

  private static final SpectrumRGB WHITE = new SpectrumRGB(0.25f, 0.5f, 0.25f);
  private static final Point3D O = new Point3D();
  private static final Point3D DOWN = new Point3D(0, -2, 0);

  @Override
  public Light light() {
    return new Spot(new Point3D(1, 2, 3), new Point3D(0.5f, -1, 4), 35, WHITE, 100);
  }

  private static Light cone(final float aperture) {
    return new Spot(O, DOWN, aperture, WHITE, 100);
  }

  private static boolean lights(final Light light, final double x, final double y, final double z) {
    return light.illuminate(x, y, z, new Incidence());
  }

  @Test
  void irradianceIsThePowerOverTheCap() {
    final double solidAngle = 2 * Math.PI * (1 - Math.sqrt(0.5));
    assertEquals(150 / solidAngle / 25, cone(45).getIrradianceAt(new Point3D(-3, -4, 0)).getG(), 1e-12);
    assertEquals(75 / solidAngle / 9, cone(45).getIrradianceAt(new Point3D(0, -3, 0)).getB(), 1e-12);
    assertEquals(150 / (2 * Math.PI), cone(90).getIrradianceAt(new Point3D(0, 0, 1)).getG(), 1e-12);
    assertEquals(O, cone(45).getPosition(new Point3D(1, -2, 2)));
    assertEquals("Spot((0.0, 0.0, 0.0), lookAt=(0.0, -2.0, 0.0), aperture=45.0, SpectrumRGB(0.25, 0.5, 0.25), power=100.0)",
        cone(45).toString());
  }

  /** For such a cone 2π(1 − cos A) loses all digits; A² π does not. */
  @Test
  void narrowConesHaveTheirSolidAngle() {
    for (final float aperture : new float[] {1e-3f, 1e-6f, 1e-12f}) {
      final double a = Math.toRadians(aperture), E = 150 / (Math.PI * a * a);
      assertEquals(E, cone(aperture).getIrradianceAt(new Point3D(0, -1, 0)).getG(), 1e-9 * E);
      assertTrue(lights(cone(aperture), 0.5 * a, -1, 0));
      assertFalse(lights(cone(aperture), 1.5 * a, -1, 0));
    }
  }

  @Test
  void theEdgeIsLitAndSharp() {
    assertTrue(lights(cone(45), 1, -1, 0));
    assertTrue(lights(cone(45), 0, -1, -1));
    assertFalse(lights(cone(45), Math.nextUp(1f), -1, 0));
    assertSame(RadianceRGB.NORADIANCE, cone(45).getIrradianceAt(new Point3D(0, -1, Math.nextUp(1f))));
    assertTrue(lights(cone(90), 5, 0, -3));
    assertFalse(lights(cone(90), 5, 1e-12, -3));
    assertFalse(lights(cone(90), 0, 1, 0), "behind");
    assertFalse(lights(cone(45), 0, 1, 0), "behind");
    assertFalse(lights(cone(45), 1, 1, 0), "the mirrored cone");
    assertFalse(lights(cone(45), 0, 0, 0), "the light itself");
  }

  /** In any direction and at any distance, up to the rounding of doubles. */
  @Test
  void theEdgeIsLitWhateverTheAxis() {
    Trials.of(500, random -> {
      final Point3D at = new Point3D((float) random.nextGaussian(), (float) random.nextGaussian(), 1);
      final double length = Math.sqrt((double) at.x * at.x + (double) at.y * at.y + 1), x = at.x / length, y = at.y / length;
      final double across = Math.sqrt(x * x + y * y), far = Math.exp(8 * random.nextGaussian());
      final float aperture = 90 * (1 - random.nextFloat());
      for (final double relative : new double[] {-1e-9, 0, 1e-9}) {
        final double angle = Math.toRadians(aperture) * (1 + relative), a = far * Math.cos(angle), b = far * Math.sin(angle);
        assertEquals(relative <= 0, lights(new Spot(O, at, aperture, WHITE, 1), a * x + b * y / across,
            a * y - b * x / across, a / length), () -> aperture + " degrees at " + far);
      }
    });
  }

  /** The angle at the light decides, whatever the axis and the distance. */
  @Test
  void pointsAreLitWithinTheAngle() {
    final int[] counts = new int[2];
    Trials.of(2000, random -> {
      final Point3D S = new Point3D((float) random.nextGaussian(), (float) random.nextGaussian(), 5);
      final Point3D at = new Point3D((float) random.nextGaussian(), 2, (float) random.nextGaussian());
      final float aperture = 90 * (1 - random.nextFloat());
      final Point3D P = new Point3D((float) random.nextGaussian(), (float) random.nextGaussian(), 4 * random.nextFloat());
      final double ux = at.x - S.x, uy = at.y - S.y, uz = at.z - S.z, vx = P.x - S.x, vy = P.y - S.y, vz = P.z - S.z;
      final double angle = Math.toDegrees(Math.acos((ux * vx + uy * vy + uz * vz)
          / Math.hypot(Math.hypot(ux, uy), uz) / Math.hypot(Math.hypot(vx, vy), vz)));
      if (Math.abs(angle - aperture) > 1e-6) {
        assertEquals(angle < aperture, lights(new Spot(S, at, aperture, WHITE, 1), P.x, P.y, P.z));
        counts[angle < aperture ? 1 : 0]++;
      }
    });
    assertTrue(counts[0] > 200 && counts[1] > 200, () -> counts[0] + " dark, " + counts[1] + " lit");
  }

  @Test
  void twiceAsFarIsAQuarterAsBright() {
    final Light light = cone(30);
    assertEquals(light.getIrradianceAt(new Point3D(0.1f, -1, 0.3f)).getR() / 4,
        light.getIrradianceAt(new Point3D(0.2f, -2, 0.6f)).getR());
  }

  @Test
  void allOfThePowerIsInTheCone() {
    for (final float aperture : new float[] {12, 45, 70, 90}) {
      final double[] flux = Flux.through(new Spot(O, new Point3D(0.4f, -2, 0.7f), aperture, WHITE, 100), 3);
      assertEquals(75, flux[0], 0.2);
      assertEquals(150, flux[1], 0.4);
    }
  }
}
