package models;

import static models.HitAssertions.assertHit;
import static models.HitAssertions.assertMiss;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.time.Duration;
import java.util.Random;

import org.apache.commons.numbers.core.DD;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;
import trials.Trials;

class TorusTest implements Object3DContract {

  private static final Point3D O = new Point3D(0, 0, 0);
  private static final Vector3D X = new Vector3D(1, 0, 0);
  private static final Vector3D Y = new Vector3D(0, 1, 0);

  /** Radii 10 and 5, so that the tube has points at the corners of the triangle 3, 4, 5. */
  private static final Torus TORUS = new Torus(O, Y, 10, 5, Color.RED);

  /** Without a hole: on the axis it ends at the height √(5² − 3²) = 4. */
  private static final Torus APPLE = new Torus(O, Y, 3, 5, Color.RED);

  @Override
  public Object3D shape(final RandomPlacement at) {
    return new Torus(at.point(1, -2, 3), at.direction(1, 2, -0.5f), at.length(2), at.length(0.75f), Color.RED);
  }

  @Override
  public double signedDistance(final double x, final double y, final double z) {
    final double length = Math.sqrt(5.25), px = x - 1, py = y + 2, pz = z - 3;
    final double h = (px + 2 * py - 0.5 * pz) / length, p2 = px * px + py * py + pz * pz;
    return Math.hypot(Math.sqrt(Math.max(0, p2 - h * h)) - 2, h) - 0.75;
  }

  @Override
  public double accuracy() {
    return 1e-7;
  }

  @Test
  void rayInThePlaneOfTheRingHitsTheOuterEquator() {
    assertHit(5, new Point3D(-15, 0, 0), new Vector3D(-1, 0, 0), TORUS, new Ray(new Point3D(-20, 0, 0), X));
  }

  @Test
  void rayFromTheHoleHitsTheInnerEquator() {
    assertHit(5, new Point3D(5, 0, 0), new Vector3D(-1, 0, 0), TORUS, new Ray(O, X));
    assertHit(2, new Point3D(0, 0, -5), new Vector3D(0, 0, 1), TORUS,
        new Ray(new Point3D(0, 0, -3), new Vector3D(0, 0, -7)));
  }

  @Test
  void rayAlongTheAxisHitsTheTubeAtTheCornerOfTheTriangle345() {
    assertHit(6, new Point3D(13, 4, 0), new Vector3D(0.6f, 0.8f, 0), TORUS,
        new Ray(new Point3D(13, 10, 0), new Vector3D(0, -1, 0)));
    assertHit(6, new Point3D(0, -4, 7), new Vector3D(0, -0.8f, -0.6f), TORUS,
        new Ray(new Point3D(0, -10, 7), new Vector3D(0, 1, 0)));
  }

  @Test
  void rayThroughTheHoleMisses() {
    assertMiss(TORUS, new Ray(new Point3D(0, 50, 0), new Vector3D(0, -1, 0)));
    assertMiss(TORUS, new Ray(new Point3D(4, 50, 2), new Vector3D(0, -1, 0)));
    assertMiss(TORUS, new Ray(new Point3D(-4.5f, -6, 0), new Vector3D(3, 4, 0)));
  }

  @Test
  void rayFromWithinTheTubeHitsItsFarWallWithTheOutwardNormal() {
    assertHit(5, new Point3D(10, 5, 0), Y, TORUS, new Ray(new Point3D(10, 0, 0), Y));
    assertHit(4, new Point3D(15, 0, 0), X, TORUS, new Ray(new Point3D(11, 0, 0), X));
    assertHit(6, new Point3D(5, 0, 0), new Vector3D(-1, 0, 0), TORUS,
        new Ray(new Point3D(11, 0, 0), new Vector3D(-1, 0, 0)));
  }

  @Test
  void rayFromTheSurfaceInwardsHitsTheFarWallOrTheStart() {
    for (final float angle : new float[] {0, 0.3f, 1, 1.5f}) {
      final Hit hit = TORUS.intersectionWith(new Ray(new Point3D(15, 0, 0),
          new Vector3D((float) -Math.cos(angle), (float) Math.sin(angle), 0)));
      assertTrue(Math.abs(hit.getT() - 10 * Math.cos(angle)) < 1e-5 || hit.getT() < 1e-5, () -> angle + ": " + hit);
    }
  }

  @Test
  void rayThatLeavesTheSurfaceHitsNothing() {
    for (final Vector3D v : new Vector3D[] {X, new Vector3D(1, 1, 0), new Vector3D(1, 0, 3), new Vector3D(0.01f, 1, 0)}) {
      final Hit hit = TORUS.intersectionWith(new Ray(new Point3D(15, 0, 0), v));
      assertTrue(!hit.hits() || hit.getT() < 1e-5, () -> v + ": " + hit);
    }
  }

  @Test
  void rayThatLeavesTheInnerEquatorCrossesTheHole() {
    assertHit(10, new Point3D(-5, 0, 0), X, TORUS, new Ray(new Point3D(4.9999995f, 0, 0), new Vector3D(-1, 0, 0)));
  }

  @Test
  void withoutAHoleTheInnerSurfaceIsNoSurface() {
    assertHit(8, new Point3D(8, 0, 0), X, APPLE, new Ray(O, X));
    assertHit(10, new Point3D(-8, 0, 0), new Vector3D(-1, 0, 0), APPLE,
        new Ray(new Point3D(2, 0, 0), new Vector3D(-1, 0, 0)));
    assertHit(4, new Point3D(3, 5, 0), Y, APPLE, new Ray(new Point3D(3, 1, 0), Y));
  }

  @Test
  void withoutAHoleTheAxisEndsInTheDimples() {
    assertEquals(6, APPLE.intersectionWith(new Ray(new Point3D(0, 10, 0), new Vector3D(0, -1, 0))).getT(), 1e-6);
    assertEquals(4, APPLE.intersectionWith(new Ray(O, new Vector3D(0, -1, 0))).getT(), 1e-6);
    assertEquals(1, APPLE.intersectionWith(new Ray(new Point3D(0, -3, 0), new Vector3D(0, -1, 0))).getT(), 1e-6);
  }

  @Test
  void hornTorusTouchesItselfInItsCentre() {
    final Torus horn = new Torus(O, Y, 2, 2, Color.RED);
    assertHit(4, new Point3D(4, 0, 0), X, horn, new Ray(new Point3D(8, 0, 0), new Vector3D(-1, 0, 0)));
    assertHit(3, new Point3D(2, 2, 0), Y, horn, new Ray(new Point3D(2, 5, 0), new Vector3D(0, -1, 0)));
  }

  @ParameterizedTest
  @ValueSource(floats = {0.35f, 0.02f, 0.001f, 1e-5f, 0.9f, 1, 1.2f, 3, 100})
  void hitsAreThoseOfTheQuartic(final float ratio) {
    Trials.of(6, random -> {
      final float R = (float) Math.scalb(1 + random.nextDouble(), random.nextInt(40) - 20), r = ratio * R;
      final Point3D C = placeNear(random, R);
      final Vector3D axis = random.nextInt(3) == 0 ? Y : vector(random);
      final RandomRays rays = Surfaces.ofTorus(random, C, axis, R, r);
      final MarchingTrial trial = new MarchingTrial(new Torus(C, axis, R, r, Color.RED), new TorusOracle(C, axis, R, r));
      for (final RandomRays.Kind kind : RandomRays.Kind.values()) {
        for (int i = 0; i < 60; i++) {
          trial.ask(rays.next(kind));
        }
      }
      trial.assertExact(1e-7, 1e-4);
    });
  }

  /**
   * On the inner half the surface curves both ways, and between there are directions of no curvature at all: a ray along
   * one of them, a little above or below the surface, stays close to it longest. Of the tube's angle a, tan² of the
   * direction is −r cos a / (R + r cos a).
   */
  @Test
  void raysAlongDirectionsWithoutCurvatureComeToAnEnd() {
    final CrossingOracle oracle = new TorusOracle(O, Y, 10, 5);
    final MarchingTrial trial = new MarchingTrial(TORUS, oracle);
    Trials.of(3000, random -> {
      final double a = Math.PI * (0.5 + random.nextDouble()), across = 10 + 5 * Math.cos(a);
      final double tan = Math.sqrt(-5 * Math.cos(a) / across), along = 1 / Math.sqrt(1 + tan * tan);
      final double up = tan * along * Math.cos(a), out = -tan * along * Math.sin(a);
      final double off = Math.pow(10, -1 - 11 * random.nextDouble()) * (random.nextBoolean() ? 1 : -1);
      final double x = across + off * Math.cos(a), y = (5 + off) * Math.sin(a), before = 5 * random.nextDouble();
      trial.ask(Ray.exactly(x - before * out, y - before * up, -before * along, out, up, along));
    });
    trial.assertExact(1e-7, 1e-5);
  }

  static Point3D placeNear(final Random random, final double size) {
    final double far = random.nextInt(3) == 0 ? 0 : size * Math.pow(10, 4 * random.nextDouble() - 2);
    return new Point3D((float) (far * random.nextGaussian()), (float) (far * random.nextGaussian()),
        (float) (far * random.nextGaussian()));
  }

  static Vector3D vector(final Random random) {
    return new Vector3D((float) random.nextGaussian(), (float) random.nextGaussian(), (float) random.nextGaussian());
  }

  @ParameterizedTest
  @ValueSource(floats = {1e30f, 1e-30f, 1e38f, 1e-38f})
  void sizesAtTheEndsOfTheFloatsWork(final float size) {
    final Torus torus = new Torus(O, Y, size, 0.25f * size, Color.RED);
    assertEquals(0.75f * size, torus.intersectionWith(new Ray(O, X)).getT(), 1e-6f * size);
    assertEquals(0.25f * size, torus.intersectionWith(new Ray(new Point3D(size, 0, 0), Y)).getT(), 1e-6f * size);
    assertMiss(torus, new Ray(new Point3D(0, size, 0), new Vector3D(0, -1, 0)));
  }

  @Test
  void anyRayEndsSoon() {
    final double[] numbers = {0, -0.0, 1, -1, 1e-30, 1e30, -1e300, Double.MIN_VALUE, Double.NaN, Double.POSITIVE_INFINITY};
    final Object3D[] shapes = {TORUS, APPLE, new Torus(O, Y, 1e30f, 1e-30f, Color.RED),
      new Torus(O, Y, 1e-30f, 1e30f, Color.RED), new Ellipsoid(O, X, Y, 1e30f, 1e-30f, 1, Color.RED)};
    assertTimeoutPreemptively(Duration.ofSeconds(20), () -> Trials.of(20_000, random -> {
      final double[] n = random.doubles(6).map(d -> numbers[(int) (d * numbers.length)]).toArray();
      for (final Object3D shape : shapes) {
        final double t = shape.distance(n[0], n[1], n[2], n[3], n[4], n[5]);
        assertTrue(!Double.isNaN(t), () -> shape + ": " + t);
      }
    }));
  }

  @Test
  void aRayFromTheCentreOfTheAppleIsOffTheQuarticsInnerRoots() {
    final MarchingTrial trial = new MarchingTrial(APPLE, new TorusOracle(O, Y, 3, 5));
    Trials.of(2000, random -> trial.ask(new Ray(new Point3D(random.nextFloat(), random.nextFloat(), random.nextFloat()),
        vector(random))));
    trial.assertExact(1e-7, 1e-4);
    assertEquals(trial.rays, trial.hits);
  }

  @Test
  void theSignedDistanceIsExactExceptInsideAnApple() {
    Trials.of(3000, random -> {
      final Point3D P = new Point3D(30 * random.nextFloat() - 15, 12 * random.nextFloat() - 6, 30 * random.nextFloat() - 15);
      final DD across = DD.ofProduct(P.x, P.x).add(DD.ofProduct(P.z, P.z)).sqrt();
      for (final Torus torus : new Torus[] {TORUS, APPLE}) {
        final float R = torus == TORUS ? 10 : 3;
        final DD a = across.subtract(DD.of(R));
        final DD distance = a.multiply(a).add(DD.ofProduct(P.y, P.y)).sqrt().subtract(DD.of(5));
        final double sdf = torus.SDF(P);
        assertTrue(sdf * distance.hi() > 0, () -> P + ": " + sdf);
        assertTrue(DD.of(Math.abs(sdf)).subtract(distance.abs()).hi() <= 0, () -> P + ": " + sdf);
        assertEquals(distance.hi(), sdf, 1e-6);
      }
    });
  }

  @Test
  void insideAnAppleTheSignedDistanceIsABound() {
    final RandomRays points = Surfaces.ofTorus(new Random(1), O, Y, 3, 5);
    Trials.of(3000, random -> {
      final Point3D P = new Point3D(4 * random.nextFloat() - 2, 6 * random.nextFloat() - 3, 4 * random.nextFloat() - 2);
      final double[] s = points.surfacePoint();
      assertTrue(APPLE.SDF(P) < 0);
      assertTrue(-APPLE.SDF(P) <= Math.hypot(Math.hypot(P.x - s[0], P.y - s[1]), P.z - s[2]), () -> "" + P);
    });
  }

  @Test
  void noPointIsFartherThanTheUpperBoundButOneIsNearlyThatFar() {
    final Torus torus = new Torus(new Point3D(1, 2, 3), new Vector3D(1, 1, 0), 2, 0.5f, Color.RED);
    final RandomRays points = Surfaces.ofTorus(new Random(2), new Point3D(1, 2, 3), new Vector3D(1, 1, 0), 2, 0.5f);
    Trials.of(20, random -> {
      final Point3D P = new Point3D(9 * random.nextFloat() - 4, 9 * random.nextFloat() - 4, 9 * random.nextFloat() - 4);
      double farthest = 0;
      for (int i = 0; i < 3000; i++) {
        final double[] s = points.surfacePoint();
        farthest = Math.max(farthest, Math.hypot(Math.hypot(P.x - s[0], P.y - s[1]), P.z - s[2]));
      }
      assertTrue(farthest <= torus.distanceUpperBound(P));
      assertEquals(farthest, torus.distanceUpperBound(P), 0.02 * farthest);
    });
  }

  @Test
  void theBoxIsTight() {
    final BoundingBox box = new Torus(new Point3D(1, 2, 3), new Vector3D(3, 4, 0), 10, 2, Color.RED).getBoundingBox();
    assertClose(new Point3D(1 - 10, 2 - 8, 3 - 12), box.getMin());
    assertClose(new Point3D(1 + 10, 2 + 8, 3 + 12), box.getMax());
  }

  static void assertClose(final Point3D expected, final Point3D actual) {
    assertEquals(expected.x, actual.x, 4e-6);
    assertEquals(expected.y, actual.y, 4e-6);
    assertEquals(expected.z, actual.z, 4e-6);
  }

  @Test
  void tellsWhatItIs() {
    assertEquals("Torus(C=(0.0, 0.0, 0.0), axis=(0.0, 1.0, 0.0), R=10.0, r=5.0)", TORUS.toString());
  }
}
