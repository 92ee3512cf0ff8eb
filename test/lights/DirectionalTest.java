package lights;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import primitives.Point3D;
import primitives.Vector3D;
import radiometry.RadianceRGB;
import radiometry.SpectrumRGB;
import trials.Trials;

class DirectionalTest implements LightContract {

  private static final SpectrumRGB SPECTRUM = new SpectrumRGB(0.25f, 0.5f, 0.25f);
  private static final Light BEAM = new Directional(new Point3D(1, 5, 2), new Point3D(1, 4, 2), 2, SPECTRUM, 100);

  @Override
  public Light light() {
    return new Directional(new Point3D(1, 2, 3), new Point3D(0.5f, -1, 4), 3, SPECTRUM, 100);
  }

  private static boolean lights(final double x, final double y, final double z) {
    return BEAM.illuminate(x, y, z, new Incidence());
  }

  @Test
  void irradianceIsThePowerOverTheDiscAtAnyDistance() {
    for (final float y : new float[] {4.999f, 0, -1e6f}) {
      final RadianceRGB E = BEAM.getIrradianceAt(new Point3D(2, y, 2));
      assertEquals(150 / (4 * Math.PI), E.getG(), 1e-12);
      assertEquals(75 / (4 * Math.PI), E.getR(), 1e-12);
    }
  }

  @Test
  void theLightComesFromTheDiscStraightAbove() {
    final Point3D P = new Point3D(2, 1, 1.5f);
    assertEquals(new Point3D(2, 5, 1.5f), BEAM.getPosition(P));
    assertEquals(new Point3D(1, 5, 2), BEAM.getPosition());
    assertEquals(new Vector3D(0, 1, 0), BEAM.getIncidenceDirection(P));
    final Incidence incidence = new Incidence();
    assertTrue(BEAM.illuminate(P.x, P.y, P.z, incidence));
    assertEquals(4, incidence.distance());
    assertEquals("Directional((1.0, 5.0, 2.0), lookAt=(1.0, 4.0, 2.0), radius=2.0, SpectrumRGB(0.25, 0.5, 0.25), "
        + "power=100.0)", BEAM.toString());
  }

  @Test
  void theEdgeIsLitAndSharp() {
    assertTrue(lights(3, 0, 2));
    assertTrue(lights(1, 4, 0));
    assertFalse(lights(Math.nextUp(3f), 0, 2));
    assertSame(RadianceRGB.NORADIANCE, BEAM.getIrradianceAt(new Point3D(1, 0, Math.nextUp(4f))));
    assertTrue(lights(1, 4.999999, 2));
    assertFalse(lights(1, 5, 2), "on the disc");
    assertFalse(lights(1, 6, 2), "behind the disc");
    assertSame(RadianceRGB.NORADIANCE, BEAM.getIrradianceAt(new Point3D(1, 5, 2)));
  }

  /** In any direction and at any distance, up to the rounding of doubles. */
  @Test
  void theEdgeIsLitWhateverTheAxis() {
    Trials.of(500, random -> {
      final Point3D at = new Point3D((float) random.nextGaussian(), (float) random.nextGaussian(), 1);
      final double length = Math.sqrt((double) at.x * at.x + (double) at.y * at.y + 1), x = at.x / length, y = at.y / length;
      final double across = Math.sqrt(x * x + y * y), a = Math.exp(4 * random.nextGaussian());
      final float r = (float) Math.exp(4 * random.nextGaussian());
      for (final double relative : new double[] {-1e-9, 0, 1e-9}) {
        final double b = r + relative * (r + a);
        assertEquals(relative <= 0, new Directional(new Point3D(), at, r, SPECTRUM, 1).illuminate(a * x + b * y / across,
            a * y - b * x / across, a / length, new Incidence()), () -> "radius " + r + " at " + a);
      }
    });
  }

  /** For points behind the disc too, light would come from the point of the disc in front of them. */
  @Test
  void theDiscIsPlane() {
    assertEquals(new Point3D(2, 5, 2), BEAM.getPosition(new Point3D(2, 9, 2)));
    assertEquals(new Vector3D(0, -1, 0), BEAM.getIncidenceDirection(new Point3D(2, 9, 2)));
    assertEquals(new Vector3D(), BEAM.getIncidenceDirection(new Point3D(2, 5, 2)), "on the disc there is no direction");
  }

  /** Distance from the axis and side of the disc decide, whatever the axis. */
  @Test
  void pointsAreLitWithinTheBeam() {
    final int[] counts = new int[2];
    Trials.of(2000, random -> {
      final double ux = random.nextGaussian(), uy = random.nextGaussian(), uz = random.nextGaussian();
      final double length = Math.sqrt(ux * ux + uy * uy + uz * uz);
      final Point3D P = new Point3D((float) random.nextGaussian(), (float) random.nextGaussian(),
          (float) random.nextGaussian());
      final Point3D lookAt = new Point3D((float) ux, (float) uy, (float) uz);
      final float r = 2 * (1 - random.nextFloat());
      final double a = (P.x * ux + P.y * uy + P.z * uz) / length;
      final double beside = Math.sqrt(P.x * P.x + P.y * P.y + P.z * P.z - a * a);
      if (Math.abs(a) > 1e-5 && Math.abs(beside - r) > 1e-5) {
        final boolean lit = a > 0 && beside < r;
        assertEquals(lit, new Directional(new Point3D(), lookAt, r, SPECTRUM, 1).illuminate(P.x, P.y, P.z, new Incidence()));
        counts[lit ? 1 : 0]++;
      }
    });
    assertTrue(counts[0] > 200 && counts[1] > 200, () -> counts[0] + " dark, " + counts[1] + " lit");
  }

  @Test
  void allOfThePowerIsInTheBeam() {
    for (final double r : new double[] {3.1, 10}) {
      final double[] flux = Flux.through(light(), r);
      assertEquals(75, flux[0], 0.5);
      assertEquals(150, flux[1], 1);
    }
  }
}
