package view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;

class PerspectiveTest implements ProjectionContract {

  @Override
  public Optics random(final Random random) {
    final float fov = random.nextInt(4) == 0 ? 179.9f * random.nextFloat() + 0.01f : 20 + 70 * random.nextFloat();
    final float aspect = (float) Math.pow(10, 2 * random.nextDouble() - 1);
    final double h = 2 * Math.tan(fov * Math.PI / 360);
    return new Optics(new Perspective(fov, aspect), aspect * h, h, (x, y) -> new double[] {0, 0, 0, x, y, -1});
  }

  @Test
  void aRightAngleOpensAWindowOfHeightTwo() {
    final Perspective projection = new Perspective(90, 1.5f);
    assertEquals(2, projection.getHeight(), 1e-6);
    assertEquals(3, projection.getWidth(), 1e-6);
  }

  @Test
  void raysPassThroughTheMiddlesOfPixels() {
    final Camera camera = new Camera(new Point3D(0, 0, 5), new Point3D(), new Vector3D(0, 3, 0));
    camera.setProjection(new Perspective(90, 1));
    final Ray lowerLeft = camera.getRayGenerator(2, 2).getRay(0, 0), upperRight = camera.getRayGenerator(2, 2).getRay(1, 1);
    final float k = (float) Math.sqrt(1.5);
    assertEquals(new Point3D(0, 0, 5), lowerLeft.getStartingPoint());
    assertEquals(0, distance(new Point3D(-0.5f, -0.5f, 4), lowerLeft.pointAtParameter(k)), 1e-6);
    assertEquals(0, distance(new Point3D(0.5f, 0.5f, 4), upperRight.pointAtParameter(k)), 1e-6);
  }

  private static double distance(final Point3D P, final Point3D Q) {
    return P.distance(Q);
  }

  @ParameterizedTest
  @ValueSource(floats = {0, -1, 180, 200, Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY})
  void rejectsAnOpeningThatIsNotBetween0And180Degrees(final float fov) {
    final Exception wrong = assertThrows(IllegalArgumentException.class, () -> new Perspective(fov, 1));
    assertEquals(true, wrong.getMessage().contains("fov"), wrong.getMessage());
  }

  @ParameterizedTest
  @ValueSource(floats = {0, -1, Float.NaN, Float.POSITIVE_INFINITY})
  void rejectsAnAspectThatIsNotPositive(final float aspect) {
    final Exception wrong = assertThrows(IllegalArgumentException.class, () -> new Perspective(60, aspect));
    assertEquals(true, wrong.getMessage().contains("aspect"), wrong.getMessage());
  }

  @Test
  void rejectsAWindowThatNoFloatCanHold() {
    assertThrows(IllegalArgumentException.class, () -> new Perspective(Math.nextDown(180f), Float.MAX_VALUE));
    assertThrows(IllegalArgumentException.class, () -> new Perspective(Float.MIN_VALUE, 1));
  }
}
