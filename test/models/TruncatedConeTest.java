package models;

import static models.HitAssertions.assertHit;
import static models.HitAssertions.assertMiss;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.math.BigDecimal;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

class TruncatedConeTest implements Object3DContract {

  private static final Point3D O = new Point3D();
  private static final Vector3D X = new Vector3D(1, 0, 0);
  private static final Vector3D Z = new Vector3D(0, 0, 1);

  /** Radius 5 at z = −2, 2 at z = 2: the normal of the side is along (4, 0, 3) where y = 0. */
  private static final TruncatedCone CONE = new TruncatedCone(O, new Vector3D(0, 0, 7), 5, 2, 4, Color.RED);

  /** The tip is the origin, the opening downwards; half a right angle. */
  private static final TruncatedCone TIP = new TruncatedCone(new Point3D(0, 0, -1), Z, 2, 0, 2, Color.RED);

  @Override
  public Object3D shape(final RandomPlacement at) {
    return new TruncatedCone(at.point(1, 1, -0.5), at.direction(1, 2, 2), at.length(1.5f), at.length(0.5f), at.length(4),
        Color.RED);
  }

  @Override
  public double signedDistance(final double x, final double y, final double z) {
    final double px = x - 1, py = y - 1, pz = z + 0.5, s = (px + 2 * py + 2 * pz) / 3;
    final double rho = Math.sqrt(Math.max(0, px * px + py * py + pz * pz - s * s));
    return Math.max((rho - 1 + 0.25 * s) / Math.sqrt(1 + 0.0625), Math.abs(s) - 2);
  }

  @Override
  public double accuracy() {
    return 1e-12;
  }

  @Test
  void rayAcrossHitsTheSideWithTheNormalOfTheTriangle345() {
    assertHit(6.5, new Point3D(-3.5f, 0, 0), new Vector3D(-0.8f, 0, 0.6f), CONE, new Ray(new Point3D(-10, 0, 0), X));
    assertHit(3.5, new Point3D(3.5f, 0, 0), new Vector3D(0.8f, 0, 0.6f), CONE, new Ray(O, X));
  }

  @Test
  void raysAlongTheAxisHitDiscsAndSide() {
    assertHit(8, new Point3D(1, -1, 2), Z, CONE, new Ray(new Point3D(1, -1, 10), new Vector3D(0, 0, -1)));
    assertHit(10, new Point3D(0, 3.5f, 0), new Vector3D(0, 0.8f, 0.6f), CONE,
        new Ray(new Point3D(0, 3.5f, 10), new Vector3D(0, 0, -1)));
    assertHit(8, new Point3D(4, 1, -2), new Vector3D(0, 0, -1), CONE, new Ray(new Point3D(4, 1, -10), Z));
    assertHit(1, new Point3D(1, 1, -2), new Vector3D(0, 0, -1), CONE,
        new Ray(new Point3D(1, 1, -1), new Vector3D(0, 0, -1)));
  }

  @Test
  void raysBesideItMiss() {
    assertMiss(CONE, new Ray(new Point3D(-10, Math.nextUp(5f), -2), X));
    assertMiss(CONE, new Ray(new Point3D(-10, 0, Math.nextUp(2f)), X));
    assertMiss(CONE, new Ray(new Point3D(4, 4, 10), new Vector3D(0, 0, -1)));
    assertMiss(CONE, new Ray(new Point3D(6, 0, 0), X));
    assertMiss(CONE, new Ray(new Point3D(-10, 0, 8), X));
    assertMiss(TIP, new Ray(new Point3D(-10, 0, 1e-9f), X));
    assertMiss(TIP, new Ray(new Point3D(-10, 1e-9f, 0), X));
    assertMiss(new TruncatedCone(new Point3D(0, 0, 1), Z, 1, 0, 2, Color.RED),
        new Ray(new Point3D(-10, 0, Math.nextUp(2f)), X));
  }

  /** Parallel to a generator, where the quadratic becomes linear, and along one. */
  @Test
  void raysParallelToAGeneratorHitOnce() {
    final Vector3D down = new Vector3D(-1, 0, -1);
    final Vector3D side = new Vector3D((float) Math.sqrt(0.5), 0, (float) Math.sqrt(0.5));
    assertHit(Math.sqrt(8), new Point3D(1, 0, -1), side, TIP, new Ray(new Point3D(3, 0, 1), down));
    assertHit(Math.sqrt(0.5), new Point3D(0.5f, 0, -0.5f), side, TIP, new Ray(new Point3D(1, 0, 0), down));
    assertHit(Math.sqrt(0.5), new Point3D(0, 0, -2), new Vector3D(0, 0, -1), TIP,
        new Ray(new Point3D(0.5f, 0, -1.5f), down));
    assertMiss(TIP, new Ray(new Point3D(1, 0, 2), down));
  }

  @Test
  void steepRaysHitTheHalfThatIsThere() {
    assertHit(1.5, new Point3D(0.5f, 0, -0.5f), new Vector3D((float) Math.sqrt(0.5), 0, (float) Math.sqrt(0.5)), TIP,
        new Ray(new Point3D(0.5f, 0, 1), new Vector3D(0, 0, -1)));
    assertHit(1, new Point3D(0.5f, 0, -2), new Vector3D(0, 0, -1), TIP, new Ray(new Point3D(0.5f, 0, -3), Z));
    assertHit(0.5, new Point3D(0.5f, 0, -0.5f), new Vector3D((float) Math.sqrt(0.5), 0, (float) Math.sqrt(0.5)), TIP,
        new Ray(new Point3D(0.5f, 0, -1), Z));
  }

  @Test
  void tangentRaysTouchAtOnePointIfAtAll() {
    final Hit alongDisc = CONE.intersectionWith(new Ray(new Point3D(-10, 0, 2), X));
    assertTrue(!alongDisc.hits() || Math.abs(alongDisc.getT() - 8) < 1e-6, alongDisc.toString());
    final Hit side = CONE.intersectionWith(new Ray(new Point3D(-10, 3.5f, 0), X));
    assertTrue(!side.hits() || Math.abs(side.getT() - 10) < 1e-3, side.toString());
    final Hit generator = TIP.intersectionWith(new Ray(new Point3D(4, 0, -4), new Vector3D(-1, 0, 1)));
    assertTrue(!generator.hits() || Math.abs(generator.getT() - 1.5 * Math.sqrt(8)) < 1.4143, generator.toString());
  }

  @Test
  void agreesWithExactArithmeticUpToTenMillionSizesAway() {
    final ExactTrial trial = new ExactTrial("exact cone");
    final RandomNumbers numbers = trial.numbers();
    for (int n = 0; n < 60; n++) {
      final float large = numbers.magnitude(-20, 20), small = n % 3 == 0 ? 0 : large * numbers.magnitude(-6, 0);
      final float rA = n % 2 == 0 ? small : large, rB = n % 2 == 0 ? large : small, l = large * numbers.magnitude(-2, 3);
      final Point3D P = numbers.pointAbout(O, large * numbers.magnitude(-3, 3));
      final Vector3D u = numbers.direction();
      final ExactVector p = ExactVector.of(P), axis = ExactVector.of(u).normalised();
      final BigDecimal half = new BigDecimal(l * 0.5), size = new BigDecimal(Math.max(large, l));
      final BigDecimal m = new BigDecimal(rA).add(new BigDecimal(rB)).multiply(new BigDecimal(0.5));
      final BigDecimal k = new BigDecimal(rB).subtract(new BigDecimal(rA)).divide(new BigDecimal(l), ExactVector.DIGITS);
      trial.ask(new TruncatedCone(P, u, rA, rB, l, Color.RED), P, 1.2 * Math.max(large, l / 2), RandomNumbers.times(60),
          line -> ExactSpan.cone(line, p, axis, m, k, size).and(ExactSpan.slab(line, p, axis, half), Math.max(large, l)));
    }
    trial.assertCounts(700, 700, 60);
  }

  /**
   * The exact sign of the discriminant separates hits from misses, down to 1e-12 of the distance beside the tip. Rays that
   * miss by no more than rounding to floats can make up are left out, as they may hit the tip.
   */
  @Test
  void raysThatJustHitOrJustMissNearTheTipAreDistinguished() {
    final RandomNumbers numbers = new RandomNumbers("near the tip");
    final ExactVector axis = ExactVector.of(Z), tip = ExactVector.of(O), middle = ExactVector.of(0, 0, -1);
    final BigDecimal one = BigDecimal.ONE;
    int hits = 0, misses = 0;
    for (int n = 0; n < 20000; n++) {
      final Vector3D v = numbers.direction();
      final double off = Math.pow(10, numbers.between(-12, -1)), away = numbers.between(0.1, 20);
      final Point3D near = numbers.pointAbout(O, 1);
      final double length = Math.sqrt((double) v.x * v.x + (double) v.y * v.y + (double) v.z * v.z);
      final Ray ray = Ray.exactly(off * near.x - away * v.x, off * near.y - away * v.y, off * near.z - away * v.z,
          v.x / length, v.y / length, v.z / length);
      final ExactSpan.Line line = ExactSpan.Line.exactly(ray);
      final ExactSpan span = ExactSpan.cone(line, tip, axis, BigDecimal.ZERO, one.negate(), new BigDecimal(off))
          .and(ExactSpan.slab(line, middle, axis, one), off);
      final boolean expected = span.first() < Double.POSITIVE_INFINITY;
      if (Math.abs(span.gap()) > 1e-2 && off > (expected ? 1e-12 : 2e-6) * away) {
        assertEquals(expected, TIP.intersectionWith(ray).hits(), () -> ray + ", off " + off + ", " + span + ", " + numbers);
        hits += expected ? 1 : 0;
        misses += expected ? 0 : 1;
      }
    }
    assertTrue(hits > 2000 && misses > 2000, hits + " hits, " + misses + " misses");
  }

  /** Rays through the tip itself, from all sides: the discriminant is 0, and the tip is hit. */
  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void noRayPassesThroughTheTip(final boolean tipAtA) {
    final RandomNumbers numbers = new RandomNumbers("through the tip");
    TruncatedCone cone = null;
    double[] tip = null;
    Vector3D u = null;
    for (int n = 0; n < RandomNumbers.times(500_000); n++) {
      if (n % 5000 == 0) {
        final Point3D P = numbers.pointAbout(O, 3);
        final float l = numbers.magnitude(-3, 3), r = numbers.magnitude(-3, 3);
        u = numbers.direction();
        cone = new TruncatedCone(P, u, tipAtA ? 0 : r, tipAtA ? r : 0, l, Color.RED);
        final double k = (tipAtA ? -0.5 : 0.5) * l / Axis.length(u);
        tip = new double[] {P.x + k * u.x, P.y + k * u.y, P.z + k * u.z};
      }
      final Vector3D v = numbers.direction();
      final double away = numbers.magnitude(-3, 8), length = Axis.length(v);
      final double dx = v.x / length, dy = v.y / length, dz = v.z / length;
      final Hit hit = cone.intersectionWith(
          Ray.exactly(tip[0] - away * dx, tip[1] - away * dy, tip[2] - away * dz, dx, dy, dz));
      if (!(hit.hits() && hit.getT() <= away * (1 + 1e-5))) {
        throw new AssertionError(cone + ", from " + away + " along " + v + ": " + hit + ", " + numbers);
      }
      final double outwards = (tipAtA ? -1 : 1) * (hit.normalX() * u.x + hit.normalY() * u.y + hit.normalZ() * u.z);
      if (Math.abs(hit.distance() - away) < 1e-15 * (1 + away) && !(outwards > 0.999999 * Axis.length(u))) {
        throw new AssertionError(cone + ", from " + away + " along " + v + ": " + hit + ", " + numbers);
      }
    }
  }

  /** Rays of floats towards the tip pass it at some 1e-8 of the way; those that go on into the cone must hit it. */
  @Test
  void noRayIntoTheConePassesBesideTheTip() {
    final RandomNumbers numbers = new RandomNumbers("into the cone");
    for (int n = 0; n < RandomNumbers.times(200_000); n++) {
      final double phi = numbers.between(0, 6.3), z = numbers.magnitude(-3, 8), r = z * numbers.between(0, 0.9999);
      final Point3D R = new Point3D((float) (r * Math.cos(phi)), (float) (r * Math.sin(phi)), (float) z);
      final Hit hit = TIP.intersectionWith(new Ray(R, O));
      if (!(hit.hits() && Math.abs(hit.getT() - R.distance(O)) < 2e-3 * z)) {
        throw new AssertionError(R + ": " + hit + ", " + numbers);
      }
    }
  }

  /** From nearby, those that would pass it outside hit the tip. */
  @Test
  void noRayOfFloatsTowardsTheTipPassesItNearby() {
    final RandomNumbers numbers = new RandomNumbers("towards the tip");
    for (int n = 0; n < RandomNumbers.times(200_000); n++) {
      final Vector3D v = numbers.direction();
      v.scale(numbers.magnitude(-3, 6));
      final Hit hit = TIP.intersectionWith(new Ray(new Point3D(v.x, v.y, v.z), O));
      if (!(hit.hits() && hit.getT() <= 1.01 * Axis.length(v))) {
        throw new AssertionError(v + ": " + hit + ", " + numbers);
      }
    }
  }

  /** Small cones and large ones, up to fifty times their size from the origin: rays of floats towards the tip hit it. */
  @Test
  void noRayOfFloatsTowardsTheTipOfAConeAnywherePassesIt() {
    final RandomNumbers numbers = new RandomNumbers("towards a tip anywhere");
    for (int n = 0; n < RandomNumbers.times(20_000); n++) {
      final float s = numbers.magnitude(-20, 20);
      final Point3D P = numbers.pointAbout(O, 50 * s), tip = new Point3D(P.x, P.y, P.z + s);
      final TruncatedCone cone = new TruncatedCone(P, Z, n % 2 == 0 ? s : 9 * s, 0, 2 * s, Color.RED);
      final Vector3D v = numbers.direction();
      v.scale(s * numbers.magnitude(-3, 4));
      final Hit hit = cone.intersectionWith(new Ray(new Point3D(tip.x + v.x, tip.y + v.y, tip.z + v.z), tip));
      if (!(hit.hits() && hit.getT() <= 1.01 * Axis.length(v) + 1e-3 * s)) {
        throw new AssertionError(cone + ", " + v + ": " + hit + ", " + numbers);
      }
    }
  }

  /** What floats can make up beside the tip ends at 2⁻¹⁷ of the size, however far away a ray comes from. */
  @Test
  void raysBesideTheTipMissItFromAnyDistance() {
    final RandomNumbers numbers = new RandomNumbers("beside the tip");
    for (int n = 0; n < RandomNumbers.times(20_000); n++) {
      final float s = numbers.magnitude(-20, 20);
      final TruncatedCone cone = new TruncatedCone(new Point3D(0, 0, -s), Z, n % 2 == 0 ? s : 9 * s, 0, 2 * s, Color.RED);
      final double phi = numbers.between(0, 2 * Math.PI), away = s * numbers.magnitude(0, 30), beside = 2e-5 * s;
      final double x = Math.cos(phi), y = Math.sin(phi), up = Math.sin(0.1), along = Math.cos(0.1), k = away * along;
      assertMiss(cone, Ray.exactly(-away * x, -away * y, beside, x, y, 0));
      assertMiss(cone, Ray.exactly(-k * x - beside * y, -k * y + beside * x, 9 * beside - away * up,
          along * x, along * y, up));
    }
  }

  /** Where disc and side meet, rounding decides which of them is hit; the point is that of the rim in either case. */
  @Test
  void raysAtTheRimHitItThereIfTheyHit() {
    final RandomNumbers numbers = new RandomNumbers("rim of a cone");
    int hits = 0;
    for (int i = 0; i < 2000; i++) {
      final double r = numbers.magnitude(-2, 2), angle = numbers.between(0, 2 * Math.PI);
      final double x = r * Math.cos(angle), y = r * Math.sin(angle), z = 1.5;
      final TruncatedCone cone = new TruncatedCone(O, Z, (float) r + 1, (float) r, 3, Color.RED);
      final Vector3D v = numbers.direction();
      final double[] d = CrossingOracle.normalised(v.x - 2 * x / r, v.y - 2 * y / r, -2);
      final Hit hit = cone.intersectionWith(Ray.exactly(x - 10 * d[0], y - 10 * d[1], z - 10 * d[2], d[0], d[1], d[2]));
      if (hit.hits() && Math.abs(hit.distance() - 10) < 1e-9) {
        hits++;
        assertEquals(x, hit.pointX(), 1e-6, () -> hit + ", " + numbers);
        assertEquals(y, hit.pointY(), 1e-6, () -> hit + ", " + numbers);
        assertEquals(z, hit.pointZ(), 1e-6, () -> hit + ", " + numbers);
      }
    }
    assertTrue(hits > 500, "hits: " + hits);
  }

  /** An end too narrow for any computation is hit as a tip is, also exactly along the axis. */
  @Test
  void anEndOfVanishingRadiusIsHit() {
    for (final float r : new float[] {1e-18f, 1e-30f, Float.MIN_VALUE}) {
      for (final boolean atA : new boolean[] {true, false}) {
        final TruncatedCone cone = new TruncatedCone(new Point3D(0, 0, atA ? 1 : -1), Z, atA ? r : 2, atA ? 2 : r, 2,
            Color.RED);
        final float up = atA ? -1 : 1;
        assertHit(5, O, new Vector3D(0, 0, up), cone, new Ray(new Point3D(0, 0, 5 * up), new Vector3D(0, 0, -up)));
        assertEquals(2, cone.intersectionWith(new Ray(new Point3D(0, 0, -2 * up - up), new Vector3D(0, 0, up))).getT() + 1,
            1e-6);
        assertTrue(cone.intersectionWith(new Ray(new Point3D(0, 0, -up), new Vector3D(0, 0, up))).hits());
      }
    }
  }

  @Test
  void theNormalAtTheTipPointsAwayFromTheCone() {
    assertHit(5, O, Z, TIP, new Ray(new Point3D(0, 0, 5), new Vector3D(0, 0, -1)));
    assertHit(5, O, Z, TIP, new Ray(new Point3D(-5, 0, 0), X));
    assertHit(5, O, Z, TIP, new Ray(new Point3D(3, -4, 0), new Vector3D(-3, 4, 0)));
    assertHit(1, O, Z, TIP, new Ray(new Point3D(0, 0, -1), Z));
    final TruncatedCone down = new TruncatedCone(new Point3D(0, 0, 1), Z, 0, 2, 2, Color.RED);
    assertHit(5, O, new Vector3D(0, 0, -1), down, new Ray(new Point3D(-5, 0, 0), X));
  }

  /** Along a generator the quadratic is linear: rays that leave the side almost along one must not find it again. */
  @Test
  void raysThatLeaveAlmostAlongAGeneratorDoNotComeBack() {
    final RandomNumbers numbers = new RandomNumbers("along a generator");
    int left = 0;
    for (int n = 0; n < RandomNumbers.times(100_000); n++) {
      final float s = numbers.magnitude(-10, 20);
      final Point3D P = numbers.pointAbout(O, s * Math.pow(10, numbers.between(-2, 4)));
      final Vector3D u = numbers.direction(), v = numbers.direction();
      final TruncatedCone cone = new TruncatedCone(P, u, s, n % 2 == 0 ? 0.4f * s : 0, 0.7f * s, Color.RED);
      final Hit hit = cone.intersectionWith(new Ray(numbers.pointAbout(P, 9 * s), numbers.pointAbout(P, 0.6 * s)));
      final double across = hit.normalX() * u.x + hit.normalY() * u.y + hit.normalZ() * u.z;
      if (hit.hits() && Math.abs(across) < 0.9) {
        left++;
        final double sign = numbers.index(2) == 0 ? 1 : -1, off = numbers.magnitude(-50, -2);
        final double x = sign * u.x + off * v.x, y = sign * u.y + off * v.y, z = sign * u.z + off * v.z;
        final double lift = numbers.magnitude(-40, -20) - x * hit.normalX() - y * hit.normalY() - z * hit.normalZ();
        final double[] d = CrossingOracle.normalised(x + lift * hit.normalX(), y + lift * hit.normalY(),
            z + lift * hit.normalZ());
        final Ray next = hit.leave(true, d[0], d[1], d[2]);
        assertMiss(cone, next);
      }
    }
    assertTrue(left > 10_000, left + " rays");
  }

  @Test
  void equalRadiiMakeItTheCylinder() {
    final RandomNumbers numbers = new RandomNumbers("cone and cylinder");
    int hits = 0;
    for (int n = 0; n < 20000; n++) {
      final float r = numbers.magnitude(-2, 2), l = numbers.magnitude(-2, 2);
      final Point3D P = numbers.pointAbout(O, 3);
      final Vector3D u = numbers.direction();
      final Ray ray = new Ray(numbers.pointAbout(O, 5), numbers.pointAbout(P, Math.max(r, l / 2)));
      final Hit hit = new TruncatedCone(P, u, r, r, l, Color.RED).intersectionWith(ray),
          expected = new Cylinder(P, u, r, l, Color.RED).intersectionWith(ray);
      assertEquals(expected.hits(), hit.hits(), () -> ray + ", " + numbers);
      if (hit.hits()) {
        hits++;
        assertEquals(expected.getT(), hit.getT(), 1e-6 * (hit.getT() + 1e-6), () -> ray + ", " + numbers);
        assertTrue(expected.getNormal().epsilonEquals(hit.getNormal(), 1e-6f), () -> ray + ", " + numbers);
        assertTrue(expected.getPoint().epsilonEquals(hit.getPoint(), 1e-5f), () -> ray + ", " + numbers);
      }
    }
    assertTrue(hits > 5000, hits + " hits");
  }

  @Test
  void equalRadiiLetNoRayAlongTheAxisThrough() {
    final TruncatedCone roll = new TruncatedCone(O, Z, 2, 2, 4, Color.RED);
    assertHit(8, new Point3D(1, 1, 2), Z, roll, new Ray(new Point3D(1, 1, 10), new Vector3D(0, 0, -1)));
    assertHit(1, new Point3D(1, 1, -2), new Vector3D(0, 0, -1), roll, new Ray(new Point3D(1, 1, -3), Z));
    assertMiss(roll, new Ray(new Point3D(2, 0.1f, 10), new Vector3D(0, 0, -1)));
    for (final float z : new float[] {-1.5f, 0, 1.5f}) {
      assertHit(2 - z, new Point3D(1, 1, 2), Z, roll, new Ray(new Point3D(1, 1, z), Z));
    }
  }

  @Test
  void exchangingBothEndsChangesNothing() {
    final RandomNumbers numbers = new RandomNumbers("ends exchanged");
    int hits = 0;
    for (int n = 0; n < 20000; n++) {
      final float rA = numbers.magnitude(-2, 2), rB = n % 3 == 0 ? 0 : numbers.magnitude(-2, 2);
      final float l = numbers.magnitude(-2, 2);
      final Point3D P = numbers.pointAbout(O, 3);
      final Vector3D u = numbers.direction(), back = new Vector3D(-u.x, -u.y, -u.z);
      final Ray ray = new Ray(numbers.pointAbout(O, 5), numbers.pointAbout(P, Math.max(Math.max(rA, rB), l / 2)));
      final TruncatedCone one = new TruncatedCone(P, u, rA, rB, l, Color.RED),
          other = new TruncatedCone(P, back, rB, rA, l, Color.RED);
      final Hit a = one.intersectionWith(ray), b = other.intersectionWith(ray);
      hits += a.hits() ? 1 : 0;
      assertEquals(a.hits(), b.hits());
      assertTrue(!a.hits() || a.getT() == b.getT() && a.getPoint().equals(b.getPoint())
          && a.getNormal().equals(b.getNormal()), () -> one + ", " + ray + ": " + a + ", " + b + ", " + numbers);
      assertEquals(one.getBoundingBox().toString(), other.getBoundingBox().toString());
    }
    assertTrue(hits > 5000, hits + " hits");
  }

  @Test
  void chordsAddUpToTheVolume() {
    final float[][] sizes = {{0, 2, 3}, {2, 0, 3}, {2, 1, 3}, {1, 1, 1}, {3, 0.5f, 0.2f}};
    for (final float[] s : sizes) {
      final TruncatedCone cone = new TruncatedCone(O, new Vector3D(1, 3, 2), s[0], s[1], s[2], Color.RED);
      final double volume = Math.PI / 3 * s[2] * (s[0] * s[0] + s[0] * s[1] + s[1] * s[1]);
      double chords = 0;
      final int n = 400;
      for (int i = 0; i < n * n; i++) {
        final double x = 8 * (i / n + 0.5) / n - 4, y = 8 * (i % n + 0.5) / n - 4;
        final double t = cone.distance(x, y, -20, 0, 0, 1);
        chords += t < 40 ? 40 - t - cone.distance(x, y, 20, 0, 0, -1) : 0;
      }
      assertEquals(volume, chords * 64 / n / n, 2e-3 * volume, cone.toString());
    }
  }

  @Test
  void boxIsTheLeastAroundTheDiscs() {
    final BoundingBox box = new TruncatedCone(new Point3D(1, 2, 3), new Vector3D(0, 3, 4), 5, 0, 10, Color.RED)
        .getBoundingBox();
    assertEquals(1 - 5, box.minX(), 1e-6);
    assertEquals(1 + 5, box.maxX(), 1e-6);
    assertEquals(2 - 3 - 4, box.minY(), 1e-6);
    assertEquals(2 + 3, box.maxY(), 1e-6);
    assertEquals(3 - 4 - 3, box.minZ(), 1e-6);
    assertEquals(3 + 4, box.maxZ(), 1e-6);
    assertEquals(2, CONE.getBoundingBox().maxZ(), 1e-6);
    assertEquals(0, TIP.getBoundingBox().maxZ(), 1e-12);
  }

  @Test
  void flatConeIsMetOnTheSideThatTheRayComesFrom() {
    for (final float l : new float[] {1e-30f, 1e-20f, 1e-16f, 1e-9f}) {
      final TruncatedCone flat = new TruncatedCone(new Point3D(0, 0, 1), Z, 1, 0.5f, l, Color.RED);
      for (int i = 0; i < 50; i++) {
        final float x = i * 0.019f;
        assertHit(4 * Math.sqrt(1.01), new Point3D(x, 0, 1), Z, flat, new Ray(new Point3D(x - 0.4f, 0, 5),
            new Vector3D(0.1f, 0, -1)));
        assertHit(6 * Math.sqrt(1.01), new Point3D(x, 0, 1), new Vector3D(0, 0, -1), flat,
            new Ray(new Point3D(x - 0.6f, 0, -5), new Vector3D(0.1f, 0, 1)));
      }
    }
  }

  @ParameterizedTest
  @ValueSource(floats = {1e-37f, 1e-20f, 1e20f, 1e37f})
  void sizesAtTheEndsOfTheFloatsWork(final float size) {
    final TruncatedCone cone = new TruncatedCone(O, Z, 5 * size, 2 * size, 4 * size, Color.RED);
    assertHit(6.5 * size, new Point3D(-3.5f * size, 0, 0), new Vector3D(-0.8f, 0, 0.6f), cone,
        new Ray(new Point3D(-10 * size, 0, 0), X));
  }

  @Test
  void textAndArgumentsAreThoseOfTheConstructor() {
    assertEquals("TruncatedCone(P=(0.0, 0.0, 0.0), u=(0.0, 0.0, 1.0), rA=5.0, rB=2.0, l=4.0)", CONE.toString());
    assertEquals("[(0.0, 0.0, 0.0), (0.0, 0.0, 1.0), 5.0, 2.0, 4.0, " + Color.RED + "]",
        CONE.constructorArguments().toString());
  }
}
