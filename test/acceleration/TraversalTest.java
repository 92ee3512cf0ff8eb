package acceleration;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Random;
import java.util.function.BiPredicate;

import org.junit.jupiter.api.Test;

import trials.Trials;

/** Which leaves of a tree a ray visits, when, and which it does not. */
class TraversalTest {

  private static final int[] COUNTS = {2, 9, 60, 700};

  private static double[] unit(final double x, final double y, final double z) {
    final double length = Math.sqrt(x * x + y * y + z * z);
    return new double[] {x / length, y / length, z / length};
  }

  private static double[] gauss(final Random random, final double scale) {
    return new double[] {scale * random.nextGaussian(), scale * random.nextGaussian(), scale * random.nextGaussian()};
  }

  /** The box about the boxes of a leaf. */
  private static Boxes about(final Boxes boxes, final int[] order, final int first, final int end) {
    final BoxBuilder builder = new BoxBuilder();
    for (int place = first; place < end; place++) {
      builder.add(boxes.numbers, 6 * order[place]);
    }
    final float[] numbers = new float[6];
    builder.store(numbers, 0);
    return new Boxes(numbers);
  }

  /** A tree, a ray, and where it enters the boxes. */
  private record Query(Boxes boxes, int[] order, Bvh tree, double[] start, double[] direction) {

    static Query random(final Random random) {
      final Boxes boxes = Boxes.random(random, Boxes.Kind.SCATTERED, COUNTS[random.nextInt(COUNTS.length)]);
      final int[] order = new int[boxes.count()];
      final Bvh tree = Bvh.over(boxes.numbers.clone(), 1, order);
      final double[] start = gauss(random, 3), to = gauss(random, 1);
      return new Query(boxes, order, tree, start, unit(to[0] - start[0], to[1] - start[1], to[2] - start[2]));
    }

    double enter(final int place) {
      return boxes.enter(order[place], start, direction);
    }

    double enterLeaf(final int first, final int end) {
      return about(boxes, order, first, end).enter(0, start, direction);
    }

    boolean any(final double tmax, final BiPredicate<Integer, Integer> leaves) {
      return tree.any(start[0], start[1], start[2], direction[0], direction[1], direction[2], tmax, leaves::test);
    }
  }

  @Test
  void onlyLeavesThatTheRayMeetsAreVisited() {
    final int[] visits = {0};
    Trials.of(1000, random -> {
      final Query query = Query.random(random);
      query.tree.closest(query.start[0], query.start[1], query.start[2],
          query.direction[0], query.direction[1], query.direction[2], (first, end) -> {
            visits[0]++;
            assertTrue(query.enterLeaf(first, end) < Double.POSITIVE_INFINITY);
            return Double.POSITIVE_INFINITY;
          });
    });
    assertTrue(visits[0] > 2000, () -> "visits: " + visits[0]);
  }

  /** What is asked for anything before a distance visits what lies before it, and nothing beyond. */
  @Test
  void everyBoxBeforeTheLimitIsVisitedAndNoLeafBeyond() {
    final int[] visits = {0, 0};
    Trials.of(3000, random -> {
      final Query query = Query.random(random);
      final double limit = 5 * random.nextDouble();
      final BitSet visited = new BitSet();
      assertFalse(query.any(limit, (first, end) -> {
        assertTrue(query.enterLeaf(first, end) <= limit);
        visited.set(first, end);
        return false;
      }));
      for (int place = 0; place < query.order.length; place++) {
        final boolean before = query.enter(place) <= limit;
        visits[before ? 0 : 1]++;
        assertTrue(!before || visited.get(place));
      }
    });
    assertTrue(visits[0] > 1000 && visits[1] > 1000, () -> visits[0] + " before, " + visits[1] + " beyond");
  }

  @Test
  void theFirstLeafThatSaysYesEndsTheSearch() {
    Trials.of(500, random -> {
      final Query query = Query.random(random);
      final int[] visits = {0}, all = {0};
      query.any(1e9, (first, end) -> {
        all[0]++;
        return false;
      });
      final int last = 1 + random.nextInt(Math.max(1, all[0]));
      assertEquals(all[0] > 0, query.any(1e9, (first, end) -> ++visits[0] == last));
      assertEquals(Math.min(all[0], last), visits[0]);
    });
  }

  /** Boxes in a row, seen from either end along either axis: the nearest is visited first. */
  @Test
  void boxesInARowAreVisitedFromTheNearestOn() {
    for (int axis = 0; axis < 3; axis++) {
      final float[] numbers = new float[6 * 64];
      for (int i = 0; i < 64; i++) {
        for (int k = 0; k < 3; k++) {
          numbers[6 * i + k] = k == axis ? 37 * i % 64 : -1;
          numbers[6 * i + 3 + k] = k == axis ? 37 * i % 64 + 0.5f : 1;
        }
      }
      final int[] order = new int[64];
      final Bvh tree = Bvh.over(numbers.clone(), 1, order);
      for (final int sign : new int[] {1, -1}) {
        final double[] start = {0.1, 0.2, 0.3}, direction = new double[3];
        start[axis] = sign > 0 ? -5 : 70;
        direction[axis] = sign;
        final List<Integer> places = new ArrayList<>();
        tree.closest(start[0], start[1], start[2], direction[0], direction[1], direction[2], (first, end) -> {
          places.add(37 * order[first] % 64);
          return Double.POSITIVE_INFINITY;
        });
        assertEquals(64, places.size());
        for (int i = 0; i < 64; i++) {
          assertEquals(sign > 0 ? i : 63 - i, places.get(i));
        }
      }
    }
  }

  @Test
  void nothingBlocksInATreeOfNothingAndOnARayOfNaN() {
    final Bvh nothing = Bvh.over(new float[0], 1, new int[0]);
    assertFalse(nothing.any(0, 0, 0, 0, 0, 1, 1e9, (first, end) -> true));
    final Bvh one = Bvh.over(new float[] {-1, -1, -1, 1, 1, 1}, 1, new int[1]);
    assertTrue(one.any(0, 0, 0, 0, 0, 1, 1e9, (first, end) -> true));
    for (int i = 0; i < 6; i++) {
      final double[] r = {0, 0, 0, 0, 0, 1};
      r[i] = Double.NaN;
      assertFalse(one.any(r[0], r[1], r[2], r[3], r[4], r[5], 1e9, (first, end) -> true));
    }
  }
}
