package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/** Assertions about hits. */
final class HitAssertions {

  private HitAssertions() {
  }

  /** Asserts that a ray hits a shape where it was computed on paper. */
  static void assertHit(final double t, final Point3D P, final Vector3D n, final Object3D shape, final Ray ray) {
    final Hit hit = shape.intersectionWith(ray);
    final String what = shape + ", " + ray + ": " + hit;
    assertTrue(hit.hits(), what);
    assertEquals(t, hit.getT(), 2e-7 * t, what);
    assertClose(P, hit.getPoint(), 2e-7 * (1 + t), what);
    assertClose(n, hit.getNormal(), 2e-7, what);
    assertSame(shape, hit.getObject(), what);
  }

  static void assertMiss(final Object3D shape, final Ray ray) {
    final Hit hit = shape.intersectionWith(ray);
    assertSame(Hit.NOHIT, hit, () -> shape + ", " + ray + ": " + hit);
  }

  /** Asserts that two hits are equal, bit for bit. */
  static void assertSameHit(final Hit expected, final Hit hit, final String what) {
    if (!isSame(expected, hit)) {
      assertEquals(String.valueOf(expected), String.valueOf(hit), what);
      assertSame(expected.getObject(), hit.getObject(), what);
      assertEquals(numbers(expected), numbers(hit), what);
    }
  }

  static boolean isSame(final Hit a, final Hit b) {
    return a == b || a.hits() && b.hits() && a.getT() == b.getT() && a.getObject() == b.getObject()
        && a.pointX() == b.pointX() && a.pointY() == b.pointY() && a.pointZ() == b.pointZ()
        && a.normalX() == b.normalX() && a.normalY() == b.normalY() && a.normalZ() == b.normalZ();
  }

  private static String numbers(final Hit hit) {
    return hit.getT() + " " + hit.pointX() + " " + hit.pointY() + " " + hit.pointZ() + " "
        + hit.normalX() + " " + hit.normalY() + " " + hit.normalZ();
  }

  static void assertClose(final javax.vecmath.Tuple3f expected, final javax.vecmath.Tuple3f found, final double tolerance,
      final String what) {
    assertEquals(expected.x, found.x, tolerance, what);
    assertEquals(expected.y, found.y, tolerance, what);
    assertEquals(expected.z, found.z, tolerance, what);
  }
}
