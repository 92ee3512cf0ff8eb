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

class OmnidirectionalTest implements LightContract {

  private static final SpectrumRGB SPECTRUM = new SpectrumRGB(0.5f, 0.5f, 0);
  private static final Point3D S = new Point3D(1, -2, 3);
  private static final Light LIGHT = new Omnidirectional(S, SPECTRUM, 100);

  @Override
  public Light light() {
    return LIGHT;
  }

  @Test
  void irradianceIsThePowerOverTheSphere() {
    final RadianceRGB E = LIGHT.getIrradianceAt(new Point3D(1, 1, 7));
    assertEquals(150 / (100 * Math.PI), E.getR(), 1e-12);
    assertEquals(E.getR(), E.getG());
    assertEquals(0, E.getB(), "a share of 0 is a black channel");
    assertEquals(new Vector3D(0, -0.6f, -0.8f), LIGHT.getIncidenceDirection(new Point3D(1, 1, 7)));
    assertEquals(S, LIGHT.getPosition(new Point3D(1, 1, 7)));
    assertEquals(S, LIGHT.getPosition());
    assertEquals(150, LIGHT.getPower().getR());
    assertEquals(0, LIGHT.getPower().getB());
    assertEquals("Omnidirectional((1.0, -2.0, 3.0), SpectrumRGB(0.5, 0.5, 0.0), power=100.0)", LIGHT.toString());
  }

  @Test
  void twiceAsFarIsAQuarterAsBright() {
    Trials.of(200, random -> {
      final float x = (float) random.nextGaussian(), y = (float) random.nextGaussian(), z = (float) random.nextGaussian();
      final Light atOrigin = new Omnidirectional(new Point3D(), SPECTRUM, (float) Math.exp(9 * random.nextGaussian()));
      assertEquals(atOrigin.getIrradianceAt(new Point3D(x, y, z)).getG() / 4,
          atOrigin.getIrradianceAt(new Point3D(2 * x, 2 * y, 2 * z)).getG(), 0);
    });
  }

  @Test
  void allOfThePowerLeavesTheLight() {
    for (final double r : new double[] {0.25, 1, 77}) {
      assertEquals(150, Flux.through(LIGHT, r)[0], 1e-3);
      assertEquals(0, Flux.through(LIGHT, r)[2], 0);
    }
  }

  @Test
  void theLightItselfIsNotLit() {
    assertSame(RadianceRGB.NORADIANCE, LIGHT.getIrradianceAt(new Point3D(S)));
    assertFalse(LIGHT.illuminate(S.x, S.y, S.z, new Incidence()));
    assertEquals(new Vector3D(), LIGHT.getIncidenceDirection(S));
  }

  @Test
  void irradianceStaysFiniteNearTheLightAndFarAway() {
    final Light atOrigin = new Omnidirectional(new Point3D(), SPECTRUM, Float.MAX_VALUE);
    final double near = atOrigin.getIrradianceAt(new Point3D(Float.MIN_VALUE, 0, 0)).getR();
    assertEquals(1.5 * Float.MAX_VALUE / (4 * Math.PI * Float.MIN_VALUE * (double) Float.MIN_VALUE), near, 1e-9 * near);
    final Incidence incidence = new Incidence();
    assertTrue(atOrigin.illuminate(1e-150, 0, 0, incidence));
    assertTrue(incidence.irradianceR() * 1e100 < Double.POSITIVE_INFINITY);
    assertTrue(atOrigin.illuminate(0, 3e38, -3e38, incidence));
    assertEquals(Math.sqrt(18) * 1e38, incidence.distance(), 1e24);
    assertEquals(-Math.sqrt(0.5), incidence.directionY(), 1e-15);
    assertFalse(atOrigin.illuminate(Double.NaN, 0, 0, incidence));
    assertFalse(atOrigin.illuminate(0, 0, Double.NEGATIVE_INFINITY, incidence));
  }

  @Test
  void laterChangesOfPointsDoNotReachTheLight() {
    final Point3D position = new Point3D(S);
    final Light light = new Omnidirectional(position, SPECTRUM, 100);
    position.set(7, 7, 7);
    light.getPosition().set(8, 8, 8);
    light.getPosition(new Point3D()).set(9, 9, 9);
    assertEquals(S, light.getPosition());
    assertEquals(LIGHT.getIrradianceAt(new Point3D()).getR(), light.getIrradianceAt(new Point3D()).getR());
  }
}
