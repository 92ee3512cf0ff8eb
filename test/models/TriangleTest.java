package models;

import static models.HitAssertions.assertHit;
import static models.HitAssertions.assertMiss;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.math.BigDecimal;

import org.junit.jupiter.api.Test;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

class TriangleTest implements Object3DContract {

  /** Right-angled, with legs 3 and 4, in the plane z = 2. */
  private static final Triangle RIGHT =
      new Triangle(new Point3D(0, 0, 2), new Point3D(3, 0, 2), new Point3D(0, 4, 2), Color.BLUE);

  @Override
  public Object3D shape(final RandomPlacement at) {
    return new Triangle(at.point(1, 0, -1), at.point(-1, 2, 0), at.point(0, -1.5, 2), Color.BLUE);
  }

  @Override
  public double signedDistance(final double x, final double y, final double z) {
    final double[] a = {1, 0, -1}, b = {-1, 2, 0}, c = {0, -1.5, 2}, p = {x, y, z}, n = cross(minus(b, a), minus(c, a));
    final double outside = Math.max(0, Math.max(over(a, b, n, p), Math.max(over(b, c, n, p), over(c, a, n, p))));
    final double above = dot(minus(p, a), n) / Math.sqrt(dot(n, n));
    return outside > 1e-12 ? Math.hypot(outside, above) : above;
  }

  /** How far a point is on the outer side of an edge. */
  private static double over(final double[] a, final double[] b, final double[] n, final double[] p) {
    final double[] out = cross(minus(b, a), n);
    return dot(minus(p, a), out) / Math.sqrt(dot(out, out));
  }

  private static double[] minus(final double[] a, final double[] b) {
    return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }

  private static double[] cross(final double[] a, final double[] b) {
    return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  private static double dot(final double[] a, final double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  @Override
  public boolean isClosed() {
    return false;
  }

  @Override
  public double accuracy() {
    return 1e-13;
  }

  @Test
  void rayHitsTheInsideAtTheCornerOfTheTriangle345() {
    assertHit(5, new Point3D(1, 1, 2), new Vector3D(0, 0, 1), RIGHT,
        new Ray(new Point3D(1, -3, 5), new Vector3D(0, 4, -3)));
  }

  @Test
  void rayFromBehindHitsWithTheSameNormal() {
    assertHit(2, new Point3D(1, 1, 2), new Vector3D(0, 0, 1), RIGHT, new Ray(new Point3D(1, 1, 0), new Vector3D(0, 0, 1)));
  }

  @Test
  void clockwiseVerticesTurnTheNormal() {
    final Triangle turned = new Triangle(new Point3D(0, 0, 2), new Point3D(0, 4, 2), new Point3D(3, 0, 2), Color.BLUE);
    assertHit(2, new Point3D(1, 1, 2), new Vector3D(0, 0, -1), turned, new Ray(new Point3D(1, 1, 0), new Vector3D(0, 0, 1)));
  }

  @Test
  void raysAtEdgesAndVerticesHit() {
    for (final float[] at : new float[][] {{0, 0}, {3, 0}, {0, 4}, {1.5f, 0}, {0, 2}, {1.5f, 2}, {0.75f, 3}}) {
      assertHit(7, new Point3D(at[0], at[1], 2), new Vector3D(0, 0, 1), RIGHT,
          new Ray(new Point3D(at[0], at[1], 9), new Vector3D(0, 0, -1)));
    }
  }

  @Test
  void raysJustBesideItMiss() {
    final float least = Float.MIN_VALUE;
    for (final float[] at : new float[][] {{-least, 1}, {1, -least}, {Math.nextUp(1.5f), 2}, {1.5f, Math.nextUp(2f)},
        {Math.nextUp(3f), 0}, {0, Math.nextUp(4f)}, {3, 4}}) {
      assertMiss(RIGHT, new Ray(new Point3D(at[0], at[1], 9), new Vector3D(0, 0, -1)));
    }
  }

  /**
   * Vertices count as aligned if the height over the longest side is at most 2⁻²⁴ of the greatest coordinate: with a longest
   * side of the length of that coordinate, along each axis, for each vertex that has it, and with either sign.
   */
  @Test
  void verticesAreAlignedUpToTheRoundingOfTheirGreatestCoordinate() {
    final int[][] orders = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (final float greatest : new float[] {1, -1, 1e-20f, -3e20f}) {
      for (final int[] order : orders) {
        for (int axis = 0; axis < 3; axis++) {
          final float height = Math.abs(greatest) * 0x1p-24f;
          assertEquals(true, isTriangle(greatest, 1.02f * height, axis, order));
          assertEquals(false, isTriangle(greatest, 0.98f * height, axis, order));
        }
      }
    }
  }

  /** (g, 0, 0), (0, 0, 0) and (0.4 g, h, 0), with the coordinates turned round and the vertices in some order. */
  private static boolean isTriangle(final float greatest, final float height, final int axis, final int... order) {
    final float[][] vertices = {{greatest, 0, 0}, {0, 0, 0}, {0.4f * greatest, height, 0}};
    final Point3D[] P = new Point3D[3];
    for (int i = 0; i < 3; i++) {
      final float[] v = vertices[order[i]];
      P[i] = new Point3D(v[(3 - axis) % 3], v[(4 - axis) % 3], v[(5 - axis) % 3]);
    }
    try {
      return new Triangle(P[0], P[1], P[2], Color.BLUE) != null;
    } catch (final IllegalArgumentException aligned) {
      return false;
    }
  }

  /** The same far from the origin, where the coordinate of all three that does not change is the greatest. */
  @Test
  void aThinTriangleFarAwayIsNone() {
    for (final float far : new float[] {64, -64}) {
      final float thin = 0x1p-19f, ample = 0x1p-17f;
      assertThrows(IllegalArgumentException.class, () -> new Triangle(new Point3D(0, 0, far), new Point3D(1, 0, far),
          new Point3D(0.5f, thin, far), Color.BLUE));
      assertEquals(far, new Triangle(new Point3D(0, 0, far), new Point3D(1, 0, far), new Point3D(0.5f, ample, far),
          Color.BLUE).getBoundingBox().minZ());
    }
  }

  @Test
  void rayInItsPlaneMisses() {
    assertMiss(RIGHT, new Ray(new Point3D(-5, 1, 2), new Vector3D(1, 0, 0)));
    assertMiss(RIGHT, new Ray(new Point3D(1, 1, 2), new Vector3D(0, 1, 0)));
    assertMiss(RIGHT, new Ray(new Point3D(-5, 1, 3), new Vector3D(1, 0, 0)));
  }

  @Test
  void triangleBehindTheRayIsMissed() {
    assertMiss(RIGHT, new Ray(new Point3D(1, 1, 3), new Vector3D(0, 0, 1)));
    assertMiss(RIGHT, new Ray(new Point3D(1, 1, 1), new Vector3D(0, 0, -1)));
  }

  @Test
  void agreesWithExactArithmetic() {
    final RandomNumbers numbers = new RandomNumbers("exact triangle");
    int hits = 0, misses = 0;
    for (int i = 0; i < RandomNumbers.times(3000); i++) {
      final float size = numbers.magnitude(-20, 20);
      final Point3D about = numbers.pointAbout(new Point3D(), size * numbers.magnitude(-3, 5)),
          A = numbers.pointAbout(about, size),
          B = numbers.pointAbout(about, size), C = numbers.pointAbout(about, size);
      final Point3D target = numbers.pointAbout(about, 0.6 * size);
      final Ray ray = new Ray(numbers.pointAbout(about, size * numbers.magnitude(0, 10)), target);
      final Triangle triangle = new Triangle(A, B, C, Color.BLUE);
      final double t = exactly(ray, A, B, C);
      final Hit hit = triangle.intersectionWith(ray);
      final String what = triangle + ", " + ray + ", exactly " + t + ": " + hit + ", " + numbers;
      if (!Double.isNaN(t)) {
        assertEquals(t > 0 && t < Double.POSITIVE_INFINITY, hit.hits(), what);
        hits += hit.hits() ? 1 : 0;
        misses += hit.hits() ? 0 : 1;
        assertTrue(!hit.hits() || Math.abs(hit.getT() - t) <= 1e-6 * t, what);
      }
    }
    assertTrue(hits > RandomNumbers.times(300) && misses > RandomNumbers.times(1000), hits + " hits, " + misses + " misses");
  }

  /** t by barycentric coordinates; infinity for a miss; NaN where a result in double may differ from the exact one. */
  private static double exactly(final Ray ray, final Point3D A, final Point3D B, final Point3D C) {
    final ExactSpan.Line line = ExactSpan.Line.of(ray);
    final ExactVector a = ExactVector.of(A), e = ExactVector.of(B).minus(a), f = ExactVector.of(C).minus(a), n = e.cross(f);
    final ExactVector r = line.start().minus(a);
    final BigDecimal slope = line.direction().dot(n), t = r.dot(n).negate().divide(slope, ExactVector.DIGITS);
    final ExactVector p = r.plus(line.direction().times(t));
    final double u = p.cross(f).dot(n).divide(n.dot(n), ExactVector.DIGITS).doubleValue();
    final double v = e.cross(p).dot(n).divide(n.dot(n), ExactVector.DIGITS).doubleValue();
    final double least = Math.min(Math.min(u, v), 1 - u - v),
        cosine = Math.abs(slope.doubleValue()) / n.length().doubleValue();
    return Math.abs(least) < 1e-9 || cosine < 1e-4 ? Double.NaN : least > 0 ? t.doubleValue() : Double.POSITIVE_INFINITY;
  }

  @Test
  void boxGoesFromLeastToGreatestCoordinates() {
    assertEquals("BoundingBox((0.0, 0.0, 2.0), (3.0, 4.0, 2.0))", RIGHT.getBoundingBox().toString());
  }

  @Test
  void aHitOfAFlatTriangleLiesInItsBox() {
    final RandomNumbers numbers = new RandomNumbers("flat triangle");
    for (int i = 0; i < 2000; i++) {
      final Triangle flat = new Triangle(new Point3D(-1, 0, 0), new Point3D(1, 0, -1), new Point3D(0, 0, 1), Color.BLUE);
      final Hit hit = flat.intersectionWith(new Ray(numbers.pointAbout(new Point3D(0, 3, 0), 2),
          new Point3D(0.1f, 0, 0.1f)));
      assertTrue(hit.hits() && flat.getBoundingBox().contains(hit.getPoint()), () -> hit + ", " + numbers);
    }
  }

  @Test
  void needlesAndTinyTrianglesAreNotAligned() {
    final Triangle needle = new Triangle(new Point3D(), new Point3D(1, 0, 0), new Point3D(1, 1e-6f, 0), Color.BLUE);
    assertTrue(needle.intersectionWith(new Ray(new Point3D(0.9f, 5e-7f, 1), new Vector3D(0, 0, -1))).hits());
    final float s = 1e-30f;
    final Triangle tiny = new Triangle(new Point3D(), new Point3D(s, 0, 0), new Point3D(0, s, 0), Color.BLUE);
    assertHit(1, new Point3D(), new Vector3D(0, 0, 1), tiny, new Ray(new Point3D(s / 4, s / 4, 1), new Vector3D(0, 0, -1)));
  }

  @Test
  void textTellsTheVertices() {
    assertEquals("Triangle(A=(0.0, 0.0, 2.0), B=(3.0, 0.0, 2.0), C=(0.0, 4.0, 2.0))", RIGHT.toString());
  }
}
