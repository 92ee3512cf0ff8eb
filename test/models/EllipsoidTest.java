package models;

import static models.HitAssertions.assertHit;
import static models.HitAssertions.assertMiss;
import static models.TorusTest.assertClose;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;
import trials.Trials;

class EllipsoidTest implements Object3DContract {

  private static final Point3D O = new Point3D(0, 0, 0);
  private static final Vector3D X = new Vector3D(1, 0, 0);
  private static final Vector3D Y = new Vector3D(0, 1, 0);

  /** Contains (3, 8, 0) = (5 · 0.6, 10 · 0.8, 0), where the normal is along (0.6/5, 0.8/10, 0), that is (3, 2, 0). */
  private static final Ellipsoid EGG = new Ellipsoid(O, X, Y, 5, 10, 2, Color.RED);

  @Override
  public Object3D shape(final RandomPlacement at) {
    return new Ellipsoid(at.point(1, -2, 3), at.direction(0, 3, 4), at.direction(1, 0, 0), at.length(2), at.length(0.5f),
        at.length(1), Color.RED);
  }

  /** For i = (0, 0.6, 0.8) and aux = (1, 0, 0): k = (0, 0.8, −0.6), j = k × i = (1, 0, 0). */
  @Override
  public double signedDistance(final double x, final double y, final double z) {
    final double a = (0.6 * (y + 2) + 0.8 * (z - 3)) / 2, b = (x - 1) / 0.5, c = 0.8 * (y + 2) - 0.6 * (z - 3);
    return (a * a + b * b + c * c - 1) / (2 * Math.sqrt(a * a / 4 + b * b / 0.25 + c * c + 1e-9));
  }

  @Override
  public double accuracy() {
    return 1e-9;
  }

  @Test
  void raysAlongTheAxesHitTheirEnds() {
    assertHit(5, new Point3D(-5, 0, 0), new Vector3D(-1, 0, 0), EGG, new Ray(new Point3D(-10, 0, 0), X));
    assertHit(10, new Point3D(0, 10, 0), Y, EGG, new Ray(new Point3D(0, 20, 0), new Vector3D(0, -1, 0)));
    assertHit(1, new Point3D(0, 0, 2), new Vector3D(0, 0, 1), EGG,
        new Ray(new Point3D(0, 0, 3), new Vector3D(0, 0, -1)));
  }

  @Test
  void rayBesideTheCentreHitsAtTheCornerOfTheTriangle345() {
    final Vector3D n = new Vector3D((float) (3 / Math.sqrt(13)), (float) (2 / Math.sqrt(13)), 0);
    assertHit(4, new Point3D(3, 8, 0), n, EGG, new Ray(new Point3D(3, 12, 0), new Vector3D(0, -1, 0)));
    assertHit(7, new Point3D(3, 8, 0), n, EGG, new Ray(new Point3D(10, 8, 0), new Vector3D(-1, 0, 0)));
  }

  @Test
  void rayFromInsideHitsTheFarWallWithTheOutwardNormal() {
    assertHit(5, new Point3D(5, 0, 0), X, EGG, new Ray(O, X));
    assertHit(11, new Point3D(0, -10, 0), new Vector3D(0, -1, 0), EGG,
        new Ray(new Point3D(0, 1, 0), new Vector3D(0, -1, 0)));
  }

  @Test
  void raysBesideOrAwayMiss() {
    assertMiss(EGG, new Ray(new Point3D(5.1f, 20, 0), new Vector3D(0, -1, 0)));
    assertMiss(EGG, new Ray(new Point3D(3.01f, 8, 5), new Vector3D(0, 0, -1)));
    assertMiss(EGG, new Ray(new Point3D(6, 0, 0), X));
    assertMiss(EGG, new Ray(new Point3D(0, 0, 2.5f), new Vector3D(0.1f, 0.2f, 1)));
  }

  @Test
  void rayFromTheSurfaceHitsTheFarWallOrTheStart() {
    final Hit inwards = EGG.intersectionWith(new Ray(new Point3D(5, 0, 0), new Vector3D(-1, 0, 0)));
    final Hit outwards = EGG.intersectionWith(new Ray(new Point3D(5, 0, 0), X));
    assertTrue(Math.abs(inwards.getT() - 10) < 1e-5 || inwards.getT() < 1e-5, inwards::toString);
    assertTrue(!outwards.hits() || outwards.getT() < 1e-5, outwards::toString);
  }

  @Test
  void aSphereIsAnEllipsoidOfEqualRadii() {
    final Object3D sphere = new Sphere(new Point3D(1, 2, 3), 0.7f, Color.RED);
    final Object3D round = new Ellipsoid(new Point3D(1, 2, 3), new Vector3D(1, 2, 3), X, 0.7f, 0.7f, 0.7f, Color.RED);
    final RandomRays rays = Surfaces.ofEllipsoid(new Random(3), new Point3D(1, 2, 3), X, Y, 0.7f, 0.7f, 0.7f);
    Trials.of(2000, random -> {
      final Ray ray = rays.next(RandomRays.Kind.OUTSIDE);
      final Hit expected = sphere.intersectionWith(ray), actual = round.intersectionWith(ray);
      assertEquals(expected.hits(), actual.hits());
      if (expected.hits()) {
        assertEquals(expected.getT(), actual.getT(), 1e-6);
        assertTrue(expected.getNormal().epsilonEquals(actual.getNormal(), 1e-6f));
      }
    });
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 1.5, 5, 20, 1000})
  void hitsAreThoseOfTheQuadratic(final double ratio) {
    Trials.of(8, random -> {
      final float size = (float) Math.scalb(1 + random.nextDouble(), random.nextInt(40) - 20);
      final float[] radii = {size, (float) (size / ratio), (float) (size * Math.pow(ratio, -random.nextDouble()))};
      final float first = radii[0];
      final int place = random.nextInt(3);
      radii[0] = radii[place];
      radii[place] = first;
      final Point3D C = TorusTest.placeNear(random, size);
      final Vector3D i = random.nextInt(3) == 0 ? X : TorusTest.vector(random), aux = TorusTest.vector(random);
      final RandomRays rays = Surfaces.ofEllipsoid(random, C, i, aux, radii);
      final MarchingTrial trial = new MarchingTrial(new Ellipsoid(C, i, aux, radii[0], radii[1], radii[2], Color.RED),
          new EllipsoidOracle(C, i, aux, radii));
      for (final RandomRays.Kind kind : RandomRays.Kind.values()) {
        for (int n = 0; n < 50; n++) {
          trial.ask(rays.next(kind));
        }
      }
      trial.assertExact(2e-8, 1e-5);
    });
  }

  @ParameterizedTest
  @ValueSource(floats = {1e30f, 1e-30f, 1e38f, 1e-38f})
  void sizesAtTheEndsOfTheFloatsWork(final float size) {
    final Ellipsoid egg = new Ellipsoid(O, X, Y, size, 0.5f * size, 0.25f * size, Color.RED);
    assertEquals(size, egg.intersectionWith(new Ray(O, X)).getT(), 1e-6f * size);
    assertEquals(0.5f * size, egg.intersectionWith(new Ray(new Point3D(0, size, 0), new Vector3D(0, -1, 0))).getT(),
        1e-6f * size);
    assertMiss(egg, new Ray(new Point3D(0, size, 0), X));
  }

  @Test
  void theSignedDistanceIsNeverAboveTheDistanceOfAnyPointOfTheSurface() {
    for (final float[] radii : new float[][] {{5, 10, 2}, {1, 20, 1}, {100, 3, 0.1f}, {1, 1, 1}}) {
      final Ellipsoid egg = new Ellipsoid(O, X, Y, radii[0], radii[1], radii[2], Color.RED);
      final RandomRays points = Surfaces.ofEllipsoid(new Random(4), O, X, Y, radii);
      Trials.of(4000, random -> {
        final double far = random.nextInt(3) == 0 ? 10 * random.nextDouble() : random.nextGaussian() * 0.01;
        final double[] s = points.surfacePoint(), closest = points.surfacePoint();
        final Point3D P = new Point3D((float) (s[0] + far * s[3]), (float) (s[1] + far * s[4]), (float) (s[2] + far * s[5]));
        final double sdf = Math.abs(egg.SDF(P));
        assertTrue(sdf <= distance(P, s), () -> egg + ", " + P + ": " + sdf);
        assertTrue(sdf <= distance(P, closest), () -> egg + ", " + P + ": " + sdf);
      });
    }
  }

  private static double distance(final Point3D P, final double[] s) {
    final double x = P.x - s[0], y = P.y - s[1], z = P.z - s[2];
    return Math.sqrt(x * x + y * y + z * z) * (1 + 1e-15);
  }

  @Test
  void theSignedDistanceIsExactOnTheAxesOutsideAndInTheCentre() {
    assertEquals(4, EGG.SDF(new Point3D(9, 0, 0)), 1e-6);
    assertEquals(0.5, EGG.SDF(new Point3D(0, 0, -2.5f)), 1e-6);
    assertEquals(-2, EGG.SDF(O), 1e-6);
    assertEquals(-0.5, EGG.SDF(new Point3D(0, 0, 1.5f)), 1e-6);
  }

  @Test
  void theSignedDistanceApproachesTheDistanceTowardsTheSurface() {
    final RandomRays points = Surfaces.ofEllipsoid(new Random(5), O, X, Y, 5, 10, 2);
    Trials.of(1000, random -> {
      final double[] s = points.surfacePoint();
      final double far = random.nextBoolean() ? 1e-3 : -1e-3;
      final double sdf = EGG.signedDistance(s[0] + far * s[3], s[1] + far * s[4], s[2] + far * s[5]);
      assertEquals(far, sdf, 1e-5);
    });
  }

  @Test
  void noPointIsFartherThanTheUpperBound() {
    final RandomRays points = Surfaces.ofEllipsoid(new Random(6), O, X, Y, 5, 10, 2);
    Trials.of(3000, random -> {
      final Point3D P = new Point3D((float) (9 * random.nextGaussian()), (float) (9 * random.nextGaussian()),
          (float) (9 * random.nextGaussian()));
      assertTrue(distance(P, points.surfacePoint()) <= EGG.distanceUpperBound(P));
    });
    assertEquals(19, EGG.distanceUpperBound(new Point3D(0, 9, 0)), 1e-5);
  }

  /** The point of a hit is brought back onto the surface, which rounding leaves by 1e-12 of its size from afar. */
  @Test
  void hitsFromAfarLieOnTheSurfaceToAllDigits() {
    final RandomNumbers numbers = new RandomNumbers("ellipsoid from afar");
    for (int i = 0; i < 5000; i++) {
      final Vector3D v = numbers.direction();
      v.scale(1e5f);
      final Hit hit = EGG.intersectionWith(new Ray(new Point3D(v.x, v.y, v.z), numbers.pointAbout(O, 1)));
      final double a = hit.pointX() / 5, b = hit.pointY() / 10, c = hit.pointZ() / 2;
      assertEquals(1, a * a + b * b + c * c, 4e-15, () -> hit + ", " + numbers);
    }
  }

  /** Along x the half extent is √((Rx ix)² + (Ry jx)² + (Rz kx)²) with i = (0.6, 0.8, 0), j = (−0.8, 0.6, 0). */
  @Test
  void theBoxIsTight() {
    final BoundingBox box = new Ellipsoid(new Point3D(1, 2, 3), new Vector3D(3, 4, 0), Y, 5, 10, 2, Color.RED)
        .getBoundingBox();
    final float x = (float) Math.sqrt(9 + 64), y = (float) Math.sqrt(16 + 36);
    assertClose(new Point3D(1 - x, 2 - y, 3 - 2), box.getMin());
    assertClose(new Point3D(1 + x, 2 + y, 3 + 2), box.getMax());
  }

  @Test
  void tellsWhatItIs() {
    assertEquals("Ellipsoid(C=(0.0, 0.0, 0.0), Rx=5.0, Ry=10.0, Rz=2.0)", EGG.toString());
  }
}
