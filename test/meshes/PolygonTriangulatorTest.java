package meshes;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;

import org.junit.jupiter.api.Test;

import trials.Trials;

/** The triangles of a polygon cover the same points as the even-odd rule, and none twice. */
class PolygonTriangulatorTest {

  private final PolygonTriangulator triangulator = new PolygonTriangulator();

  private static double[] flat(final double... xy) {
    final double[] coordinates = new double[xy.length / 2 * 3];
    for (int i = 0; i < xy.length / 2; i++) {
      coordinates[3 * i] = xy[2 * i];
      coordinates[3 * i + 1] = xy[2 * i + 1];
    }
    return coordinates;
  }

  private static int[] inOrder(final int number) {
    final int[] vertices = new int[number];
    for (int i = 0; i < number; i++) {
      vertices[i] = i;
    }
    return vertices;
  }

  private int[] triangles() {
    final int[] triangles = new int[3 * triangulator.triangles()];
    for (int i = 0; i < triangles.length; i++) {
      triangles[i] = triangulator.corner(i / 3, i % 3);
    }
    return triangles;
  }

  private void assertCut(final double[] xy, final int... expected) {
    assertTrue(triangulator.cut(flat(xy), inOrder(xy.length / 2), xy.length / 2));
    assertArrayEquals(expected, triangles());
  }

  private void assertFan(final double[] xy, final int... expected) {
    assertFalse(triangulator.cut(flat(xy), inOrder(xy.length / 2), xy.length / 2));
    assertArrayEquals(expected, triangles());
  }

  @Test
  void convexPolygonsAreFansOfTheirFirstCorner() {
    assertCut(new double[] {0, 0, 1, 0, 1, 1, 0, 1}, 0, 1, 2, 0, 2, 3);
    assertCut(new double[] {0, 0, 2, 0, 3, 1, 2, 2, 0, 2}, 0, 1, 2, 0, 2, 3, 0, 3, 4);
    assertCut(new double[] {0, 0, 0, 1, 1, 1, 1, 0}, 0, 1, 2, 0, 2, 3);
  }

  /** The tip of the arrow must not be cut off: from A to C lies outside if B or D is reflex. */
  @Test
  void quadrilateralsWithANotchKeepIt() {
    assertCut(new double[] {0, 0, 1, 0.5, 2, 0, 1, 3}, 1, 2, 3, 0, 1, 3);
    assertCut(new double[] {1, 0.5, 2, 0, 1, 3, 0, 0}, 0, 1, 2, 0, 2, 3);
  }

  @Test
  void theNotchOfASquareStaysOpen() {
    assertTrue(triangulator.cut(flat(0, 0, 3, 0, 3, 3, 2, 3, 2, 1, 1, 1, 1, 3, 0, 3), inOrder(8), 8));
    assertEquals(6, triangulator.triangles());
    assertEquals(7, area(flat(0, 0, 3, 0, 3, 3, 2, 3, 2, 1, 1, 1, 1, 3, 0, 3)), 1e-12);
  }

  @Test
  void cornersAtOnePlaceCountOnce() {
    assertCut(new double[] {0, 0, 0, 0, 1, 0, 1, 1, 1, 1, 0, 1, 0, 0}, 0, 2, 3, 0, 3, 5);
    assertCut(new double[] {0, 0, 1, 0, 0, 0, 0, 0, 0, 0});
    assertCut(new double[] {5, 5, 5, 5, 5, 5, 5, 5});
  }

  @Test
  void collinearCornersStay() {
    assertCut(new double[] {0, 0, 1, 0, 2, 0, 2, 2}, 1, 2, 3, 0, 1, 3);
  }

  @Test
  void aHoleByABridgeIsOpen() {
    final double[] xy = {0, 0, 4, 0, 4, 4, 0, 4, 0, 0, 1, 1, 1, 3, 3, 3, 3, 1, 1, 1};
    final int[] vertices = {0, 1, 2, 3, 0, 5, 6, 7, 8, 5};
    assertTrue(triangulator.cut(flat(xy), vertices, 10));
    assertEquals(8, triangulator.triangles());
    for (int t = 0; t < 8; t++) {
      final double x = centre(xy, vertices, t, 0), y = centre(xy, vertices, t, 1);
      assertTrue(x < 1 || x > 3 || y < 1 || y > 3, x + ", " + y);
    }
  }

  private double centre(final double[] xy, final int[] vertices, final int triangle, final int which) {
    double sum = 0;
    for (int k = 0; k < 3; k++) {
      sum += xy[2 * vertices[triangulator.corner(triangle, k)] + which];
    }
    return sum / 3;
  }

  @Test
  void whatCrossesItselfIsAFan() {
    assertFan(new double[] {0, 0, 1, 1, 1, 0, 0, 1}, 0, 1, 2, 0, 2, 3);
    assertFan(new double[] {0, 0, 1, 0, 2, 0, 3, 0}, 0, 1, 2, 0, 2, 3);
  }

  @Test
  void millionsAwayNothingChanges() {
    final double[] near = flat(0, 0, 0.25, 0.125, 0.5, 0, 0.25, 0.75), far = near.clone();
    for (int i = 0; i < far.length; i++) {
      far[i] += 4e6;
    }
    assertTrue(triangulator.cut(near, inOrder(4), 4));
    final int[] expected = triangles();
    assertTrue(triangulator.cut(far, inOrder(4), 4));
    assertArrayEquals(expected, triangles());
  }

  /** A polygon about the origin, its corners at increasing angles: simple, with many notches. */
  private static double[] star(final Random random, final int corners) {
    final double[] xy = new double[2 * corners];
    for (int i = 0; i < corners; i++) {
      final double angle = 2 * Math.PI * (i + 0.8 * random.nextDouble()) / corners, r = 0.2 + random.nextDouble();
      xy[2 * i] = r * Math.cos(angle);
      xy[2 * i + 1] = r * Math.sin(angle);
    }
    return xy;
  }

  /** Two rows of teeth that reach into each other's gaps, so that ears are hidden. */
  private static double[] comb(final Random random, final int corners) {
    final double[] xy = new double[2 * corners];
    final int half = corners / 2;
    for (int i = 0; i < corners; i++) {
      final boolean above = i >= half;
      final double x = above ? corners - 1 - i + 0.01 : i, wave = 5 * Math.abs(x % 4 - 2);
      xy[2 * i] = x;
      xy[2 * i + 1] = wave + (above ? 0.3 + random.nextDouble() : 0);
    }
    return xy;
  }

  @Test
  void simplePolygonsInAnyPlane() {
    Trials.of(400, random -> {
      final int corners = 4 + random.nextInt(random.nextBoolean() ? 10 : 197);
      assertLaws(random, random.nextBoolean() ? star(random, corners) : comb(random, corners));
    });
  }

  private void assertLaws(final Random random, final double[] xy) {
    final int n = xy.length / 2;
    final double[] p = turned(random, xy);
    assertTrue(triangulator.cut(p, inOrder(n), n), "it does not cross itself");
    assertEquals(n - 2, triangulator.triangles());
    final double whole = shoelace(xy);
    assertEquals(Math.abs(whole), area(p), 1e-9 * Math.abs(whole));
    for (int i = 0; i < 200; i++) {
      final int near = 2 * random.nextInt(n);
      final double x = xy[near] + 0.5 * random.nextGaussian(), y = xy[near + 1] + 0.5 * random.nextGaussian();
      assertEquals(isInside(xy, x, y) ? 1 : 0, covering(xy, x, y, whole < 0), x + ", " + y);
    }
  }

  /** The polygon in a plane of its own: its axes perpendicular to each other, of one length, somewhere. */
  private static double[] turned(final Random random, final double[] xy) {
    final double a = 7 * random.nextDouble(), b = 7 * random.nextDouble(), s = Math.pow(10, 6 * random.nextDouble() - 3);
    final double[] u = {s * Math.cos(a), s * Math.sin(a), 0};
    final double[] v = {-s * Math.sin(a) * Math.cos(b), s * Math.cos(a) * Math.cos(b), s * Math.sin(b)};
    final double[] p = new double[xy.length / 2 * 3];
    for (int i = 0; i < p.length; i++) {
      p[i] = u[i % 3] * xy[i / 3 * 2] + v[i % 3] * xy[i / 3 * 2 + 1] + s * (i % 3);
    }
    final double scale = s;
    for (int i = 0; i < p.length; i++) {
      p[i] /= scale;
    }
    return p;
  }

  private static double shoelace(final double[] xy) {
    double sum = 0;
    for (int i = 0; i < xy.length; i += 2) {
      final int j = (i + 2) % xy.length;
      sum += xy[i] * xy[j + 1] - xy[j] * xy[i + 1];
    }
    return sum / 2;
  }

  private double area(final double[] p) {
    double sum = 0;
    for (int t = 0; t < triangulator.triangles(); t++) {
      final NewellVector area = new NewellVector();
      area.compute(p, new int[] {triangulator.corner(t, 0), triangulator.corner(t, 1), triangulator.corner(t, 2)}, 3);
      sum += Math.sqrt(area.x() * area.x() + area.y() * area.y() + area.z() * area.z());
    }
    return sum;
  }

  private static boolean isInside(final double[] xy, final double x, final double y) {
    boolean inside = false;
    for (int i = 0; i < xy.length; i += 2) {
      final int j = (i + 2) % xy.length;
      inside ^= xy[i + 1] > y != xy[j + 1] > y
          && x < xy[i] + (y - xy[i + 1]) / (xy[j + 1] - xy[i + 1]) * (xy[j] - xy[i]);
    }
    return inside;
  }

  /** Number of triangles that hold a point; all must be wound as the polygon is. */
  private int covering(final double[] xy, final double x, final double y, final boolean clockwise) {
    int covering = 0;
    for (int t = 0; t < triangulator.triangles(); t++) {
      boolean inside = true;
      for (int k = 0; k < 3; k++) {
        final int i = 2 * triangulator.corner(t, k), j = 2 * triangulator.corner(t, (k + 1) % 3);
        final double side = (xy[j] - xy[i]) * (y - xy[i + 1]) - (xy[j + 1] - xy[i + 1]) * (x - xy[i]);
        inside &= clockwise ? side < 0 : side > 0;
      }
      covering += inside ? 1 : 0;
    }
    return covering;
  }

  /** Searching by the grid gives the same result as testing all corners; ten thousand corners take no time. */
  @Test
  void tenThousandCornersAreCutAtOnce() {
    Trials.of(3, random -> {
      for (final double[] xy : new double[][] {star(random, 10_000), comb(random, 10_000)}) {
        assertTrue(triangulator.cut(flat(xy), inOrder(10_000), 10_000));
        assertEquals(9998, triangulator.triangles());
        assertEquals(Math.abs(shoelace(xy)), area(flat(xy)), 1e-9 * Math.abs(shoelace(xy)));
      }
    });
  }
}
