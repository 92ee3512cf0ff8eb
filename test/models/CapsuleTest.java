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

class CapsuleTest implements Object3DContract {

  /** Radius 5 about the segment from (0, −3, 0) to (0, 3, 0). */
  private static final Capsule UPRIGHT = new Capsule(new Point3D(), new Vector3D(0, 2, 0), 5, 6, Color.RED);

  @Override
  public Object3D shape(final RandomPlacement at) {
    return new Capsule(at.point(-1, 0.5, 2), at.direction(2, -1, 2), at.length(1.25f), at.length(3), Color.RED);
  }

  @Override
  public double signedDistance(final double x, final double y, final double z) {
    final double px = x + 1, py = y - 0.5, pz = z - 2, s = Math.max(-1.5, Math.min(1.5, (2 * px - py + 2 * pz) / 3));
    return Math.sqrt(Math.pow(px - s * 2 / 3, 2) + Math.pow(py + s / 3, 2) + Math.pow(pz - s * 2 / 3, 2)) - 1.25;
  }

  @Override
  public double accuracy() {
    return 1e-12;
  }

  @Test
  void rayBesideTheAxisHitsTheSideAtTheCornerOfTheTriangle345() {
    assertHit(6, new Point3D(-4, 1, 3), new Vector3D(-0.8f, 0, 0.6f), UPRIGHT,
        new Ray(new Point3D(-10, 1, 3), new Vector3D(1, 0, 0)));
  }

  @Test
  void rayBeyondTheSegmentHitsAHemisphereAtTheCornerOfTheTriangle345() {
    assertHit(6, new Point3D(-4, 6, 0), new Vector3D(-0.8f, 0.6f, 0), UPRIGHT,
        new Ray(new Point3D(-10, 6, 0), new Vector3D(1, 0, 0)));
    assertHit(6, new Point3D(-4, -6, 0), new Vector3D(-0.8f, -0.6f, 0), UPRIGHT,
        new Ray(new Point3D(-10, -6, 0), new Vector3D(1, 0, 0)));
  }

  @Test
  void raysAlongTheAxisHitTheHemispheres() {
    assertHit(2, new Point3D(0, 8, 0), new Vector3D(0, 1, 0), UPRIGHT,
        new Ray(new Point3D(0, 10, 0), new Vector3D(0, -1, 0)));
    assertHit(3, new Point3D(3, -7, 0), new Vector3D(0.6f, -0.8f, 0), UPRIGHT,
        new Ray(new Point3D(3, -10, 0), new Vector3D(0, 1, 0)));
  }

  @Test
  void raysFromInsideHitTheFarWall() {
    assertHit(4, new Point3D(4, 0, 3), new Vector3D(0.8f, 0, 0.6f), UPRIGHT,
        new Ray(new Point3D(0, 0, 3), new Vector3D(1, 0, 0)));
    assertHit(8, new Point3D(0, 8, 0), new Vector3D(0, 1, 0), UPRIGHT, new Ray(new Point3D(), new Vector3D(0, 1, 0)));
    assertHit(12, new Point3D(4, -6, 0), new Vector3D(0.8f, -0.6f, 0), UPRIGHT,
        new Ray(new Point3D(4, 6, 0), new Vector3D(0, -1, 0)));
  }

  @Test
  void raysBesideItMiss() {
    assertMiss(UPRIGHT, new Ray(new Point3D(-10, 0, Math.nextUp(5f)), new Vector3D(1, 0, 0)));
    assertMiss(UPRIGHT, new Ray(new Point3D(-10, Math.nextUp(8f), 0), new Vector3D(1, 0, 0)));
    assertMiss(UPRIGHT, new Ray(new Point3D(4, 10, 4), new Vector3D(0, -1, 0)));
    assertMiss(UPRIGHT, new Ray(new Point3D(-10, 7, 4), new Vector3D(1, 0, 0)));
  }

  @Test
  void capsuleBehindTheRayIsMissed() {
    assertMiss(UPRIGHT, new Ray(new Point3D(6, 0, 0), new Vector3D(1, 0, 0)));
    assertMiss(UPRIGHT, new Ray(new Point3D(0, 9, 0), new Vector3D(0, 1, 0)));
    assertMiss(UPRIGHT, new Ray(new Point3D(4.5f, 7.5f, 0), new Vector3D(1, 1, 0)));
  }

  @Test
  void tangentRaysTouchAtOnePointIfAtAll() {
    final Ray side = new Ray(new Point3D(-10, 1, 5), new Vector3D(1, 0, 0));
    if (UPRIGHT.intersectionWith(side).hits()) {
      assertHit(10, new Point3D(0, 1, 5), new Vector3D(0, 0, 1), UPRIGHT, side);
    }
    final Ray top = new Ray(new Point3D(-10, 8, 0), new Vector3D(1, 0, 0));
    if (UPRIGHT.intersectionWith(top).hits()) {
      assertHit(10, new Point3D(0, 8, 0), new Vector3D(0, 1, 0), UPRIGHT, top);
    }
  }

  @Test
  void raysAtTheSeamHitWithTheNormalOfTheSide() {
    assertHit(5, new Point3D(5, 3, 0), new Vector3D(1, 0, 0), UPRIGHT,
        new Ray(new Point3D(10, 3, 0), new Vector3D(-1, 0, 0)));
    assertHit(5, new Point3D(-5, -3, 0), new Vector3D(-1, 0, 0), UPRIGHT,
        new Ray(new Point3D(-8, 1, 0), new Vector3D(3, -4, 0)));
  }

  @Test
  void rayAlongTheSideTouchesItOrMisses() {
    final Hit hit = UPRIGHT.intersectionWith(new Ray(new Point3D(3, 20, 4), new Vector3D(0, -1, 0)));
    assertTrue(!hit.hits() || Math.abs(hit.getT() - 17) < 1e-3, hit.toString());
  }

  @Test
  void agreesWithExactArithmeticUpToTenMillionSizesAway() {
    final ExactTrial trial = new ExactTrial("exact capsule");
    final RandomNumbers numbers = trial.numbers();
    for (int k = 0; k < 40; k++) {
      final float r = numbers.magnitude(-20, 20), l = r * numbers.magnitude(-3, 3);
      final Point3D P = numbers.pointAbout(new Point3D(), r * numbers.magnitude(-3, 3));
      final Vector3D u = numbers.direction();
      u.scale(numbers.magnitude(-10, 10));
      final ExactVector p = ExactVector.of(P), axis = ExactVector.of(u).normalised();
      final BigDecimal radius = new BigDecimal(r), half = new BigDecimal(l * 0.5);
      final ExactVector top = p.plus(axis.times(half)), bottom = p.minus(axis.times(half));
      trial.ask(new Capsule(P, u, r, l, Color.RED), P, 1.2 * (r + l / 2), RandomNumbers.times(60),
          line -> ExactSpan.cylinder(line, p, axis, radius).and(ExactSpan.slab(line, p, axis, half), r + l)
              .or(ExactSpan.ball(line, top, radius)).or(ExactSpan.ball(line, bottom, radius)));
    }
    trial.assertCounts(450, 450, 24);
  }

  @Test
  void boxIsThatOfTheTwoBalls() {
    assertEquals("BoundingBox((-5.0000005, -8.000001, -5.0000005), (5.0000005, 8.000001, 5.0000005))",
        UPRIGHT.getBoundingBox().toString());
    final Capsule slanting = new Capsule(new Point3D(), new Vector3D(0, 3, 4), 5, 10, Color.RED);
    assertEquals(5 + 3, slanting.getBoundingBox().maxY(), 1e-5);
    assertEquals(5 + 4, slanting.getBoundingBox().maxZ(), 1e-5);
  }

  @Test
  void textTellsAxisRadiusAndLength() {
    assertEquals("Capsule(P=(0.0, 0.0, 0.0), u=(0.0, 1.0, 0.0), r=5.0, l=6.0)", UPRIGHT.toString());
  }
}
