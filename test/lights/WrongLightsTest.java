package lights;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;

import primitives.Point3D;
import radiometry.SpectrumRGB;

/** Invalid arguments of lights are refused with name and value. */
class WrongLightsTest {

  private static final SpectrumRGB WHITE = new SpectrumRGB(0.25f, 0.5f, 0.25f);
  private static final Point3D S = new Point3D(1, 2, 3);
  private static final Point3D AT = new Point3D(1, 2, 4);
  private static final float[] NO_SIZES = {0, -0f, -1.5f, -Float.MIN_VALUE, Float.NaN, Float.POSITIVE_INFINITY,
    Float.NEGATIVE_INFINITY};
  private static final Point3D[] NO_POINTS = {null, new Point3D(Float.NaN, 0, 0), new Point3D(0, Float.POSITIVE_INFINITY, 0),
    new Point3D(0, 0, Float.NEGATIVE_INFINITY)};

  private static void assertRefused(final String name, final Object value, final Executable call) {
    final String message = assertThrows(IllegalArgumentException.class, call).getMessage();
    assertTrue(message.startsWith(name + " must"), message);
    assertTrue(message.contains(String.valueOf(value)), message);
  }

  @Test
  void positions() {
    for (final Point3D wrong : NO_POINTS) {
      assertRefused("position", wrong, () -> new Omnidirectional(wrong, WHITE, 1));
      assertRefused("position", wrong, () -> new Spot(wrong, AT, 30, WHITE, 1));
      assertRefused("position", wrong, () -> new Directional(wrong, AT, 1, WHITE, 1));
      assertRefused("position", wrong, () -> new Candle(wrong, WHITE, 1));
      assertRefused("lookAt", wrong, () -> new Spot(S, wrong, 30, WHITE, 1));
      assertRefused("lookAt", wrong, () -> new Directional(S, wrong, 1, WHITE, 1));
    }
    assertRefused("lookAt", S, () -> new Spot(S, new Point3D(S), 30, WHITE, 1));
    assertRefused("lookAt", S, () -> new Directional(S, new Point3D(S), 1, WHITE, 1));
    assertRefused("lookAt", "position", () -> new Spot(S, new Point3D(S), 30, WHITE, 1));
    assertRefused("lookAt", new Point3D(), () -> new Spot(new Point3D(0, -0f, 0), new Point3D(), 30, WHITE, 1));
  }

  @Test
  void powersAndRadii() {
    for (final float wrong : NO_SIZES) {
      assertRefused("power", wrong, () -> new Omnidirectional(S, WHITE, wrong));
      assertRefused("power", wrong, () -> new Spot(S, AT, 30, WHITE, wrong));
      assertRefused("power", wrong, () -> new Directional(S, AT, 1, WHITE, wrong));
      assertRefused("power", wrong, () -> new Candle(S, WHITE, wrong));
      assertRefused("radius", wrong, () -> new Directional(S, AT, wrong, WHITE, 1));
    }
    assertRefused("power", 0f, () -> new Omnidirectional(S, WHITE, 0));
  }

  @Test
  void apertures() {
    for (final float wrong : NO_SIZES) {
      assertRefused("aperture", wrong, () -> new Spot(S, AT, wrong, WHITE, 1));
    }
    assertRefused("aperture", Math.nextUp(90f), () -> new Spot(S, AT, Math.nextUp(90f), WHITE, 1));
    assertDoesNotThrow(() -> new Spot(S, AT, 90, WHITE, 1));
    assertDoesNotThrow(() -> new Spot(S, AT, Float.MIN_VALUE, WHITE, 1));
  }

  @Test
  void nulls() {
    assertRefused("spectrum", null, () -> new Omnidirectional(S, null, 1));
    assertRefused("spectrum", null, () -> new Spot(S, AT, 30, null, 1));
    assertRefused("spectrum", null, () -> new Directional(S, AT, 1, null, 1));
    assertRefused("lights", null, () -> new LightGroup((Light[]) null));
    assertRefused("light", null, () -> new LightGroup((Light) null));
    assertRefused("light", null, () -> new LightGroup().addLight(null));
    for (final Light light : new Light[] {new Omnidirectional(S, WHITE, 1), new Spot(S, AT, 30, WHITE, 1),
      new Directional(S, AT, 1, WHITE, 1)}) {
      assertRefused("P", null, () -> light.getIrradianceAt(null));
      assertRefused("P", null, () -> light.getPosition(null));
      assertRefused("P", null, () -> light.getIncidenceDirection(null));
    }
  }

  @Test
  void laterChangesOfTheArgumentsAreWithoutEffect() {
    final Point3D position = new Point3D(S), lookAt = new Point3D(AT);
    final Light spot = new Spot(position, lookAt, 30, WHITE, 1), beam = new Directional(position, lookAt, 2, WHITE, 1);
    final String before = spot + " " + beam;
    final Point3D P = new Point3D(1, 2, 9);
    final double E = spot.getIrradianceAt(P).getR(), F = beam.getIrradianceAt(P).getR();
    position.set(-7, -7, 50);
    lookAt.set(-8, 1, 60);
    assertEquals(before, spot + " " + beam);
    assertEquals(E, spot.getIrradianceAt(P).getR());
    assertEquals(F, beam.getIrradianceAt(P).getR());
    assertTrue(E > 0 && F > 0);
  }
}
