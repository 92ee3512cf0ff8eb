package models;

import static models.HitAssertions.assertHit;
import static models.HitAssertions.assertMiss;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.awt.Color;
import java.math.BigDecimal;

import org.junit.jupiter.api.Test;

import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;

class PlaneTest implements Object3DContract {

  private static final Plane FLOOR = new Plane(new Point3D(7, -1, 9), new Vector3D(0, 3, 0), Color.GREEN);

  @Override
  public Object3D shape(final RandomPlacement at) {
    return new Plane(at.point(0.5, 0.25, -1), at.direction(1, -2, 2), Color.GREEN);
  }

  @Override
  public double signedDistance(final double x, final double y, final double z) {
    return (x - 0.5 - 2 * (y - 0.25) + 2 * (z + 1)) / 3;
  }

  @Override
  public double accuracy() {
    return 1e-13;
  }

  @Test
  void rayFromAboveHitsTheFloorAtTheCornerOfTheTriangle345() {
    assertHit(5, new Point3D(4, -1, 0), new Vector3D(0, 1, 0), FLOOR,
        new Ray(new Point3D(0, 2, 0), new Vector3D(4, -3, 0)));
  }

  @Test
  void rayFromBelowHitsTheSamePointWithTheSameNormal() {
    assertHit(5, new Point3D(4, -1, 0), new Vector3D(0, 1, 0), FLOOR,
        new Ray(new Point3D(0, -4, 0), new Vector3D(4, 3, 0)));
  }

  @Test
  void normalIsTheGivenOneAndNeverTurned() {
    final Plane ceiling = new Plane(new Point3D(0, 4, 0), new Vector3D(0, -0.5f, 0), Color.GREEN);
    assertHit(4, new Point3D(0, 4, 0), new Vector3D(0, -1, 0), ceiling, new Ray(new Point3D(), new Vector3D(0, 1, 0)));
    assertHit(3, new Point3D(0, 4, 0), new Vector3D(0, -1, 0), ceiling,
        new Ray(new Point3D(0, 7, 0), new Vector3D(0, -1, 0)));
  }

  @Test
  void rayAlongThePlaneMisses() {
    assertMiss(FLOOR, new Ray(new Point3D(0, 2, 0), new Vector3D(1, 0, 0)));
    assertMiss(FLOOR, new Ray(new Point3D(0, -3, 0), new Vector3D(-1, -0f, 2)));
    assertMiss(FLOOR, new Ray(new Point3D(0, -1, 0), new Vector3D(0, 0, 1)));
  }

  @Test
  void planeBehindTheRayIsMissed() {
    assertMiss(FLOOR, new Ray(new Point3D(0, 2, 0), new Vector3D(1, 1, 1)));
    assertMiss(FLOOR, new Ray(new Point3D(0, -2, 0), new Vector3D(1, -1, 1)));
  }

  @Test
  void almostParallelRayHitsFarAway() {
    assertHit(3e6, new Point3D(3e6f, -1, 0), new Vector3D(0, 1, 0), FLOOR,
        new Ray(new Point3D(0, 2, 0), new Vector3D(1e6f, -1, 0)));
  }

  @Test
  void agreesWithExactArithmeticFarFromTheOriginAndForFlatAngles() {
    final RandomNumbers numbers = new RandomNumbers("exact plane");
    int hits = 0;
    for (int i = 0; i < RandomNumbers.times(3000); i++) {
      final float size = numbers.magnitude(-20, 20);
      final Point3D P = numbers.pointAbout(new Point3D(), size);
      final Vector3D n = numbers.direction(), v = numbers.direction();
      final Ray ray = new Ray(numbers.pointAbout(P, size * numbers.magnitude(-5, 20)), v);
      final Plane plane = new Plane(P, n, Color.GREEN);
      final ExactSpan.Line line = ExactSpan.Line.of(ray);
      final ExactVector exactN = ExactVector.of(n);
      final BigDecimal slope = line.direction().dot(exactN);
      final double t = ExactVector.of(P).minus(line.start()).dot(exactN).divide(slope, ExactVector.DIGITS).doubleValue();
      final double cancelling = 1e-14 * (size + ray.getStartingPoint().distance(
          new Point3D())) / Math.abs(slope.doubleValue());
      if (t > cancelling) {
        hits++;
        assertEquals(t, plane.intersectionWith(ray).getT(), 1.2e-7 * t + cancelling, () -> plane + ", " + ray + ", "
            + numbers);
      } else if (t < -cancelling) {
        assertMiss(plane, ray);
      }
    }
    assertEquals(RandomNumbers.times(1500), hits, RandomNumbers.times(150), numbers::toString);
  }

  @Test
  void everyRayCrossesItsBox() {
    assertSame(BoundingBox.UNBOUNDED, FLOOR.getBoundingBox());
  }

  @Test
  void textTellsPointAndNormal() {
    assertEquals("Plane(P=(7.0, -1.0, 9.0), n=(0.0, 1.0, 0.0))", FLOOR.toString());
  }
}
