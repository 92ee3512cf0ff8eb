package lights;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import primitives.Point3D;
import primitives.Vector3D;
import radiometry.RadianceRGB;
import radiometry.SpectrumRGB;

/** A user-written light obeys the laws, and is named in the message if it fails. */
class CandleTest implements LightContract {

  private static final SpectrumRGB WARM = new SpectrumRGB(0.5f, 0.375f, 0.125f);
  private static final Point3D S = new Point3D(1, 2, 3);

  @Override
  public Light light() {
    return new Candle(S, WARM, 100);
  }

  @Test
  void theCandleGivesItsOwnLight() {
    assertEquals(150 / (4 * Math.PI * 9), light().getIrradianceAt(new Point3D(1, 4, 3)).getR(), 1e-6);
    assertFalse(light().illuminate(S.x, S.y, S.z, new Incidence()), "there is no direction in the flame itself");
    assertEquals(new Vector3D(), light().getIncidenceDirection(S));
  }

  /** An extended light overrides the point from which a point is lit. */
  @Test
  void aLightHasAsManyPointsAsItLikes() {
    final Light tube = new Candle(S, WARM, 1) {
      @Override
      public Point3D getPosition(final Point3D P) {
        return new Point3D(P.x, 2, 3);
      }
    };
    final Incidence incidence = new Incidence();
    assertTrue(tube.illuminate(7, 6, 0, incidence));
    assertEquals(5, incidence.distance(), 1e-12);
    assertEquals(-0.8, incidence.directionY(), 1e-12);
    assertEquals(0.6, incidence.directionZ(), 1e-12);
    assertEquals(new Vector3D(0, -0.8f, 0.6f), tube.getIncidenceDirection(new Point3D(7, 6, 0)));
  }

  @Test
  void noLightIsDark() {
    final Light black = new Candle(S, WARM, 1) {
      @Override
      public RadianceRGB getIrradianceAt(final Point3D P) {
        return RadianceRGB.NORADIANCE;
      }
    };
    assertFalse(black.illuminate(0, 0, 0, new Incidence()));
    for (final RadianceRGB one : new RadianceRGB[] {new RadianceRGB(1, 0, 0), new RadianceRGB(0, 1, 0),
      new RadianceRGB(0, 0, 1)}) {
      final Light coloured = new Candle(S, WARM, 1) {
        @Override
        public RadianceRGB getIrradianceAt(final Point3D P) {
          return one;
        }
      };
      assertTrue(coloured.illuminate(0, 0, 0, new Incidence()), one::toString);
    }
  }

  @Test
  void nullOfALightIsNamed() {
    final Light nothing = new Candle(S, WARM, 1) {
      @Override
      public RadianceRGB getIrradianceAt(final Point3D P) {
        return null;
      }
    };
    assertEquals(nothing.getClass().getName() + ".getIrradianceAt returned null",
        assertThrows(IllegalStateException.class, () -> nothing.illuminate(0, 0, 0, new Incidence())).getMessage());
    final Light nowhere = new Candle(S, WARM, 1) {
      @Override
      public Point3D getPosition(final Point3D P) {
        return null;
      }
    };
    final String message = nowhere.getClass().getName() + ".getPosition returned null";
    assertEquals(message,
        assertThrows(IllegalStateException.class, () -> nowhere.illuminate(0, 0, 0, new Incidence())).getMessage());
    assertEquals(message,
        assertThrows(IllegalStateException.class, () -> nowhere.getIncidenceDirection(new Point3D())).getMessage());
  }

  @Test
  void aPositionThatIsNotFiniteIsNamed() {
    for (final Point3D wrong : new Point3D[] {new Point3D(Float.NaN, 0, 0), new Point3D(0, Float.POSITIVE_INFINITY, 0),
      new Point3D(0, 0, Float.NEGATIVE_INFINITY)}) {
      final Light lost = new Candle(S, WARM, 1) {
        @Override
        public Point3D getPosition(final Point3D P) {
          return wrong;
        }
      };
      assertEquals(lost.getClass().getName() + ".getPosition returned " + wrong + ", which is not finite",
          assertThrows(IllegalStateException.class, () -> lost.illuminate(0, 0, 0, new Incidence())).getMessage());
    }
  }

  @Test
  void aGroupKeepsItsLightsInOrder() {
    final Light a = light(), b = light(), c = light();
    final LightGroup group = new LightGroup(a, b);
    final java.util.List<Light> before = group.getLights();
    group.addLight(c);
    assertEquals(java.util.List.of(a, b), before);
    assertEquals(3, group.getLights().size());
    assertSame(c, group.getLights().get(2));
    assertThrows(UnsupportedOperationException.class, () -> group.getLights().clear());
    assertEquals(0, new LightGroup().getLights().size());
    assertTrue(group.toString().startsWith("LightGroup[lights.Candle"), group::toString);
  }
}
