package models;

import static models.HitAssertions.assertHit;
import static models.HitAssertions.assertMiss;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.math.BigDecimal;

import org.junit.jupiter.api.Test;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

class SphereTest implements Object3DContract {

  private static final Sphere SPHERE = new Sphere(new Point3D(0, 0, 0), 5, Color.RED);

  @Override
  public Object3D shape(final RandomPlacement at) {
    return new Sphere(at.point(1, -2, 3), at.length(2.5f), Color.RED);
  }

  @Override
  public double signedDistance(final double x, final double y, final double z) {
    return Math.sqrt((x - 1) * (x - 1) + (y + 2) * (y + 2) + (z - 3) * (z - 3)) - 2.5;
  }

  @Override
  public double accuracy() {
    return 1e-13;
  }

  @Test
  void rayBesideTheCentreHitsAtTheCornerOfTheTriangle345() {
    assertHit(6, new Point3D(-4, 3, 0), new Vector3D(-0.8f, 0.6f, 0), SPHERE,
        new Ray(new Point3D(-10, 3, 0), new Vector3D(1, 0, 0)));
    assertHit(7, new Point3D(0, 4, 3), new Vector3D(0, 0.8f, 0.6f), SPHERE,
        new Ray(new Point3D(0, 4, 10), new Vector3D(0, 0, -2)));
  }

  @Test
  void rayFromInsideHitsTheFarWallWithTheOutwardNormal() {
    assertHit(4, new Point3D(4, 3, 0), new Vector3D(0.8f, 0.6f, 0), SPHERE,
        new Ray(new Point3D(0, 3, 0), new Vector3D(1, 0, 0)));
    assertHit(5, new Point3D(0, 0, -5), new Vector3D(0, 0, -1), SPHERE,
        new Ray(new Point3D(0, 0, 0), new Vector3D(0, 0, -1)));
  }

  @Test
  void sphereBehindTheRayIsMissed() {
    assertMiss(SPHERE, new Ray(new Point3D(6, 0, 0), new Vector3D(1, 0, 0)));
    assertMiss(SPHERE, new Ray(new Point3D(0, -5.5f, 1), new Vector3D(0, -1, 0)));
  }

  @Test
  void rayBesideTheSphereMisses() {
    assertMiss(SPHERE, new Ray(new Point3D(-10, Math.nextUp(5f), 0), new Vector3D(1, 0, 0)));
    assertMiss(SPHERE, new Ray(new Point3D(-10, 4, 4), new Vector3D(1, 0, 0)));
  }

  @Test
  void tangentRayTouchesAtOnePointIfAtAll() {
    final Ray tangent = new Ray(new Point3D(-10, 5, 0), new Vector3D(1, 0, 0));
    if (SPHERE.intersectionWith(tangent).hits()) {
      assertHit(10, new Point3D(0, 5, 0), new Vector3D(0, 1, 0), SPHERE, tangent);
    }
    final Hit justInside = SPHERE.intersectionWith(new Ray(new Point3D(-10, Math.nextDown(5f), 0), new Vector3D(1, 0, 0)));
    assertEquals(10, justInside.getT(), 0.003);
  }

  @Test
  void rayThatStartsOnTheSurfaceInwardsMeetsTheFarWall() {
    final Hit hit = SPHERE.intersectionWith(new Ray(new Point3D(-3, 4, 0), new Vector3D(1, 0, 0)));
    assertTrue(hit.getT() < 1e-6 || Math.abs(hit.getT() - 6) < 1e-6, hit.toString());
  }

  @Test
  void rayThatStartsOnTheSurfaceOutwardsMeetsNothingFarAway() {
    final Hit hit = SPHERE.intersectionWith(new Ray(new Point3D(3, 4, 0), new Vector3D(1, 0, 0)));
    assertTrue(!hit.hits() || hit.getT() < 1e-6, hit.toString());
  }

  @Test
  void unitSphereSeenFrom10000AwayIsAsExactAsAFloatCanBe() {
    final Sphere unit = new Sphere(new Point3D(), 1, Color.RED);
    for (int i = 0; i < 10; i++) {
      final float y = i * 0.1f;
      final Hit hit = unit.intersectionWith(new Ray(new Point3D(-10000, y, 0), new Vector3D(1, 0, 0)));
      assertEquals(10000 - Math.sqrt(1 - (double) y * y), hit.pointX() + 10000, 1e-11);
      assertEquals(y, hit.normalY(), 1e-7);
    }
  }

  @Test
  void agreesWithExactArithmeticUpToTenMillionRadiiAway() {
    final ExactTrial trial = new ExactTrial("exact sphere");
    for (int k = 0; k < 40; k++) {
      final float r = trial.numbers().magnitude(-20, 20);
      final Point3D C = trial.numbers().pointAbout(new Point3D(), r * trial.numbers().magnitude(-3, 3));
      final ExactVector centre = ExactVector.of(C);
      trial.ask(new Sphere(C, r, Color.RED), C, 1.3 * r, RandomNumbers.times(60),
          line -> ExactSpan.ball(line, centre, new BigDecimal(r)));
    }
    trial.assertCounts(1200, 400, 24);
  }

  /** The radius is chosen to be a little more or less than the distance of the centre from the ray, known to 50 digits. */
  @Test
  void raysThatJustHitOrJustMissAFarSphereAreToldApart() {
    final RandomNumbers numbers = new RandomNumbers("just hit or miss");
    for (int i = 0; i < RandomNumbers.times(400); i++) {
      final float size = numbers.magnitude(-20, 20);
      final Point3D C = numbers.pointAbout(new Point3D(), size), R = numbers.pointAbout(C, size * numbers.magnitude(3, 21));
      final Ray ray = new Ray(R, numbers.pointAbout(C, size));
      final ExactSpan.Line line = ExactSpan.Line.of(ray);
      final double p = line.direction().cross(ExactVector.of(C).minus(line.start())).length().doubleValue();
      final boolean hits = i % 2 == 0;
      final float r = (float) (p * (1 + (hits ? 1 : -1) * numbers.magnitude(-18, -6)));
      if (R.distance(C) < 1e7 * r && R.distance(C) > 2 * r) {
        assertEquals(hits, new Sphere(C, r, Color.RED).intersectionWith(ray).hits(), () -> C + ", " + r + ", " + ray + ", "
            + numbers);
      }
    }
  }

  @Test
  void hugeAndTinySpheresAreHit() {
    for (final float r : new float[] {1e-30f, 1e-15f, 1e15f, 1e30f}) {
      assertHit(2 * (double) r, new Point3D(-r, 0, 0), new Vector3D(-1, 0, 0), new Sphere(new Point3D(), r, Color.RED),
          new Ray(new Point3D(-3 * r, 0, 0), new Vector3D(1, 0, 0)));
    }
  }

  @Test
  void textTellsCentreAndRadius() {
    assertEquals("Sphere(C=(0.0, 0.0, 0.0), r=5.0)", SPHERE.toString());
  }
}
