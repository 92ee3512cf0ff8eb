package acceleration;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Random;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.ForkJoinPool;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

import trials.Trials;

/** A tree of boxes against the linear scan. */
class BvhTest {

  private static final int[] COUNTS = {1, 2, 3, 5, 17, 100, 1500};

  /** A tree with the order of its boxes. */
  private record Tree(Boxes boxes, Bvh bvh, int[] order, int leaf) {

    static Tree over(final Boxes boxes, final int leaf) {
      final int[] order = new int[boxes.count()];
      return new Tree(boxes, Bvh.over(boxes.numbers.clone(), leaf, order), order, leaf);
    }

    /** The boxes whose leaves a ray visits. */
    BitSet visited(final double[] start, final double[] direction) {
      final BitSet visited = new BitSet();
      bvh.closest(start[0], start[1], start[2], direction[0], direction[1], direction[2], (first, end) -> {
        add(visited, first, end);
        return Double.POSITIVE_INFINITY;
      });
      return visited;
    }

    void add(final BitSet visited, final int first, final int end) {
      assertTrue(first < end && end - first <= leaf, () -> "leaf " + first + " … " + end);
      for (int place = first; place < end; place++) {
        assertFalse(visited.get(order[place]), () -> "box visited twice");
        visited.set(order[place]);
      }
    }

    /** The least distance at which a ray enters a box. */
    double nearest(final double[] start, final double[] direction) {
      final double[] nearest = {Double.POSITIVE_INFINITY};
      bvh.closest(start[0], start[1], start[2], direction[0], direction[1], direction[2], (first, end) -> {
        for (int place = first; place < end; place++) {
          nearest[0] = Math.min(nearest[0], boxes.enter(order[place], start, direction));
        }
        return nearest[0];
      });
      return nearest[0];
    }
  }

  private static double[] start(final Random random, final Boxes boxes) {
    final float[] at = boxes.pointOf(random, random.nextInt(boxes.count()));
    final double away = random.nextInt(3) == 0 ? 0 : Math.pow(10, 4 * random.nextDouble() - 2);
    return new double[] {(float) (at[0] + away * random.nextGaussian()), (float) (at[1] + away * random.nextGaussian()),
        random.nextBoolean() ? at[2] : (float) (at[2] + away * random.nextGaussian())};
  }

  /** Towards a point of some box, or along axes, with zeros of either sign. */
  private static double[] direction(final Random random, final Boxes boxes, final double[] start) {
    final float[] to = boxes.pointOf(random, random.nextInt(boxes.count()));
    final double[] v = {to[0] - start[0], to[1] - start[1], to[2] - start[2]};
    if (random.nextInt(3) == 0) {
      v[random.nextInt(3)] = random.nextBoolean() ? 0.0 : -0.0;
      v[random.nextInt(3)] = random.nextBoolean() ? 0.0 : -0.0;
    }
    final double length = Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    return length > 0 ? new double[] {v[0] / length, v[1] / length, v[2] / length} : new double[] {-0.0, 0, -1};
  }

  private static String ray(final double[] start, final double[] direction) {
    return "ray from " + Arrays.toString(start) + " along " + Arrays.toString(direction);
  }

  @ParameterizedTest
  @EnumSource
  void aRayVisitsEveryBoxThatItMeets(final Boxes.Kind kind) {
    final long[] hits = {0};
    Trials.of(50, random -> {
      final Boxes boxes = Boxes.random(random, kind, COUNTS[random.nextInt(COUNTS.length)]);
      final Tree tree = Tree.over(boxes, 1 + random.nextInt(Bvh.MOST_IN_LEAF));
      for (int i = 0; i < 40; i++) {
        final double[] start = start(random, boxes), direction = direction(random, boxes, start);
        final BitSet visited = tree.visited(start, direction);
        for (int box = 0; box < boxes.count(); box++) {
          if (boxes.enter(box, start, direction) < Double.POSITIVE_INFINITY) {
            hits[0]++;
            assertTrue(visited.get(box), () -> ray(start, direction));
          }
        }
      }
    });
    assertTrue(hits[0] > 1000, () -> "only " + hits[0] + " boxes hit");
  }

  @ParameterizedTest
  @EnumSource
  void theNearestBoxIsThatOfTheLinearScan(final Boxes.Kind kind) {
    final long[] hits = {0};
    Trials.of(50, random -> {
      final Boxes boxes = Boxes.random(random, kind, COUNTS[random.nextInt(COUNTS.length)]);
      final Tree tree = Tree.over(boxes, 1 + random.nextInt(Bvh.MOST_IN_LEAF));
      for (int i = 0; i < 40; i++) {
        final double[] start = start(random, boxes), direction = direction(random, boxes, start);
        double nearest = Double.POSITIVE_INFINITY;
        for (int box = 0; box < boxes.count(); box++) {
          nearest = Math.min(nearest, boxes.enter(box, start, direction));
        }
        hits[0] += nearest < Double.POSITIVE_INFINITY ? 1 : 0;
        assertEquals(nearest, tree.nearest(start, direction), () -> ray(start, direction));
      }
    });
    assertTrue(hits[0] > 200, () -> "only " + hits[0] + " boxes hit");
  }

  @Test
  void aZeroOfEitherSignIsTheSameDirection() {
    final Tree tree = Tree.over(new Boxes(-1, -1, -1, 1, 1, 1, 4, 4, 4, 5, 5, 5), 1);
    for (final double zero : new double[] {0.0, -0.0}) {
      assertEquals(4, tree.nearest(new double[] {0, 0, 5}, new double[] {zero, zero, -1}));
      assertEquals(4, tree.nearest(new double[] {0, -5, 0.5}, new double[] {zero, 1, zero}));
      assertEquals(0, tree.nearest(new double[] {1, 0, 0}, new double[] {-1, zero, zero}));
      assertEquals(2, tree.nearest(new double[] {-1, 1, 3}, new double[] {zero, zero, -1}));
    }
  }

  @ParameterizedTest
  @ValueSource(floats = {0x1p-100f, 0x1p-60f, 0x1p60f, 0x1p100f})
  void sizesDoNotMatter(final float scale) {
    Trials.of(50, random -> {
      final Boxes boxes = Boxes.random(random, Boxes.Kind.SCATTERED, 50);
      final Tree tree = Tree.over(boxes, 2), scaled = Tree.over(boxes.times(scale), 2);
      for (int i = 0; i < 20; i++) {
        final double[] start = start(random, boxes), direction = direction(random, boxes, start);
        final double[] there = {start[0] * scale, start[1] * scale, start[2] * scale};
        assertEquals(tree.nearest(start, direction) * scale, scaled.nearest(there, direction));
      }
    });
  }

  @Test
  void nothingIsVisitedInATreeOfNothing() {
    final Bvh nothing = Bvh.over(new float[0], 4, new int[0]);
    final RayTile tile = new RayTile();
    tile.open(1, 1);
    tile.put(0, 0, 0, 0, 0, 0, -1);
    tile.close();
    nothing.closest(0, 0, 0, 0, 0, -1, (first, end) -> fail("visited"));
    nothing.closest(tile.frustum(), (first, end) -> fail("visited"));
  }

  @Test
  void aRayOfNaNComesToAnEnd() {
    final Tree tree = Tree.over(Boxes.random(new Random(1), Boxes.Kind.SCATTERED, 1000), 2);
    final double nan = Double.NaN;
    tree.visited(new double[] {nan, nan, nan}, new double[] {nan, nan, nan});
    tree.visited(new double[] {0, 0, 0}, new double[] {nan, nan, nan});
    tree.visited(new double[] {Double.POSITIVE_INFINITY, 0, 0}, new double[] {1, 0, 0});
  }

  @Test
  void whatLiesBeyondTheDistanceAnsweredIsLeftOut() {
    final float[] numbers = new float[600];
    for (int i = 0; i < 100; i++) {
      System.arraycopy(new float[] {i, -1, -1, i + 0.5f, 1, 1}, 0, numbers, 6 * i, 6);
    }
    final Tree tree = Tree.over(new Boxes(numbers), 1);
    final BitSet visited = new BitSet();
    tree.bvh.closest(-1, 0, 0, 1, 0, 0, (first, end) -> {
      tree.add(visited, first, end);
      return 3.2;
    });
    assertTrue(visited.get(0) && visited.get(1) && visited.get(2), visited::toString);
    assertTrue(visited.cardinality() < 6, visited::toString);
  }

  @ParameterizedTest
  @EnumSource
  void everyBoxHasOnePlace(final Boxes.Kind kind) {
    Trials.of(20, random -> {
      final Boxes boxes = Boxes.random(random, kind, random.nextInt(3000));
      final int[] order = Tree.over(boxes, 1 + random.nextInt(Bvh.MOST_IN_LEAF)).order;
      final BitSet seen = new BitSet();
      for (final int box : order) {
        seen.set(box);
      }
      assertEquals(boxes.count(), seen.cardinality());
      assertEquals(boxes.count(), seen.length());
    });
  }

  @Test
  void noOrderOfBoxesMakesTheTreeTooDeep() {
    final int n = 20_000;
    final float[] numbers = new float[6 * n];
    for (int i = 0; i < n; i++) {
      final float at = (float) Math.pow(10, 76.0 * i / n - 38);
      System.arraycopy(new float[] {-at, -at, at, at, at, at}, 0, numbers, 6 * i, 6);
    }
    final Tree tree = Tree.over(new Boxes(numbers), 1);
    assertEquals(n, tree.visited(new double[] {0, 0, 0}, new double[] {0, 0, 1}).cardinality());
  }

  /** The leaves, from first to end, that an independent serial builder finds. */
  private static final class Serial {

    final SortedMap<Integer, Integer> leaves = new TreeMap<>();
    final int[] order;
    private final Bins bins;
    private final int leaf;

    Serial(final float[] boxes, final int leaf) {
      order = new int[boxes.length / 6];
      for (int i = 0; i < order.length; i++) {
        order[i] = i;
      }
      this.leaf = leaf;
      bins = new Bins(boxes, order);
      build(0, order.length, BoxBuilder.ofCentres(boxes, 0, order.length), 0);
    }

    private void build(final int first, final int end, final BoxBuilder centres, final int level) {
      if (end - first <= leaf) {
        leaves.put(first, end);
        return;
      }
      final Split binned = level < 48 ? bins.split(first, end, centres) : null;
      final Split split = binned != null ? binned : bins.halve(first, end);
      build(first, split.middle, split.leftCentres, level + 1);
      build(split.middle, end, split.rightCentres, level + 1);
    }
  }

  @ParameterizedTest
  @EnumSource(names = {"SCATTERED", "EQUAL", "ALL_SCALES"})
  void severalThreadsBuildTheSameTreeAsOne(final Boxes.Kind kind) throws Exception {
    final Boxes boxes = Boxes.random(new Random(7), kind, 50_000);
    final Serial serial = new Serial(boxes.numbers.clone(), 4);
    final Tree tree = Tree.over(boxes, 4);
    final ForkJoinPool four = new ForkJoinPool(4);
    final Tree byFour = four.submit(() -> Tree.over(boxes, 4)).get();
    four.shutdown();
    assertArrayEquals(serial.order, tree.order);
    assertArrayEquals(serial.order, byFour.order);
    final Random random = new Random(8);
    for (int i = 0; i < 20; i++) {
      final double[] start = start(random, boxes), direction = direction(random, boxes, start);
      assertEquals(tree.visited(start, direction), byFour.visited(start, direction));
      tree.bvh.closest(start[0], start[1], start[2], direction[0], direction[1], direction[2], (first, end) -> {
        assertEquals(end, serial.leaves.get(first));
        return Double.POSITIVE_INFINITY;
      });
    }
  }
}
