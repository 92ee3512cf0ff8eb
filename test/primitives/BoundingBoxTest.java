package primitives;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;

import org.junit.jupiter.api.Test;

import trials.Trials;

class BoundingBoxTest {

  private static final float INF = Float.POSITIVE_INFINITY;
  private static final BoundingBox BOX = new BoundingBox(new Point3D(-1, 0, 2), new Point3D(3, 4, 2));

  @Test
  void cornersAreAnsweredAsCopies() {
    final Point3D min = new Point3D(-1, 0, 2), max = new Point3D(3, 4, 5);
    final BoundingBox box = new BoundingBox(min, max);
    min.set(7, 7, 7);
    max.set(-7, -7, -7);
    box.getMin().set(9, 9, 9);
    box.getMax().set(-9, -9, -9);
    assertEquals(new Point3D(-1, 0, 2), box.getMin());
    assertEquals(new Point3D(3, 4, 5), box.getMax());
    assertEquals("BoundingBox((-1.0, 0.0, 2.0), (3.0, 4.0, 5.0))", box.toString());
    assertEquals("-1.0 0.0 2.0 3.0 4.0 5.0",
        box.minX() + " " + box.minY() + " " + box.minZ() + " " + box.maxX() + " " + box.maxY() + " " + box.maxZ());
  }

  @Test
  void unionHoldsBoth() {
    final BoundingBox other = new BoundingBox(new Point3D(-5, 1, 1), new Point3D(0, 2, 9));
    assertEquals("BoundingBox((-5.0, 0.0, 1.0), (3.0, 4.0, 9.0))", BOX.union(other).toString());
    assertEquals(BOX.toString(), BOX.union(BoundingBox.EMPTY).toString());
    assertEquals(BOX.toString(), BoundingBox.EMPTY.union(BOX).toString());
    assertEquals(BoundingBox.UNBOUNDED.toString(), BOX.union(BoundingBox.UNBOUNDED).toString());
    assertTrue(BoundingBox.EMPTY.union(BoundingBox.EMPTY).isEmpty());
  }

  @Test
  void onlyBoxesOfFiniteCornersAreFinite() {
    assertTrue(BOX.isFinite());
    assertFalse(BoundingBox.EMPTY.isFinite());
    assertFalse(BoundingBox.UNBOUNDED.isFinite());
    final Point3D o = new Point3D();
    for (final Point3D far : new Point3D[] {new Point3D(INF, 0, 0), new Point3D(0, INF, 0), new Point3D(0, 0, INF)}) {
      assertFalse(new BoundingBox(o, far).isFinite());
      far.negate();
      assertFalse(new BoundingBox(far, o).isFinite());
    }
    assertFalse(BOX.isEmpty());
    assertFalse(BoundingBox.UNBOUNDED.isEmpty());
  }

  @Test
  void boundaryBelongsToTheBox() {
    for (final Point3D P : new Point3D[] {new Point3D(-1, 0, 2), new Point3D(3, 4, 2), new Point3D(0, 0, 2),
        new Point3D(1, 1, 2)}) {
      assertTrue(BOX.contains(P), P::toString);
    }
    for (final Point3D P : new Point3D[] {new Point3D(Math.nextDown(-1f), 0, 2), new Point3D(Math.nextUp(3f), 4, 2),
        new Point3D(0, -Float.MIN_VALUE, 2), new Point3D(1, Math.nextUp(4f), 2), new Point3D(1, 1, Math.nextUp(2f)),
        new Point3D(1, 1, Math.nextDown(2f)), new Point3D(Float.NaN, 1, 2), new Point3D(1, 1, Float.NaN)}) {
      assertFalse(BOX.contains(P), P::toString);
    }
    assertTrue(BoundingBox.UNBOUNDED.contains(new Point3D(1e30f, -1e30f, 0)));
    assertFalse(BoundingBox.EMPTY.contains(new Point3D()));
  }

  @Test
  void computedBoxesAreRoundedOutwards() {
    final BoundingBox box = BoundingBox.around(0.1, 0, -7, 0.2, 0, 1e-30);
    assertTrue(box.minX() < 0.1 - 0.2 && box.maxX() > 0.1 + 0.2, box::toString);
    assertTrue(box.minY() < 0 && box.maxY() > 0, box::toString);
    assertTrue(box.minZ() < -7 && box.maxZ() > -7, box::toString);
    assertEquals(0.3, box.maxX(), 1e-6);
    final BoundingBox touching = BoundingBox.around(5, 5, 5, 5, 5, 5);
    assertTrue(touching.minX() < -1e-15 && touching.minX() > -1e-12, "no wider than rounding: " + touching);
  }

  @Test
  void computedBoxOfNaNIsUnbounded() {
    assertSame(BoundingBox.UNBOUNDED, BoundingBox.around(0, Double.NaN, 0, 1, 1, 1));
    assertSame(BoundingBox.UNBOUNDED, BoundingBox.around(0, 0, 0, 1, 1, Double.NaN));
    assertSame(BoundingBox.UNBOUNDED, BoundingBox.between(0, 0, 0, Double.NaN, 1, 1));
    assertFalse(BoundingBox.around(1e39, 0, 0, 1e39, 1, 1).isFinite());
  }

  @Test
  void raysThatMeetItCrossIt() {
    assertTrue(BOX.isCrossedBy(1, 1, 9, 0, 0, -1));
    assertTrue(BOX.isCrossedBy(1, 1, 9, -0.0, -0.0, -1));
    assertTrue(BOX.isCrossedBy(-9, -8, 2, 1, 1, 0));
    assertTrue(BOX.isCrossedBy(1, 1, 2, 0.6, 0, 0.8));
    assertTrue(BOX.isCrossedBy(3, 9, 2, 0, -1, 0));
    assertTrue(BOX.isCrossedBy(3, 9, 2, -0.0, -1, -0.0));
    assertTrue(BOX.isCrossedBy(3, 4, 2, 0, 1, 0));
  }

  @Test
  void raysThatPassItByDoNot() {
    assertFalse(BOX.isCrossedBy(1, 1, 9, 0, 0, 1));
    assertFalse(BOX.isCrossedBy(Math.nextUp(3f), 9, 2, 0, -1, 0));
    assertFalse(BOX.isCrossedBy(3, 9, Math.nextDown(2f), -0.0, -1, -0.0));
    assertFalse(BOX.isCrossedBy(-9, -8, 3, 0.6, 0.8, 0));
    assertFalse(BOX.isCrossedBy(4, 5, 2, 0.6, 0.8, 0));
  }

  @Test
  void raysOfNaNCrossNothingAndAllOthersCrossAllOfSpace() {
    assertFalse(BOX.isCrossedBy(Double.NaN, 1, 9, 0, 0, -1));
    assertFalse(BOX.isCrossedBy(1, 1, 9, 0, 0, Double.NaN));
    assertTrue(BoundingBox.UNBOUNDED.isCrossedBy(1, 1, 9, 0, 0, -1));
    assertTrue(BoundingBox.UNBOUNDED.isCrossedBy(1e30, 1, 9, -0.6, 0.8, -0.0));
    assertFalse(BoundingBox.EMPTY.isCrossedBy(1, 1, 9, 0, 0, -1));
    assertFalse(BoundingBox.EMPTY.isCrossedBy(0, 0, 0, 0.6, 0, 0.8));
  }

  @Test
  void noRayThroughAPointOfTheBoxPassesItBy() {
    Trials.of(20_000, random -> {
      final float size = (float) Math.pow(2, random.nextInt(60) - 30);
      final Point3D min = point(random, size), P = point(random, size / 2), max = new Point3D(min);
      P.add(min);
      P.absolute();
      min.absolute();
      max.set(Math.max(min.x, P.x), Math.max(min.y, P.y), Math.max(min.z, P.z));
      min.set(Math.min(min.x, P.x), Math.min(min.y, P.y), Math.min(min.z, P.z));
      final double x = random.nextGaussian(), y = random.nextInt(4) == 0 ? 0 : random.nextGaussian(),
          z = random.nextInt(4) == 0 ? -0.0 : random.nextGaussian();
      final double length = Math.sqrt(x * x + y * y + z * z), t = size * Math.pow(2, random.nextInt(12) - 4);
      final BoundingBox box = BoundingBox.between(min.x, min.y, min.z, max.x, max.y, max.z);
      assertTrue(box.isCrossedBy(P.x - t * x / length, P.y - t * y / length, P.z - t * z / length, x / length, y / length,
          z / length),
          () -> box + " and a ray at " + P + " along " + x + ", " + y + ", " + z);
    });
  }

  private static Point3D point(final Random random, final float size) {
    return new Point3D(size * (random.nextFloat() - 0.5f), size * (random.nextFloat() - 0.5f),
        size * (random.nextFloat() - 0.5f));
  }
}
