package view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;
import tracer.RayGenerator;
import trials.Trials;

class FishEyeTest {

  private static RayGenerator generator(final Projection projection, final int W, final int H) {
    final Camera camera = new Camera(new Point3D(1, 2, 3), new Point3D(-2, 3, 5), new Vector3D(0.1f, 1, 0.2f));
    camera.setProjection(projection);
    return camera.getRayGenerator(W, H);
  }

  /** The same rays as the library's fish-eye, whose window is larger by the factor 1 / cos(fov/2). */
  @Test
  void agreesWithTheLibraryBelow180Degrees() {
    Trials.of(2000, random -> {
      final float fov = 1 + 178 * random.nextFloat();
      final int W = 1 + random.nextInt(60), H = 1 + random.nextInt(60), m = random.nextInt(W), n = random.nextInt(H);
      final Ray expected = generator(new Angular(fov), W, H).getRay(m, n);
      final Ray actual = generator(new FishEye(fov), W, H).getRay(m, n);
      final double x = 2 * (m + 0.5) / W - 1, y = 2 * (n + 0.5) / H - 1;
      if (Math.abs(Math.hypot(x, y) - 1) > 1e-9) {
        assertEquals(expected == Ray.NORAY, actual == Ray.NORAY);
      }
      if (expected != Ray.NORAY && actual != Ray.NORAY) {
        assertTrue(expected.getDirection().epsilonEquals(actual.getDirection(), 1e-6f), expected + " " + actual);
        assertEquals(expected.getStartingPoint(), actual.getStartingPoint());
      }
    });
  }

  @Test
  void at180DegreesTheRimLooksSideways() {
    final Camera camera = new Camera(new Point3D(), new Point3D(0, 0, -1), new Vector3D(0, 1, 0));
    camera.setProjection(new FishEye(180));
    assertEquals(2, camera.getProjection().getWidth(), 1e-6);
    assertEquals(2, camera.getProjection().getHeight(), 1e-6);
    final RayGenerator generator = camera.getRayGenerator(1000, 3);
    final Vector3D rim = generator.getRay(999, 1).getDirection();
    assertEquals(0.999, rim.x, 1e-6);
    assertEquals(-Math.sqrt(1 - 0.999 * 0.999), rim.z, 1e-6);
    assertSame(Ray.NORAY, camera.getRayGenerator(100, 100).getRay(99, 99));
    assertThrows(IllegalArgumentException.class, () -> generator.getRay(1000, 0));
  }

  @Test
  void theRimItselfHasARay() {
    assertEquals(0, new FishEye(180).zAt(1, 0), 0);
    assertTrue(Double.isNaN(new FishEye(180).zAt(Math.nextUp(1.0), 0)));
  }

  @ParameterizedTest
  @ValueSource(floats = {0, -1, 180.00002f, Float.NaN, Float.POSITIVE_INFINITY})
  void rejectsAnglesOutOfRange(final float fov) {
    final Exception wrong = assertThrows(IllegalArgumentException.class, () -> new FishEye(fov));
    assertTrue(wrong.getMessage().startsWith("fov "), wrong.getMessage());
  }

  @Test
  void servesOnlyTheCameraThatHoldsIt() {
    final FishEye fishEye = new FishEye(100);
    final Camera camera = new Camera(new Point3D(), new Point3D(0, 0, -1), new Vector3D(0, 1, 0));
    assertThrows(IllegalStateException.class, () -> fishEye.getRayGenerator(camera, 1, 1));
    assertThrows(IllegalArgumentException.class, () -> fishEye.getRayGenerator(null, 1, 1));
    camera.setProjection(new FishEye(100));
    assertThrows(IllegalStateException.class, () -> fishEye.getRayGenerator(camera, 1, 1));
  }
}
