package acceleration;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;

import org.junit.jupiter.api.Test;

import trials.Trials;

/** Splits of nodes are the cheapest by the surface area heuristic among even cuts of the centres' extent. */
class SplitTest {

  /** The boxes of a node and their numbers. */
  private record Node(float[] boxes, int[] order) {

    static Node random(final Random random, final int count) {
      final float[] boxes = Boxes.random(random, Boxes.Kind.SCATTERED, count).numbers;
      final int axis = random.nextInt(3);
      for (int i = axis; i < boxes.length; i += 3) {
        boxes[i] *= 3;
      }
      final int[] order = new int[count];
      for (int i = 0; i < count; i++) {
        order[i] = i;
      }
      return new Node(boxes, order);
    }

    Bins bins() {
      return new Bins(boxes, order);
    }

    BoxBuilder centres(final int first, final int end) {
      return BoxBuilder.ofCentres(boxes, first, end);
    }

    double centre(final int i, final int axis) {
      return 0.5 * boxes[6 * i + axis] + 0.5 * boxes[6 * i + 3 + axis];
    }

    /** Least x, y, z and greatest of some boxes, or of their centres. */
    double[] extent(final int first, final int end, final boolean ofCentres) {
      final double[] extent = empty();
      for (int i = first; i < end; i++) {
        for (int k = 0; k < 3; k++) {
          extent[k] = Math.min(extent[k], ofCentres ? centre(i, k) : boxes[6 * i + k]);
          extent[k + 3] = Math.max(extent[k + 3], ofCentres ? centre(i, k) : boxes[6 * i + 3 + k]);
        }
      }
      return extent;
    }

    /** Number of boxes times half their surface, on either side of a place in the order. */
    double cost(final int middle) {
      return middle * area(extent(0, middle, false)) + (order.length - middle) * area(extent(middle, order.length, false));
    }

    /** The cost if the boxes whose centres lie before some part of an extent were on one side; infinity if all were. */
    double costOfCut(final int axis, final double[] centres, final double part) {
      final double cut = centres[axis] + part * (centres[axis + 3] - centres[axis]);
      final double[][] sides = {empty(), empty()};
      final int[] counts = new int[2];
      for (int i = 0; i < order.length; i++) {
        final int side = centre(i, axis) < cut ? 0 : 1;
        counts[side]++;
        for (int k = 0; k < 3; k++) {
          sides[side][k] = Math.min(sides[side][k], boxes[6 * i + k]);
          sides[side][k + 3] = Math.max(sides[side][k + 3], boxes[6 * i + 3 + k]);
        }
      }
      return counts[0] == 0 || counts[1] == 0 ? Double.POSITIVE_INFINITY
          : counts[0] * area(sides[0]) + counts[1] * area(sides[1]);
    }
  }

  private static double[] empty() {
    return new double[] {1e30, 1e30, 1e30, -1e30, -1e30, -1e30};
  }

  private static double area(final double[] box) {
    final double x = box[3] - box[0], y = box[4] - box[1], z = box[5] - box[2];
    return x * y + y * z + z * x;
  }

  private static double[] stored(final BoxBuilder builder) {
    final float[] box = new float[6];
    builder.store(box, 0);
    final double[] doubles = new double[6];
    for (int k = 0; k < 6; k++) {
      doubles[k] = box[k];
    }
    return doubles;
  }

  private static int longest(final double[] extent) {
    final double x = extent[3] - extent[0], y = extent[4] - extent[1], z = extent[5] - extent[2];
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  }

  /** Of fewer than 16 boxes at a quarter of the extent, of fewer than 128 at an eighth, of more at a sixteenth. */
  @Test
  void aSplitIsTheCheapestOfTheEvenCuts() {
    final int[] splits = {0};
    Trials.of(600, random -> {
      final int count = 2 + random.nextInt(random.nextBoolean() ? 14 : 400);
      final Node node = Node.random(random, count);
      final double[] centres = node.extent(0, count, true);
      final int axis = longest(centres), cuts = count < 16 ? 4 : count < 128 ? 8 : 16;
      double least = Double.POSITIVE_INFINITY;
      for (int i = 1; i < cuts; i++) {
        least = Math.min(least, node.costOfCut(axis, centres, (double) i / cuts));
      }
      final Split split = node.bins().split(0, count, node.centres(0, count));
      if (least == Double.POSITIVE_INFINITY) {
        assertNull(split);
      } else {
        splits[0]++;
        assertEquals(least, node.cost(split.middle), 1e-5 * least);
        assertComplete(node, 0, count, split);
        for (int i = 0; i < count; i++) {
          assertTrue(i < split.middle ? node.centre(i, axis) <= node.extent(split.middle, count, true)[axis]
              : node.centre(i, axis) >= node.extent(0, split.middle, true)[axis + 3]);
        }
      }
    });
    assertTrue(splits[0] > 500, () -> "splits: " + splits[0]);
  }

  /** Both sides have boxes, which the boxes and the extents of centres of the split are about. */
  private static void assertComplete(final Node node, final int first, final int end, final Split split) {
    assertTrue(first < split.middle && split.middle < end);
    assertArrayEquals(node.extent(first, split.middle, false), stored(split.left));
    assertArrayEquals(node.extent(split.middle, end, false), stored(split.right));
    assertArrayEquals(node.extent(first, split.middle, true), stored(split.leftCentres), 1e-6);
    assertArrayEquals(node.extent(split.middle, end, true), stored(split.rightCentres), 1e-6);
  }

  @Test
  void partOfAnOrderIsSplitByItselfAndTheRestStays() {
    Trials.of(200, random -> {
      final Node node = Node.random(random, 40);
      final float[] before = node.boxes.clone();
      final Split split = node.bins().split(10, 30, node.centres(10, 30));
      assertComplete(node, 10, 30, split);
      for (int i = 0; i < 40; i++) {
        assertTrue(i >= 10 && i < 30 || node.order[i] == i);
        for (int k = 0; k < 6; k++) {
          assertEquals(before[6 * node.order[i] + k], node.boxes[6 * i + k], "boxes move with their numbers");
        }
      }
    });
  }

  @Test
  void halvesAreHalves() {
    Trials.of(100, random -> {
      final Node node = Node.random(random, 41);
      final Split split = node.bins().halve(10, 31);
      assertEquals(20, split.middle);
      assertComplete(node, 10, 31, split);
    });
  }
}
