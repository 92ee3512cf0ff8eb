package acceleration;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

/** Nested traversals. */
class TraversalStackTest {

  private static final int BOXES = 100;

  /** Nested so deep that the stack grows. */
  private static final int LEVELS = 60;

  private static final Bvh ROW = row();

  private static Bvh row() {
    final float[] boxes = new float[6 * BOXES];
    for (int i = 0; i < BOXES; i++) {
      System.arraycopy(new float[] {i, -1, -1, i + 0.5f, 1, 1}, 0, boxes, 6 * i, 6);
    }
    return Bvh.over(boxes, 1, new int[BOXES]);
  }

  /** Traverses the row, and at one visit in the middle the row again, to a depth; returns its own visits. */
  private static int closest(final int level, final boolean fails) {
    final int[] own = new int[1];
    ROW.closest(-1, 0, 0, 1, 0, 0, (first, end) -> {
      own[0] += end - first;
      if (own[0] == 3 && level > 0) {
        assertEquals(BOXES, level % 2 == 0 ? closest(level - 1, fails) : any(level - 1, fails));
      }
      fail(fails && level == 0);
      return Double.POSITIVE_INFINITY;
    });
    return own[0];
  }

  private static int any(final int level, final boolean fails) {
    final int[] own = new int[1];
    ROW.any(-1, 0, 0, 1, 0, 0, Double.POSITIVE_INFINITY, (first, end) -> {
      own[0] += end - first;
      if (own[0] == 3 && level > 0) {
        assertEquals(BOXES, level % 2 == 0 ? closest(level - 1, fails) : any(level - 1, fails));
      }
      fail(fails && level == 0);
      return false;
    });
    return own[0];
  }

  private static void fail(final boolean fails) {
    if (fails) {
      throw new IllegalStateException("a leaf that fails");
    }
  }

  @Test
  void aNestedTraversalLeavesTheOuterOneAsItWas() {
    assertEquals(BOXES, closest(LEVELS, false));
    assertEquals(BOXES, any(LEVELS, false));
    assertEquals(0, TraversalStack.ofThread().used());
  }

  @Test
  void aTraversalThatFailsGivesItsPlacesBack() {
    assertThrows(IllegalStateException.class, () -> closest(LEVELS, true));
    assertThrows(IllegalStateException.class, () -> any(LEVELS, true));
    assertEquals(0, TraversalStack.ofThread().used());
    assertEquals(BOXES, closest(1, false));
  }
}
