package view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;
import tracer.RayGenerator;

class AngularTest implements ProjectionContract {

  /** Distance from the rim, relative, within which rounding may put a pixel to either side. */
  private static final double RIM = 1e-12;

  @Override
  public Optics random(final Random random) {
    final float omega = random.nextInt(4) == 0 ? 179.9f * random.nextFloat() + 0.01f : 30 + 120 * random.nextFloat();
    final double half = omega * Math.PI / 360, rim = Math.tan(half);
    return new Optics(new Angular(omega), 2 * rim, 2 * rim, (x, y) -> {
      final double rho = Math.hypot(x, y);
      if (Math.abs(rho / rim - 1) < RIM) {
        return new double[0];
      }
      return rho > rim ? null : new double[] {0, 0, 0, x, y, -Math.sqrt(1 / Math.cos(half) / Math.cos(half) - rho * rho)};
    });
  }

  @Test
  void theRimLiesAtHalfTheApertureAndBeyondThereIsNoRay() {
    final Camera camera = new Camera(new Point3D(), new Point3D(0, 0, -1), new Vector3D(0, 1, 0));
    camera.setProjection(new Angular(120));
    final int W = 2001;
    final RayGenerator generator = camera.getRayGenerator(W, W);
    final Ray rim = generator.getRay(0, W / 2);
    final double cosine = -rim.directionZ();
    assertEquals(60, Math.toDegrees(Math.acos(cosine)), 0.1);
    assertSame(Ray.NORAY, generator.getRay(0, 0));
    assertSame(Ray.NORAY, generator.getRay(0, W / 2 - 60));
    assertSame(Ray.NORAY, generator.getRay(W - 1, W - 1));
    assertNotSame(Ray.NORAY, generator.getRay(0, W / 2));
    assertNotSame(Ray.NORAY, generator.getRay(W / 2, W - 1));
  }

  @Test
  void theRimItselfHasARay() {
    final double rim = StrictMath.tan(Math.toRadians(120) / 2);
    assertEquals(-1, new Angular(120).zAt(rim, 0), 1e-15);
    assertTrue(Double.isNaN(new Angular(120).zAt(rim * (1 + 1e-15), 0)));
  }

  @Test
  void halfWayToTheRimTheSineIsHalf() {
    final Camera camera = new Camera(new Point3D(), new Point3D(0, 0, -1), new Vector3D(0, 1, 0));
    camera.setProjection(new Angular(60));
    final Ray ray = camera.getRayGenerator(2, 1).getRay(1, 0);
    assertEquals(0.25, ray.directionX(), 1e-7);
    assertEquals(0, ray.directionY(), 1e-7);
    assertEquals(-Math.sqrt(15) / 4, ray.directionZ(), 1e-7);
  }

  @Test
  void theCircleTouchesTheSidesOfTheImage() {
    final Camera camera = new Camera(new Point3D(), new Point3D(3, 1, 2), new Vector3D(0, 1, 0));
    camera.setProjection(new Angular(179));
    final RayGenerator generator = camera.getRayGenerator(100, 100);
    int rays = 0;
    for (int m = 0; m < 100; m++) {
      for (int n = 0; n < 100; n++) {
        rays += generator.getRay(m, n) == Ray.NORAY ? 0 : 1;
      }
    }
    assertTrue(Math.abs(rays - Math.PI * 2500) < 60, "rays: " + rays);
  }

  @ParameterizedTest
  @ValueSource(floats = {0, -1, 180, 360, Float.NaN, Float.POSITIVE_INFINITY})
  void rejectsAnApertureThatIsNotBetween0And180Degrees(final float omega) {
    final Exception wrong = assertThrows(IllegalArgumentException.class, () -> new Angular(omega));
    assertTrue(wrong.getMessage().startsWith("omega "), wrong.getMessage());
  }
}
