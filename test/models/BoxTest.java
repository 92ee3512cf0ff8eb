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

class BoxTest implements Object3DContract {

  /** From (−3, −2, −1) to (3, 2, 1). */
  private static final Box STRAIGHT =
      new Box(new Point3D(), new Vector3D(2, 0, 0), new Vector3D(0, 5, 0), 6, 4, 2, Color.RED);

  @Override
  public Object3D shape(final RandomPlacement at) {
    return new Box(at.point(1, -1, 2), at.direction(2, 2, 1), at.direction(-2, 3, 0), at.length(3), at.length(1.5f),
        at.length(2), Color.RED);
  }

  /** i = (2, 2, 1)/3, k = i × (−2, 3, 0) normalised = (−3, −2, 10)/√113, j = k × i. */
  @Override
  public double signedDistance(final double x, final double y, final double z) {
    final double px = x - 1, py = y + 1, pz = z - 2, s = Math.sqrt(113);
    final double kx = -3 / s, ky = -2 / s, kz = 10 / s;
    final double jx = (ky - 2 * kz) / 3, jy = (2 * kz - kx) / 3, jz = (2 * kx - 2 * ky) / 3;
    final double a = Math.abs(2 * px + 2 * py + pz) / 3 - 1.5, b = Math.abs(jx * px + jy * py + jz * pz) - 0.75,
        c = Math.abs(kx * px + ky * py + kz * pz) - 1;
    return Math.min(Math.max(a, Math.max(b, c)), 0)
        + Math.hypot(Math.max(a, 0), Math.hypot(Math.max(b, 0), Math.max(c, 0)));
  }

  @Override
  public double accuracy() {
    return 1e-12;
  }

  @Test
  void axisParallelRaysHitTheSixFaces() {
    final Point3D P = new Point3D(0.5f, -0.25f, 0.75f);
    for (int axis = 0; axis < 3; axis++) {
      for (int side = -1; side <= 1; side += 2) {
        final float[] half = {3, 2, 1}, p = {P.x, P.y, P.z}, n = new float[3], start = p.clone(), v = {0, -0f, 0};
        n[axis] = side;
        p[axis] = side * half[axis];
        start[axis] = side * 10;
        v[axis] = -side;
        assertHit(10 - half[axis], new Point3D(p[0], p[1], p[2]), new Vector3D(n[0], n[1], n[2]), STRAIGHT,
            new Ray(new Point3D(start[0], start[1], start[2]), new Vector3D(v[0], v[1], v[2])));
      }
    }
  }

  @Test
  void slantingRayHitsAtTheCornerOfTheTriangle345() {
    assertHit(5, new Point3D(1, 2, 0), new Vector3D(0, 1, 0), STRAIGHT,
        new Ray(new Point3D(5, 5, 0), new Vector3D(-4, -3, 0)));
    assertHit(5, new Point3D(3, 1, 0), new Vector3D(1, 0, 0), STRAIGHT,
        new Ray(new Point3D(7, 4, 0), new Vector3D(-4, -3, 0)));
  }

  @Test
  void raysFromInsideHitTheFarWall() {
    assertHit(2, new Point3D(3, 0, 0), new Vector3D(1, 0, 0), STRAIGHT,
        new Ray(new Point3D(1, 0, 0), new Vector3D(1, 0, 0)));
    assertHit(4, new Point3D(-3, 0, 0), new Vector3D(-1, 0, 0), STRAIGHT,
        new Ray(new Point3D(1, 0, 0), new Vector3D(-1, 0, 0)));
    assertHit(2.5, new Point3D(2, -2, 0), new Vector3D(0, -1, 0), STRAIGHT,
        new Ray(new Point3D(0.5f, 0, 0), new Vector3D(3, -4, 0)));
  }

  @Test
  void verticalAxisLiesInThePlaneOfAuxAndKIsTheirProduct() {
    final Box turned = new Box(new Point3D(), new Vector3D(0, 0, -1), new Vector3D(0, 1, -7), 2, 4, 6, Color.RED);
    assertHit(9, new Point3D(0, 0, 1), new Vector3D(0, 0, 1), turned,
        new Ray(new Point3D(0, 0, 10), new Vector3D(0, 0, -1)));
    assertHit(8, new Point3D(0, 2, 0), new Vector3D(0, 1, 0), turned,
        new Ray(new Point3D(0, 10, 0), new Vector3D(0, -1, 0)));
    assertHit(7, new Point3D(3, 0, 0), new Vector3D(1, 0, 0), turned,
        new Ray(new Point3D(10, 0, 0), new Vector3D(-1, 0, 0)));
  }

  @Test
  void raysBesideItMiss() {
    assertMiss(STRAIGHT, new Ray(new Point3D(10, Math.nextUp(2f), 0), new Vector3D(-1, 0, 0)));
    assertMiss(STRAIGHT, new Ray(new Point3D(10, 0, -Math.nextUp(1f)), new Vector3D(-1, 0, 0)));
    assertMiss(STRAIGHT, new Ray(new Point3D(5, 1, 0), new Vector3D(-1, 1, 0)));
  }

  @Test
  void boxBehindTheRayIsMissed() {
    assertMiss(STRAIGHT, new Ray(new Point3D(4, 0, 0), new Vector3D(1, 0, 0)));
    assertMiss(STRAIGHT, new Ray(new Point3D(4, 3, 2), new Vector3D(1, 1, 1)));
  }

  @Test
  void raysAtEdgesAndCornersHitOneOfTheFacesThere() {
    final Hit edge = STRAIGHT.intersectionWith(new Ray(new Point3D(5, 4, 0), new Vector3D(-1, -1, 0)));
    assertTrue(!edge.hits() || edge.getPoint().equals(new Point3D(3, 2, 0)), edge.toString());
    final Hit corner = STRAIGHT.intersectionWith(new Ray(new Point3D(), new Point3D(3, 2, 1)));
    HitAssertions.assertClose(new Point3D(3, 2, 1), corner.getPoint(), 1e-6, corner.toString());
    assertEquals(Math.sqrt(14), corner.getT(), 1e-6);
  }

  @Test
  void raysThatSlideAlongAFaceTouchItOrMiss() {
    final Hit hit = STRAIGHT.intersectionWith(new Ray(new Point3D(10, 2, 0), new Vector3D(-1, 0, 0)));
    assertTrue(!hit.hits() || hit.getT() == 7, hit.toString());
  }

  @Test
  void rayThatStartsOnAFaceInwardsMeetsTheFarOne() {
    final Hit hit = STRAIGHT.intersectionWith(new Ray(new Point3D(3, 0, 0), new Vector3D(-1, 0, 0)));
    assertTrue(hit.getT() < 1e-6 || hit.getT() == 6, hit.toString());
  }

  @Test
  void flatBoxIsMetOnTheSideThatTheRayComesFrom() {
    for (final float d : new float[] {1e-30f, 1e-20f, 1e-16f, 1e-9f}) {
      final Box wall = new Box(new Point3D(0, 0, 1), new Vector3D(1, 0, 0), new Vector3D(0, 1, 0), 2, 2, d, Color.RED);
      for (int i = 0; i < 50; i++) {
        final float x = i * 0.019f;
        assertHit(4 * Math.sqrt(1.01), new Point3D(x, 0, 1), new Vector3D(0, 0, 1), wall,
            new Ray(new Point3D(x - 0.4f, 0, 5), new Vector3D(0.1f, 0, -1)));
        assertHit(6 * Math.sqrt(1.01), new Point3D(x, 0, 1), new Vector3D(0, 0, -1), wall,
            new Ray(new Point3D(x - 0.6f, 0, -5), new Vector3D(0.1f, 0, 1)));
      }
    }
  }

  @Test
  void agreesWithExactArithmeticUpToTenMillionSizesAway() {
    final ExactTrial trial = new ExactTrial("exact box");
    final RandomNumbers numbers = trial.numbers();
    for (int n = 0; n < 40; n++) {
      final float w = numbers.magnitude(-20, 20), h = w * numbers.magnitude(-3, 3), d = w * numbers.magnitude(-3, 3);
      final double size = Math.max(w, Math.max(h, d));
      final Point3D C = numbers.pointAbout(new Point3D(), w * numbers.magnitude(-3, 3));
      final Vector3D i = numbers.direction(), aux = numbers.direction();
      aux.scale(numbers.magnitude(-10, 10));
      final ExactVector c = ExactVector.of(C), along = ExactVector.of(i).normalised();
      final ExactVector deep = along.cross(ExactVector.of(aux)).normalised(), up = deep.cross(along);
      final BigDecimal a = new BigDecimal(w * 0.5), b = new BigDecimal(h * 0.5), e = new BigDecimal(d * 0.5);
      trial.ask(new Box(C, i, aux, w, h, d, Color.RED), C, 0.7 * size, RandomNumbers.times(60),
          line -> ExactSpan.slab(line, c, along, a).and(ExactSpan.slab(line, c, up, b), size)
              .and(ExactSpan.slab(line, c, deep, e), size));
    }
    trial.assertCounts(450, 450, 24);
  }

  @Test
  void boundingBoxOfATurnedBoxHoldsItsCorners() {
    final Box turned = new Box(new Point3D(), new Vector3D(3, 4, 0), new Vector3D(-4, 3, 0), 10, 20, 2, Color.RED);
    assertEquals(3 + 8, turned.getBoundingBox().maxX(), 1e-5);
    assertEquals(-4 - 6, turned.getBoundingBox().minY(), 1e-5);
    assertEquals(1, turned.getBoundingBox().maxZ(), 1e-5);
  }

  @Test
  void textTellsCentreAndSizes() {
    assertEquals("Box(C=(0.0, 0.0, 0.0), w=6.0, h=4.0, d=2.0)", STRAIGHT.toString());
    assertEquals("Box(C=(7.0, 8.0, 9.0), w=1.0, h=3.0, d=5.0)",
        new Box(new Point3D(7, 8, 9), new Vector3D(1, 0, 0), new Vector3D(0, 1, 0), 1, 3, 5, Color.RED).toString());
  }
}
