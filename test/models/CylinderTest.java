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

class CylinderTest implements Object3DContract {

  /** Radius 5 about the z axis, from z = −2 to z = 2. */
  private static final Cylinder UPRIGHT = new Cylinder(new Point3D(), new Vector3D(0, 0, 7), 5, 4, Color.RED);

  @Override
  public Object3D shape(final RandomPlacement at) {
    return new Cylinder(at.point(1, 1, -0.5), at.direction(1, 2, 2), at.length(1.5f), at.length(4), Color.RED);
  }

  @Override
  public double signedDistance(final double x, final double y, final double z) {
    final double px = x - 1, py = y - 1, pz = z + 0.5, s = (px + 2 * py + 2 * pz) / 3;
    final double a = Math.sqrt(Math.max(0, px * px + py * py + pz * pz - s * s)) - 1.5, b = Math.abs(s) - 2;
    return Math.min(Math.max(a, b), 0) + Math.hypot(Math.max(a, 0), Math.max(b, 0));
  }

  @Override
  public double accuracy() {
    return 1e-12;
  }

  @Test
  void rayBesideTheAxisHitsTheSideAtTheCornerOfTheTriangle345() {
    assertHit(6, new Point3D(-4, 3, 1), new Vector3D(-0.8f, 0.6f, 0), UPRIGHT,
        new Ray(new Point3D(-10, 3, 1), new Vector3D(1, 0, 0)));
  }

  @Test
  void slantingRayHitsTheSideWhereTheTriangle345Ends() {
    assertHit(5, new Point3D(0, 5, 1), new Vector3D(0, 1, 0), UPRIGHT,
        new Ray(new Point3D(0, 9, 4), new Vector3D(0, -4, -3)));
  }

  @Test
  void raysAlongTheAxisHitTheDiscs() {
    assertHit(8, new Point3D(3, -3, 2), new Vector3D(0, 0, 1), UPRIGHT,
        new Ray(new Point3D(3, -3, 10), new Vector3D(0, 0, -1)));
    assertHit(1, new Point3D(0, 0, -2), new Vector3D(0, 0, -1), UPRIGHT,
        new Ray(new Point3D(0, 0, -3), new Vector3D(0, 0, 1)));
  }

  @Test
  void slantingRayHitsADisc() {
    assertHit(5, new Point3D(4, 0, 2), new Vector3D(0, 0, 1), UPRIGHT,
        new Ray(new Point3D(0, 0, 5), new Vector3D(4, 0, -3)));
  }

  @Test
  void raysFromInsideHitTheFarWall() {
    assertHit(4, new Point3D(4, 3, 0), new Vector3D(0.8f, 0.6f, 0), UPRIGHT,
        new Ray(new Point3D(0, 3, 0), new Vector3D(1, 0, 0)));
    assertHit(3, new Point3D(1, 1, 2), new Vector3D(0, 0, 1), UPRIGHT,
        new Ray(new Point3D(1, 1, -1), new Vector3D(0, 0, 1)));
    assertHit(1, new Point3D(1, 1, -2), new Vector3D(0, 0, -1), UPRIGHT,
        new Ray(new Point3D(1, 1, -1), new Vector3D(0, 0, -1)));
  }

  @Test
  void raysBesideItMiss() {
    assertMiss(UPRIGHT, new Ray(new Point3D(-10, Math.nextUp(5f), 0), new Vector3D(1, 0, 0)));
    assertMiss(UPRIGHT, new Ray(new Point3D(-10, 0, Math.nextUp(2f)), new Vector3D(1, 0, 0)));
    assertMiss(UPRIGHT, new Ray(new Point3D(4, 4, 10), new Vector3D(0, 0, -1)));
    assertMiss(UPRIGHT, new Ray(new Point3D(0, -6, 3), new Vector3D(0, 1, 1)));
  }

  @Test
  void cylinderBehindTheRayIsMissed() {
    assertMiss(UPRIGHT, new Ray(new Point3D(6, 0, 0), new Vector3D(1, 0, 0)));
    assertMiss(UPRIGHT, new Ray(new Point3D(0, 0, 3), new Vector3D(0, 0, 1)));
  }

  @Test
  void tangentRaysTouchAtOnePointIfAtAll() {
    final Ray side = new Ray(new Point3D(-10, 5, 0), new Vector3D(1, 0, 0));
    if (UPRIGHT.intersectionWith(side).hits()) {
      assertHit(10, new Point3D(0, 5, 0), new Vector3D(0, 1, 0), UPRIGHT, side);
    }
    final Hit alongDisc = UPRIGHT.intersectionWith(new Ray(new Point3D(-10, 0, 2), new Vector3D(1, 0, 0)));
    assertTrue(!alongDisc.hits() || Math.abs(alongDisc.getT() - 5) < 1e-6, alongDisc.toString());
    final Hit alongSide = UPRIGHT.intersectionWith(new Ray(new Point3D(3, 4, 9), new Vector3D(0, 0, -1)));
    assertTrue(!alongSide.hits() || Math.abs(alongSide.getT() - 7) < 1e-6, alongSide.toString());
  }

  @Test
  void rayAtTheRimHitsItOrMisses() {
    final Hit hit = UPRIGHT.intersectionWith(new Ray(new Point3D(5, 0, 9), new Vector3D(0, 0, -1)));
    assertTrue(!hit.hits() || hit.getT() == 7 && hit.getPoint().equals(new Point3D(5, 0, 2)), hit.toString());
    assertHit(Math.sqrt(2), new Point3D(4.5f, 0, 2), new Vector3D(0, 0, 1), UPRIGHT,
        new Ray(new Point3D(5.5f, 0, 3), new Vector3D(-1, 0, -1)));
    assertHit(1.5 * Math.sqrt(2), new Point3D(5, 0, 1.5f), new Vector3D(1, 0, 0), UPRIGHT,
        new Ray(new Point3D(6.5f, 0, 3), new Vector3D(-1, 0, -1)));
  }

  @Test
  void flatDiscIsMetOnTheSideThatTheRayComesFrom() {
    for (final float l : new float[] {1e-30f, 1e-20f, 1e-16f, 1e-9f}) {
      final Cylinder disc = new Cylinder(new Point3D(0, 0, 1), new Vector3D(0, 0, 1), 1, l, Color.RED);
      for (int i = 0; i < 50; i++) {
        final float x = i * 0.019f;
        assertHit(4 * Math.sqrt(1.01), new Point3D(x, 0, 1), new Vector3D(0, 0, 1), disc,
            new Ray(new Point3D(x - 0.4f, 0, 5), new Vector3D(0.1f, 0, -1)));
        assertHit(6 * Math.sqrt(1.01), new Point3D(x, 0, 1), new Vector3D(0, 0, -1), disc,
            new Ray(new Point3D(x - 0.6f, 0, -5), new Vector3D(0.1f, 0, 1)));
      }
    }
  }

  @Test
  void agreesWithExactArithmeticUpToTenMillionSizesAway() {
    final ExactTrial trial = new ExactTrial("exact cylinder");
    final RandomNumbers numbers = trial.numbers();
    for (int k = 0; k < 40; k++) {
      final float r = numbers.magnitude(-20, 20), l = r * numbers.magnitude(-3, 3);
      final Point3D P = numbers.pointAbout(new Point3D(), r * numbers.magnitude(-3, 3));
      final Vector3D u = numbers.direction();
      u.scale(numbers.magnitude(-10, 10));
      final ExactVector p = ExactVector.of(P), axis = ExactVector.of(u).normalised();
      final BigDecimal half = new BigDecimal(l * 0.5);
      trial.ask(new Cylinder(P, u, r, l, Color.RED), P, 1.2 * Math.max(r, l / 2), RandomNumbers.times(60),
          line -> ExactSpan.cylinder(line, p, axis, new BigDecimal(r)).and(ExactSpan.slab(line, p, axis, half),
              Math.max(r, l)));
    }
    trial.assertCounts(600, 300, 24);
  }

  @Test
  void raysParallelToASlantingAxisHitTheDiscsAndNeverTheSide() {
    final Vector3D u = new Vector3D(1, 1, 1);
    final Cylinder slanting = new Cylinder(new Point3D(), u, 1, 2, Color.RED);
    final RandomNumbers numbers = new RandomNumbers("parallel to the axis");
    int hits = 0;
    for (int i = 0; i < 2000; i++) {
      final Point3D R = numbers.pointAbout(new Point3D(-100, -100, -100), 1);
      final Hit hit = slanting.intersectionWith(new Ray(R, u));
      final double x = R.x, y = R.y, z = R.z, s = (x + y + z) / Math.sqrt(3), off = Math.sqrt(x * x + y * y + z * z - s * s);
      assertTrue(Math.abs(off - 1) < 1e-5 || hit.hits() == off < 1, () -> R + ", " + hit + ", " + numbers);
      assertTrue(!hit.hits() || hit.normalX() < -0.577 && hit.normalY() < -0.577, () -> R + ", " + hit + ", " + numbers);
      hits += hit.hits() ? 1 : 0;
    }
    assertTrue(hits > 500 && hits < 1900, hits + " hits");
  }

  /** Where disc and side meet, rounding decides which of them is hit; the point is that of the rim in either case. */
  @Test
  void raysAtTheRimHitItThereIfTheyHit() {
    final RandomNumbers numbers = new RandomNumbers("rim of a cylinder");
    int hits = 0;
    for (int i = 0; i < 2000; i++) {
      final double r = numbers.magnitude(-2, 2), angle = numbers.between(0, 2 * Math.PI);
      final double x = r * Math.cos(angle), y = r * Math.sin(angle), z = 1.5;
      final Cylinder cylinder = new Cylinder(new Point3D(), new Vector3D(0, 0, 1), (float) r, 3, Color.RED);
      final Vector3D v = numbers.direction();
      final double[] d = CrossingOracle.normalised(v.x - 2 * x / r, v.y - 2 * y / r, -2);
      final Hit hit = cylinder.intersectionWith(Ray.exactly(x - 10 * d[0], y - 10 * d[1], z - 10 * d[2], d[0], d[1], d[2]));
      if (hit.hits() && Math.abs(hit.distance() - 10) < 1e-9) {
        hits++;
        assertEquals(x, hit.pointX(), 1e-6, () -> hit + ", " + numbers);
        assertEquals(y, hit.pointY(), 1e-6, () -> hit + ", " + numbers);
        assertEquals(z, hit.pointZ(), 1e-6, () -> hit + ", " + numbers);
      }
    }
    assertTrue(hits > 500, "hits: " + hits);
  }

  @Test
  void boxIsThatOfTheSlantingDiscs() {
    assertEquals(5, UPRIGHT.getBoundingBox().maxX(), 1e-5);
    assertEquals(-2, UPRIGHT.getBoundingBox().minZ(), 1e-5);
    final Cylinder slanting = new Cylinder(new Point3D(), new Vector3D(0, 3, 4), 5, 10, Color.RED);
    assertEquals(3 + 4, slanting.getBoundingBox().maxY(), 1e-5);
    assertEquals(4 + 3, slanting.getBoundingBox().maxZ(), 1e-5);
  }

  @Test
  void textTellsAxisRadiusAndLength() {
    assertEquals("Cylinder(P=(0.0, 0.0, 0.0), u=(0.0, 0.0, 1.0), r=5.0, l=4.0)", UPRIGHT.toString());
  }
}
