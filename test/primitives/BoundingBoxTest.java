package primitives;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
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
    assertFalse(new BoundingBox(o, o).isEmpty(), "the box of a single point contains it");
  }

  /** A plane perpendicular to an axis has a box that is unbounded along the other two. */
  @Test
  void sidesAtInfinityLeaveTheOtherSidesAsTheyAre() {
    assertSides(BoundingBox.between(-INF, -INF, 2, INF, INF, 3), -INF, -INF, Math.nextDown(2f), INF, INF, Math.nextUp(3f));
    assertSides(BoundingBox.between(-INF, 2, -INF, INF, 3, INF), -INF, Math.nextDown(2f), -INF, INF, Math.nextUp(3f), INF);
    assertSides(BoundingBox.between(2, -INF, -INF, 3, INF, INF), Math.nextDown(2f), -INF, -INF, Math.nextUp(3f), INF, INF);
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
  void everySideOfAComputedBoxIsRoundedOutwards() {
    final BoundingBox box = BoundingBox.between(0.1, 0.2, 0.7, 1.1, 1.3, 1.7);
    assertTrue(box.minX() < 0.1 && box.minY() < 0.2 && box.minZ() < 0.7, box::toString);
    assertTrue(box.maxX() > 1.1 && box.maxY() > 1.3 && box.maxZ() > 1.7, box::toString);
    final BoundingBox mirrored = BoundingBox.between(-1.1, -1.3, -1.7, -0.1, -0.2, -0.7);
    assertTrue(mirrored.minX() < -1.1 && mirrored.minY() < -1.3 && mirrored.minZ() < -1.7, mirrored::toString);
    assertTrue(mirrored.maxX() > -0.1 && mirrored.maxY() > -0.2 && mirrored.maxZ() > -0.7, mirrored::toString);
  }

  /** Of a box of doubles each side is the float next to the rounded one, outwards; none is farther out. */
  @Test
  void everySideOfABoxOfDoublesIsTheNextFloatOutwards() {
    assertSides(BoundingBox.between(1, 2, 3, 5, 6, 7), Math.nextDown(1f), Math.nextDown(2f), Math.nextDown(3f),
        Math.nextUp(5f), Math.nextUp(6f), Math.nextUp(7f));
    assertSides(BoundingBox.between(-7, -6, -5, -3, -2, -1), Math.nextDown(-7f), Math.nextDown(-6f), Math.nextDown(-5f),
        Math.nextUp(-3f), Math.nextUp(-2f), Math.nextUp(-1f));
  }

  /** A side that comes to lie at 0 is moved outwards by 2⁻⁴⁸ of centre and half extent, on every axis and either side. */
  @Test
  void everySideThatLiesAtZeroIsWidenedByTheRoundingOfDoubles() {
    final float x = Math.nextUp(0x1p-48f * 10), y = Math.nextUp(0x1p-48f * 14), z = Math.nextUp(0x1p-48f * 18);
    final float farX = Math.nextUp(10f), farY = Math.nextUp(14f), farZ = Math.nextUp(18f);
    assertSides(BoundingBox.around(5, 7, 9, 5, 7, 9), -x, -y, -z, farX, farY, farZ);
    assertSides(BoundingBox.around(-5, -7, -9, 5, 7, 9), -farX, -farY, -farZ, x, y, z);
    assertSides(BoundingBox.around(0, 0, 0, 0, 0, 0), -Float.MIN_VALUE, -Float.MIN_VALUE, -Float.MIN_VALUE,
        Float.MIN_VALUE, Float.MIN_VALUE, Float.MIN_VALUE);
  }

  private static void assertSides(final BoundingBox box, final float... sides) {
    assertArrayEquals(sides, new float[] {box.minX(), box.minY(), box.minZ(), box.maxX(), box.maxY(), box.maxZ()},
        box::toString);
  }

  @Test
  void aBoxOfOneNaNIsUnbounded() {
    for (int i = 0; i < 6; i++) {
      final double[] v = {1, 2, 3, 5, 6, 7};
      v[i] = Double.NaN;
      assertSame(BoundingBox.UNBOUNDED, BoundingBox.between(v[0], v[1], v[2], v[3], v[4], v[5]));
      assertSame(BoundingBox.UNBOUNDED, BoundingBox.around(v[0], v[1], v[2], v[3], v[4], v[5]));
    }
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

  /** Rays at edges, where rounding decides: none that hits the box in exact arithmetic is reported to miss it. */
  @Test
  void noRayThatExactlyMeetsItPassesItBy() {
    final int[] hits = {0};
    Trials.of(4000, random -> {
      final Point3D P = point(random, 1), Q = point(random, 1);
      final float[] min = least(P, Q), max = greatest(P, Q);
      final double[] start = new double[3], direction = new double[3];
      final double k = random.nextDouble();
      for (int i = 0; i < 3; i++) {
        start[i] = 3 * random.nextGaussian();
        final double edge = i == 2 ? min[2] + 0.5 * (max[2] - min[2]) : random.nextBoolean() ? min[i] : max[i];
        direction[i] = k * (edge - start[i]);
      }
      if (meetsExactly(min, max, start, direction)) {
        hits[0]++;
        assertTrue(new BoundingBox(corner(min), corner(max))
            .isCrossedBy(start[0], start[1], start[2], direction[0], direction[1], direction[2]));
      }
    });
    assertTrue(hits[0] > 1000, () -> hits[0] + " rays hit their box");
  }

  /** Every other ray misses the box widened by a millionth: none of them is reported to hit the box. */
  @Test
  void raysThatMissItByMoreThanRoundingDoNotCrossIt() {
    final int[] miss = {0};
    Trials.of(4000, random -> {
      final Point3D P = point(random, 1), Q = point(random, 1);
      final float[] min = least(P, Q), max = greatest(P, Q), lower = min.clone(), upper = max.clone();
      final double[] start = new double[3], direction = new double[3];
      for (int i = 0; i < 3; i++) {
        lower[i] -= 1e-6f;
        upper[i] += 1e-6f;
        start[i] = random.nextGaussian();
        direction[i] = 0.5 * random.nextGaussian() - start[i];
      }
      if (!meetsExactly(lower, upper, start, direction)) {
        miss[0]++;
        assertFalse(new BoundingBox(corner(min), corner(max))
            .isCrossedBy(start[0], start[1], start[2], direction[0], direction[1], direction[2]));
      }
    });
    assertTrue(miss[0] > 1000, () -> miss[0] + " rays miss their box");
  }

  private static float[] least(final Point3D P, final Point3D Q) {
    return new float[] {Math.min(P.x, Q.x), Math.min(P.y, Q.y), Math.min(P.z, Q.z)};
  }

  private static float[] greatest(final Point3D P, final Point3D Q) {
    return new float[] {Math.max(P.x, Q.x), Math.max(P.y, Q.y), Math.max(P.z, Q.z)};
  }

  /** The slab test without rounding: the distances are fractions, and no division is carried out. */
  private static boolean meetsExactly(final float[] min, final float[] max, final double[] start, final double[] direction) {
    boolean hits = true;
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        final BigDecimal enter = times(direction[i] > 0 ? min[i] : max[i], start[i], direction[i], direction[j]);
        final BigDecimal leave = times(direction[j] > 0 ? max[j] : min[j], start[j], direction[j], direction[i]);
        hits &= enter.compareTo(leave) <= 0;
      }
      hits &= (direction[i] > 0 ? max[i] : min[i]) * direction[i] >= start[i] * direction[i];
    }
    return hits;
  }

  /** (side − start) · |other| with the sign of the direction: a distance times both lengths. */
  private static BigDecimal times(final double side, final double start, final double direction, final double other) {
    final BigDecimal way = new BigDecimal(side).subtract(new BigDecimal(start)).multiply(new BigDecimal(Math.abs(other)));
    return direction > 0 ? way : way.negate();
  }

  private static Point3D corner(final float[] x) {
    return new Point3D(x[0], x[1], x[2]);
  }

  private static Point3D point(final Random random, final float size) {
    return new Point3D(size * (random.nextFloat() - 0.5f), size * (random.nextFloat() - 0.5f),
        size * (random.nextFloat() - 0.5f));
  }
}
