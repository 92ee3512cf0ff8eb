package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.lang.reflect.Modifier;
import java.time.Duration;
import java.util.Random;
import java.util.function.ToDoubleFunction;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;
import trials.Trials;

class ProceduralObject3DTest {

  private static final Point3D O = new Point3D(0, 0, 0);
  private static final Vector3D Y = new Vector3D(0, 1, 0);

  /** What a student writes: the three methods of the assignment, in floats, and nothing else. */
  private static final class Procedural extends ProceduralObject3D {

    private final ToDoubleFunction<Point3D> distance;
    private final float reach;
    private int asked;

    Procedural(final float reach, final ToDoubleFunction<Point3D> distance) {
      super(Color.RED);
      this.reach = reach;
      this.distance = distance;
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      return rayMarching(ray);
    }

    @Override
    protected float SDF(final Point3D P) {
      asked++;
      return (float) distance.applyAsDouble(P);
    }

    @Override
    protected float distanceUpperBound(final Point3D P) {
      return P.distance(O) + reach;
    }
  }

  /** A torus marched by nothing but its distance, which is in doubles. */
  private static final class InDoubles extends ProceduralObject3D {

    private final Torus torus;

    InDoubles(final Torus torus) {
      super(Color.RED);
      this.torus = torus;
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      return rayMarching(ray);
    }

    @Override
    double signedDistance(final double x, final double y, final double z) {
      return torus.signedDistance(x, y, z);
    }

    @Override
    protected float SDF(final Point3D P) {
      return torus.SDF(P);
    }

    @Override
    protected float distanceUpperBound(final Point3D P) {
      return torus.distanceUpperBound(P);
    }
  }

  private static Procedural torus(final float R, final float r) {
    return new Procedural(R + r, P -> {
      final float across = (float) Math.sqrt(P.x * P.x + P.z * P.z) - R;
      return (float) Math.sqrt(across * across + P.y * P.y) - r;
    });
  }

  /** Distance to a cube of side 2, exact; its faces are flat, so that rays can follow them at any distance. */
  private static float cube(final Point3D P) {
    final float x = Math.abs(P.x) - 1, y = Math.abs(P.y) - 1, z = Math.abs(P.z) - 1;
    final float ox = Math.max(x, 0), oy = Math.max(y, 0), oz = Math.max(z, 0);
    return (float) Math.sqrt(ox * ox + oy * oy + oz * oz) + Math.min(0, Math.max(x, Math.max(y, z)));
  }

  @Test
  void isConfinedAndAsksForWhatTheAssignmentSays() throws ReflectiveOperationException {
    final int modifiers = ProceduralObject3D.class.getModifiers();
    assertTrue(Modifier.isAbstract(modifiers));
    assertFalse(Modifier.isPublic(modifiers));
    for (final String name : new String[] {"SDF", "distanceUpperBound"}) {
      final int method = ProceduralObject3D.class.getDeclaredMethod(name, Point3D.class).getModifiers();
      assertTrue(Modifier.isAbstract(method) && Modifier.isProtected(method), name);
    }
    assertTrue(Modifier.isProtected(ProceduralObject3D.class.getDeclaredMethod("rayMarching", Ray.class).getModifiers()));
  }

  @ParameterizedTest
  @ValueSource(floats = {0.35f, 0.02f, 0.9f, 2})
  void marchByFloatsFindsWhatTheTorusFinds(final float r) {
    final Object3D marched = torus(1, r);
    final CrossingOracle oracle = new TorusOracle(O, Y, 1, r);
    final RandomRays rays = Surfaces.ofTorus(new Random(7), O, Y, 1, r);
    final int[] hits = {0};
    Trials.of(1500, random -> {
      final Ray ray = rays.next(random.nextBoolean() ? RandomRays.Kind.AT_SURFACE : RandomRays.Kind.OUTSIDE);
      final Hit hit = marched.intersectionWith(ray);
      final double t = oracle.firstCertain(ray, 1e-5 * (1 + r));
      assertTrue(hit.getT() <= t + 1e-4 * (1 + r), () -> ray + ": passes " + t + ", " + hit);
      if (hit.hits()) {
        hits[0]++;
        assertEquals(0, oracle.distanceAt(ray, hit.getT()), 1e-5 * (1 + r), () -> ray + ": " + hit);
        final double[] n = oracle.normal(hit.pointX(), hit.pointY(), hit.pointZ());
        final double cos = n[0] * hit.normalX() + n[1] * hit.normalY() + n[2] * hit.normalZ();
        assertTrue(cos > 0.999 || !oracle.isSmooth(hit.pointX(), hit.pointY(), hit.pointZ()), () -> ray + ": " + hit);
      }
    });
    assertTrue(hits[0] > 700, () -> "only " + hits[0] + " hits");
  }

  @Test
  void raysOfEveryKindAreMarchedToTheSameCrossings() {
    final Object3D marched = torus(1, 0.35f);
    final CrossingOracle oracle = new TorusOracle(O, Y, 1, 0.35f);
    final RandomRays rays = Surfaces.ofTorus(new Random(8), O, Y, 1, 0.35f);
    for (final RandomRays.Kind kind : RandomRays.Kind.values()) {
      Trials.of(kind.name().startsWith("FAR") ? 0 : 150, random -> {
        final Ray ray = rays.next(kind);
        final double t = oracle.firstCertain(ray, 4e-5), found = marched.intersectionWith(ray).getT();
        assertTrue(found <= t + 3e-4, () -> kind + ", " + ray + ": passes " + t + " to " + found);
        assertTrue(found == Float.POSITIVE_INFINITY || Math.abs(oracle.distanceAt(ray, found)) < 4e-5,
            () -> kind + ", " + ray + ": " + found + " is not on the surface");
      });
    }
  }

  @Test
  void doublesInsteadOfFloatsMakeTheMarchAsExactAsTheFormula() {
    final Torus torus = new Torus(new Point3D(1e4f, 2e4f, -3e4f), Y, 1, 0.3f, Color.RED);
    final CrossingOracle oracle = new TorusOracle(new Point3D(1e4f, 2e4f, -3e4f), Y, 1, 0.3f);
    final RandomRays rays = Surfaces.ofTorus(new Random(9), new Point3D(1e4f, 2e4f, -3e4f), Y, 1, 0.3f);
    final ProceduralObject3D marched = new InDoubles(torus);
    Trials.of(500, random -> {
      final Ray ray = rays.next(RandomRays.Kind.AT_SURFACE);
      final double t = marched.march(ray.startX(), ray.startY(), ray.startZ(),
          ray.directionX(), ray.directionY(), ray.directionZ());
      assertTrue(t <= oracle.firstCertain(ray, 1e-5) + 1e-9, () -> ray + ": passes the crossing to " + t);
      assertTrue(t == Double.POSITIVE_INFINITY || Math.abs(oracle.distanceAt(ray, t)) < 1e-10, () -> ray + ": " + t);
    });
  }

  @Test
  void aBoundOfTheDistanceWillDo() {
    final Object3D loose = new Procedural(1, P -> 0.1f * (P.distance(O) - 1)), exact = new Sphere(O, 1, Color.RED);
    final RandomRays rays = Surfaces.ofEllipsoid(new Random(10), O, Y, new Vector3D(1, 0, 0), 1, 1, 1);
    Trials.of(500, random -> {
      final Ray ray = rays.next(RandomRays.Kind.AT_SURFACE);
      final Hit expected = exact.intersectionWith(ray), actual = loose.intersectionWith(ray);
      final double p = Math.abs(expected.getNormal().dot(ray.getDirection()));
      if (p > 0.05) {
        assertEquals(expected.getT(), actual.getT(), 1e-5 / p, () -> ray + ": " + actual);
      }
    });
  }

  @Test
  void aRayThatFollowsAFlatFaceComesToAnEnd() {
    final Procedural cube = new Procedural(2, ProceduralObject3DTest::cube);
    assertTimeoutPreemptively(Duration.ofSeconds(20), () -> {
      for (final float above : new float[] {0, 1e-7f, 1e-6f, 1e-5f, 3e-5f, 1e-4f, 1e-3f, -1e-7f, -1e-5f, -1e-3f}) {
        final Hit hit = cube.intersectionWith(new Ray(new Point3D(-3, 1 + above, 0.2f), new Vector3D(1, 0, 0)));
        assertTrue(cube.asked < 100_000, () -> above + ": asked " + cube.asked + " times");
        assertTrue(Math.abs(above) < 1e-4 || hit.hits() == above < 0, () -> above + ": " + hit);
        assertTrue(!hit.hits() || Math.abs(cube(hit.getPoint())) < 1e-4, () -> above + ": " + hit);
      }
    });
  }

  @Test
  void aRayFromInsideTheCubeHitsTheFarFace() {
    final Object3D cube = new Procedural(2, ProceduralObject3DTest::cube);
    final Hit hit = cube.intersectionWith(new Ray(new Point3D(0.3f, 0.2f, 0.1f), new Vector3D(1, 0, 0)));
    assertEquals(0.7, hit.getT(), 1e-5);
    assertEquals(1, hit.getNormal().x, 1e-3);
    assertSame(cube, hit.getObject());
  }

  @Test
  void aRayFromTheFaceInwardsHitsTheFarFaceAndOneOutwardsNothing() {
    final Object3D cube = new Procedural(2, ProceduralObject3DTest::cube);
    assertEquals(2, cube.intersectionWith(new Ray(new Point3D(1, 0, 0), new Vector3D(-1, 0, 0))).getT(), 1e-5);
    assertSame(Hit.NOHIT, cube.intersectionWith(new Ray(new Point3D(1, 0, 0), new Vector3D(1, 0, 0))));
  }

  @Test
  void anObjectWithoutEndIsMarchedToAndPassedInTime() {
    final Object3D plane = new Procedural(Float.POSITIVE_INFINITY, P -> P.y);
    assertTimeoutPreemptively(Duration.ofSeconds(20), () -> {
      assertEquals(5, plane.intersectionWith(new Ray(new Point3D(0, 3, 0), new Vector3D(4, -3, 0))).getT(), 1e-4);
      assertSame(Hit.NOHIT, plane.intersectionWith(new Ray(new Point3D(0, 3, 0), Y)));
      assertSame(Hit.NOHIT, plane.intersectionWith(new Ray(new Point3D(0, 3, 0), new Vector3D(1, 0, 0))));
    });
  }

  @Test
  void aDistanceThatIsNoNumberEndsTheMarch() {
    final Object3D broken = new Procedural(1, P -> P.x > 0.5f ? Float.NaN : 1);
    assertTimeoutPreemptively(Duration.ofSeconds(20), () -> {
      assertSame(Hit.NOHIT, broken.intersectionWith(new Ray(O, new Vector3D(1, 0, 0))));
      assertSame(Hit.NOHIT, broken.intersectionWith(new Ray(new Point3D(1, 0, 0), new Vector3D(1, 0, 0))));
      assertSame(Hit.NOHIT, broken.intersectionWith(Ray.NORAY));
    });
  }

  @Test
  void lengthsTimesAPowerOfTwoGiveTheSameMarch() {
    final Object3D small = torus(1, 0.35f), large = torus(0x1p20f, 0x1p20f * 0.35f);
    final RandomRays rays = Surfaces.ofTorus(new Random(11), O, Y, 1, 0.35f);
    Trials.of(300, random -> {
      final Ray ray = rays.next(RandomRays.Kind.AT_SURFACE);
      final Ray scaled = Ray.exactly(0x1p20 * ray.startX(), 0x1p20 * ray.startY(), 0x1p20 * ray.startZ(),
          ray.directionX(), ray.directionY(), ray.directionZ());
      assertEquals(0x1p20f * small.intersectionWith(ray).getT(), large.intersectionWith(scaled).getT(), ray::toString);
    });
  }

  @Test
  void rejectsNoRayAtAll() {
    assertThrows(IllegalArgumentException.class, () -> torus(1, 0.3f).intersectionWith(null));
    assertThrows(IllegalArgumentException.class, () -> new Torus(O, Y, 2, 1, Color.RED).SDF(null));
    assertThrows(IllegalArgumentException.class, () -> new Torus(O, Y, 2, 1, Color.RED).distanceUpperBound(null));
    final Ellipsoid egg = new Ellipsoid(O, Y, new Vector3D(1, 0, 0), 2, 1, 1, Color.RED);
    assertThrows(IllegalArgumentException.class, () -> egg.SDF(null));
    assertThrows(IllegalArgumentException.class, () -> egg.distanceUpperBound(null));
  }

  @Test
  void roundsBoundsToTheSafeSide() {
    final double third = 1 / 3.0;
    assertTrue(ProceduralObject3D.roundedDown(third) <= third && ProceduralObject3D.roundedUp(third) >= third);
    assertEquals(0.25f, ProceduralObject3D.roundedDown(0.25));
    assertEquals(0.25f, ProceduralObject3D.roundedUp(0.25));
    assertEquals(Float.MAX_VALUE, ProceduralObject3D.roundedDown(1e300));
    assertEquals(Float.POSITIVE_INFINITY, ProceduralObject3D.roundedUp(1e300));
  }
}
