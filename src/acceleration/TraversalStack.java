package acceleration;

import java.util.Arrays;

/**
 * The pending links of traversals by single rays, one stack for each thread, so that a ray allocates nothing. A tree in a
 * leaf of another one, traversed during a visit to that leaf, uses the places above those in use.
 */
final class TraversalStack {

  private static final ThreadLocal<TraversalStack> OF_THREAD = ThreadLocal.withInitial(TraversalStack::new);

  private int[] links = new int[256];
  private int used;

  private TraversalStack() {
    super();
  }

  /** The stack of the calling thread. */
  static TraversalStack ofThread() {
    return OF_THREAD.get();
  }

  /** Number of places in use: where the next traversal begins. */
  int used() {
    return used;
  }

  /**
   * Reserves places for a traversal, which has to return them by {@link #release}, even if it fails.
   *
   * @param count how many
   * @return the array of all places; those from {@link #used} before the call on are the traversal's own, and stay so while
   *     traversals within it make the array grow
   */
  int[] take(final int count) {
    final int end = used + count;
    if (end > links.length) {
      links = Arrays.copyOf(links, Math.max(end, 2 * links.length));
    }
    used = end;
    return links;
  }

  /** Releases the places from one on. */
  void release(final int base) {
    used = base;
  }
}
