package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;

import javax.vecmath.Vector3f;

import org.junit.jupiter.api.Test;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/** What can be inspected from outside: marches, costs, parts. */
class LookingInsideTest {

  private static final Ray ALONG_Z = new Ray(new Point3D(0, 0, 5), new Vector3D(0, 0, -1));

  /** A ray-marched ball, as a student may write one. */
  private static class SphereFunction extends ProceduralObject3D {

    private final List<Double> asked = new ArrayList<>();
    private final float r;

    SphereFunction(final float r) {
      super(Color.RED);
      this.r = r;
    }

    @Override
    protected float SDF(final Point3D P) {
      asked.add(5.0 - P.z);
      return (float) Math.sqrt(P.x * P.x + P.y * P.y + P.z * P.z) - r;
    }

    @Override
    protected float distanceUpperBound(final Point3D P) {
      return (float) Math.sqrt(P.x * P.x + P.y * P.y + P.z * P.z) + r;
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      return rayMarching(ray);
    }
  }

  @Test
  void theStepsOfAMarchAreThoseThatTheObjectMakes() {
    final SphereFunction ball = new SphereFunction(1);
    final double t = ball.intersectionWith(ALONG_Z).getT();
    final List<Double> asked = List.copyOf(ball.asked);
    final SphereTrace march = SphereTrace.of(ball, ALONG_Z).orElseThrow();
    assertEquals(SphereTrace.End.REACHED, march.end());
    assertEquals(t, march.t(), 1e-6);
    assertTrue(march.steps().size() > 1);
    int at = 0;
    for (final SphereTrace.Step step : march.steps()) {
      while (at < asked.size() && Math.abs(asked.get(at) - step.t()) > 1e-5) {
        at++;
      }
      assertTrue(at < asked.size(), "no step at " + step.t());
    }
    assertEquals(march.steps().size(), Cost.of(ball, ALONG_Z));
  }

  /** A longer step than the distance must not carry the march beyond the bound of how far away the object can be. */
  @Test
  void aMarchMeetsWhatLiesJustBeforeItsBound() {
    for (int i = 1; i < 1000; i++) {
      final SphereFunction ball = new SphereFunction(4.99f * i / 1000);
      assertEquals(5 - ball.r, ball.intersectionWith(ALONG_Z).getT(), 1e-5f, "radius " + ball.r);
    }
  }

  @Test
  void aMarchTellsWhyItEnded() {
    final Ray past = new Ray(new Point3D(0, 3, 5), new Vector3D(0, 0, -1));
    assertEquals(SphereTrace.End.PASSED, SphereTrace.of(new SphereFunction(1), past).orElseThrow().end());
    final SphereFunction undefined = new SphereFunction(1) {
      @Override
      protected float SDF(final Point3D P) {
        return Float.NaN;
      }
    };
    assertEquals(SphereTrace.End.UNDEFINED, SphereTrace.of(undefined, ALONG_Z).orElseThrow().end());
    final SphereFunction endless = new SphereFunction(1) {
      @Override
      protected float SDF(final Point3D P) {
        return 1e-5f;
      }

      @Override
      protected float distanceUpperBound(final Point3D P) {
        return Float.POSITIVE_INFINITY;
      }
    };
    assertEquals(SphereTrace.End.GIVEN_UP, SphereTrace.of(endless, ALONG_Z).orElseThrow().end());
    final SphereFunction slow = new SphereFunction(1) {
      @Override
      protected float SDF(final Point3D P) {
        return 1e-5f;
      }

      @Override
      protected float distanceUpperBound(final Point3D P) {
        return 1000;
      }
    };
    assertEquals(SphereTrace.End.GIVEN_UP, SphereTrace.of(slow, ALONG_Z).orElseThrow().end());
    for (final float size : new float[] {0.01f, 100}) {
      final Ray beside = new Ray(new Point3D(0, 3 * size, 5 * size), new Vector3D(0, 0, -1));
      assertEquals(SphereTrace.End.PASSED, SphereTrace.of(new SphereFunction(size), beside).orElseThrow().end());
    }
    assertTrue(SphereTrace.of(new Sphere(new Point3D(), 1, Color.RED), ALONG_Z).isEmpty());
    assertTrue(SphereTrace.of(new SphereFunction(1), Ray.NORAY).isEmpty());
  }

  /** Each step lists the distance of the surface from the point of the ray at its t; none is listed twice. */
  @Test
  void stepsAreDistancesAtPointsOfTheRay() {
    final Torus torus = new Torus(new Point3D(0.1f, 0, 0), new Vector3D(1, 2, 3), 1, 0.3f, Color.RED);
    final RandomNumbers numbers = new RandomNumbers("steps of a march");
    int steps = 0;
    for (int i = 0; i < 200; i++) {
      final Ray ray = new Ray(numbers.pointAbout(new Point3D(), 4), numbers.pointAbout(new Point3D(), 1));
      double last = -1;
      for (final SphereTrace.Step step : SphereTrace.of(torus, ray).orElseThrow().steps()) {
        final double t = step.t();
        assertTrue(last < 0 ? Math.abs(t) < 1e-12 : t != last, () -> ray + ", " + numbers);
        assertEquals(torus.signedDistance(ray.startX() + t * ray.directionX(), ray.startY() + t * ray.directionY(),
            ray.startZ() + t * ray.directionZ()), step.distance(), 1e-12, () -> ray + ", " + numbers);
        last = Math.max(t, 0);
        steps++;
      }
    }
    assertTrue(steps > 200, "steps: " + steps);
  }

  @Test
  void marchesOfTorusAndEllipsoidLeadToTheSameHit() {
    final List<Object3D> objects = List.of(new Torus(new Point3D(0.1f, 0, 0), new Vector3D(1, 2, 3), 1, 0.3f, Color.RED),
        new Ellipsoid(new Point3D(), new Vector3D(1, 1, 0), new Vector3D(0, 1, 0), 2, 0.5f, 1, Color.RED));
    int hits = 0;
    for (final Object3D object : objects) {
      for (int i = 0; i < 400; i++) {
        final Ray ray = new Ray(new Point3D(i % 20 * 0.15f - 1.4f, i / 20 * 0.15f - 1.4f, 5),
            new Vector3D(0.02f, 0.01f, -1));
        final Hit hit = object.intersectionWith(ray);
        final SphereTrace march = SphereTrace.of(object, ray).orElseThrow();
        assertEquals(hit.hits(), march.end() == SphereTrace.End.REACHED, ray::toString);
        if (hit.hits()) {
          assertEquals(hit.getT(), march.t(), 1e-5);
          hits++;
        }
      }
    }
    assertTrue(hits > 100, "hits: " + hits);
  }

  @Test
  void costsAreObjectsAskedAndTrianglesTested() {
    final Group3D group = new Group3D();
    assertEquals(0, Cost.of(group, ALONG_Z));
    group.addObject(new Sphere(new Point3D(), 1, Color.RED));
    group.addObject(new Plane(new Point3D(0, -1, 0), new Vector3D(0, 1, 0), Color.RED));
    assertEquals(2, Cost.of(group, ALONG_Z));
    for (int i = 0; i < 100; i++) {
      group.addObject(new Sphere(new Point3D(9 + 3 * i, 0, 0), 1, Color.RED));
    }
    assertTrue(Cost.of(group, ALONG_Z) <= 3);
    final TriangularMesh mesh = TriangularMesh.of(new float[] {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0},
        new int[] {0, 1, 2, 0, 2, 3}, Color.RED);
    assertEquals(2, Cost.of(mesh, ALONG_Z));
    assertEquals(2, Cost.of(new AffineTransformation(new Vector3f(1, 1, 1), mesh), ALONG_Z));
    assertEquals(0, Cost.of(mesh, Ray.NORAY));
  }

  @Test
  void aTransformationTakesRaysThereAndHitsBack() {
    final Sphere sphere = new Sphere(new Point3D(), 1, Color.RED);
    final AffineTransformation moved = new AffineTransformation(new Vector3f(1, 3, 2), new Vector3f(0, 1, 0), 30,
        new Vector3f(0.1f, 0.2f, 0.3f), sphere);
    final Hit hit = moved.intersectionWith(ALONG_Z), back = moved.hitToScene(ALONG_Z,
        sphere.intersectionWith(moved.rayToObject(ALONG_Z)));
    assertTrue(hit.hits());
    assertEquals(hit.getT(), back.getT(), 1e-6f);
    assertTrue(hit.getPoint().epsilonEquals(back.getPoint(), 1e-5f));
    assertTrue(hit.getNormal().epsilonEquals(back.getNormal(), 1e-5f));
    assertFalse(moved.hitToScene(ALONG_Z, Hit.NOHIT).hits());
    assertEquals(Ray.NORAY, moved.rayToObject(Ray.NORAY));
    assertEquals(sphere, moved.getObject());
  }
}
