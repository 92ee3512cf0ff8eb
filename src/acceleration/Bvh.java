package acceleration;

/**
 * A bounding volume hierarchy: a binary tree of boxes over numbered primitives, to find those that a ray may hit without
 * testing all of them. Immutable, safe for use by several threads.
 *
 * <p>An inner node holds the boxes of its two children side by side in one array of floats, 12 of them, so that one visit
 * touches one place in memory, and two links in an array of ints. A link that is not negative is the number of an inner
 * node; a negative one is a leaf, ~(first · 8 + count − 1), of the primitives at the places first … first + count − 1 of the
 * order that building the tree has put them in.
 */
public final class Bvh {

  /** Greatest number of primitives in a leaf. */
  public static final int MOST_IN_LEAF = 8;

  /**
   * Factor by which the far side of a box is moved: for a subtraction and a multiplication by a rounded reciprocal on
   * either side.
   */
  private static final double FAR = 1 + 0x1p-49;

  /** A null link: no leaf has this number. */
  private static final int NOTHING = Integer.MIN_VALUE;

  /** The empty tree. */
  static final Bvh EMPTY = new Bvh(0, new float[6], new float[0], new int[0], -1, 0);

  /** The owner of the primitives of a tree. */
  public interface Leaves {

    /**
     * Tests the primitives of a leaf.
     *
     * @param first place of the first one
     * @param end place after the last one
     * @return the distance beyond which nothing matters any more; farther boxes are culled from now on
     */
    double visit(int first, int end);
  }

  /** The owner of the primitives of a tree, for any-hit queries. */
  public interface AnyLeaves {

    /**
     * Tests the primitives of a leaf.
     *
     * @param first place of the first one
     * @param end place after the last one
     * @return whether one of them is hit, which ends the search
     */
    boolean visit(int first, int end);
  }

  private final int size;
  private final float[] whole;
  private final float[] boxes;
  private final int[] links;
  private final int root;
  private final int depth;

  /** A tree of some primitives and finished nodes within a box; see the class comment for the arrays. */
  Bvh(final int size, final float[] whole, final float[] boxes, final int[] links, final int root, final int depth) {
    this.size = size;
    this.whole = whole;
    this.boxes = boxes;
    this.links = links;
    this.root = root;
    this.depth = depth;
  }

  /**
   * Builds the tree of some boxes.
   *
   * @param boxes six floats for each box: its least x, y, z, then its greatest, all finite; used as working space
   * @param leaf greatest number of primitives in a leaf, 1 … {@link #MOST_IN_LEAF}
   * @param order an element for each box; receives the number of the primitive at each place
   * @return the tree
   */
  public static Bvh over(final float[] boxes, final int leaf, final int[] order) {
    return new BvhBuilder(boxes, leaf, order).build();
  }

  static int leaf(final int first, final int count) {
    return ~(first * MOST_IN_LEAF + count - 1);
  }

  /**
   * Visits the leaves that one ray may hit, the nearer child of a node first; none for a ray of NaN.
   *
   * @param x first coordinate of the start
   * @param y second coordinate of the start
   * @param z third coordinate of the start
   * @param dx first component of the direction, of unit length
   * @param dy second component of the direction
   * @param dz third component of the direction
   * @param leaves the owner of the primitives
   */
  public void closest(final double x, final double y, final double z, final double dx, final double dy, final double dz,
      final Leaves leaves) {
    if (isEmpty() || Double.isNaN(x + y + z + dx + dy + dz)) {
      return;
    }
    final TraversalStack waiting = TraversalStack.ofThread();
    final int base = waiting.used();
    try {
      closest(x, y, z, 1 / dx, 1 / dy, 1 / dz, leaves, waiting.take(depth + 1), base);
    } finally {
      waiting.release(base);
    }
  }

  /** See above; takes reciprocals of the direction, and a stack that may be used from its place base on. */
  private void closest(final double x, final double y, final double z, final double ix, final double iy, final double iz,
      final Leaves leaves, final int[] stack, final int base) {
    final int nearX = ix < 0 ? 3 : 0, nearY = iy < 0 ? 4 : 1, nearZ = iz < 0 ? 5 : 2;
    int top = base, node = root;
    double farthest = Double.POSITIVE_INFINITY;
    while (true) {
      if (node < 0) {
        farthest = visit(node, leaves);
        if (top == base) {
          return;
        }
        node = stack[--top];
      } else {
        final int a = node * 12, b = a + 6;
        final double enterA = enter(a, nearX, nearY, nearZ, x, y, z, ix, iy, iz, farthest);
        final double enterB = enter(b, nearX, nearY, nearZ, x, y, z, ix, iy, iz, farthest);
        final boolean crossesA = enterA < Double.POSITIVE_INFINITY, crossesB = enterB < Double.POSITIVE_INFINITY;
        if (crossesA && crossesB) {
          final int nearer = enterB < enterA ? 1 : 0;
          stack[top++] = links[2 * node + 1 - nearer];
          node = links[2 * node + nearer];
        } else if (crossesA || crossesB) {
          node = links[2 * node + (crossesA ? 0 : 1)];
        } else if (top == base) {
          return;
        } else {
          node = stack[--top];
        }
      }
    }
  }

  /**
   * Whether any primitive is hit by one ray before a distance: visits leaves that the ray may hit until one is hit.
   *
   * @param x first coordinate of the start
   * @param y second coordinate of the start
   * @param z third coordinate of the start
   * @param dx first component of the direction, of unit length
   * @param dy second component of the direction
   * @param dz third component of the direction
   * @param tmax the distance
   * @param leaves the owner of the primitives
   * @return whether a leaf was hit; false for a ray of NaN
   */
  public boolean any(final double x, final double y, final double z, final double dx, final double dy, final double dz,
      final double tmax, final AnyLeaves leaves) {
    if (isEmpty() || Double.isNaN(x + y + z + dx + dy + dz)) {
      return false;
    }
    final TraversalStack waiting = TraversalStack.ofThread();
    final int base = waiting.used();
    try {
      return any(x, y, z, 1 / dx, 1 / dy, 1 / dz, tmax, leaves, waiting.take(depth + 1), base);
    } finally {
      waiting.release(base);
    }
  }

  private boolean any(final double x, final double y, final double z, final double ix, final double iy, final double iz,
      final double tmax, final AnyLeaves leaves, final int[] stack, final int base) {
    final int nearX = ix < 0 ? 3 : 0, nearY = iy < 0 ? 4 : 1, nearZ = iz < 0 ? 5 : 2;
    int top = base;
    stack[top++] = root;
    while (top > base) {
      int node = stack[--top];
      while (node >= 0) {
        final int a = node * 12;
        final boolean crossesA = enter(a, nearX, nearY, nearZ, x, y, z, ix, iy, iz, tmax) < Double.POSITIVE_INFINITY;
        final boolean crossesB = enter(a + 6, nearX, nearY, nearZ, x, y, z, ix, iy, iz, tmax) < Double.POSITIVE_INFINITY;
        if (crossesA && crossesB) {
          stack[top++] = links[2 * node + 1];
        }
        node = crossesA || crossesB ? links[2 * node + (crossesA ? 0 : 1)] : NOTHING;
      }
      if (node != NOTHING) {
        final int first = ~node / MOST_IN_LEAF;
        if (leaves.visit(first, first + ~node % MOST_IN_LEAF + 1)) {
          return true;
        }
      }
    }
    return false;
  }

  /**
   * Where a ray enters a box; infinity if it misses the box or enters it too far away. Comparisons drop the NaN of 0 · ∞.
   */
  private double enter(final int box, final int nearX, final int nearY, final int nearZ, final double x, final double y,
      final double z, final double ix, final double iy, final double iz, final double farthest) {
    final double ax = (boxes[box + nearX] - x) * ix, ay = (boxes[box + nearY] - y) * iy, az = (boxes[box + nearZ] - z) * iz;
    final double bx = (boxes[box + 3 - nearX] - x) * ix, by = (boxes[box + 5 - nearY] - y) * iy,
        bz = (boxes[box + 7 - nearZ] - z) * iz;
    double enter = ax > 0 ? ax : 0;
    enter = ay > enter ? ay : enter;
    enter = az > enter ? az : enter;
    double leave = bx < farthest ? bx : farthest;
    leave = by < leave ? by : leave;
    leave = bz < leave ? bz : leave;
    return enter <= leave * FAR ? enter : Double.POSITIVE_INFINITY;
  }

  /**
   * Visits the leaves that the rays of a tile may hit, the nearer child of a node first. A primitive may have a tree of
   * its own and traverse it with the same frustum.
   *
   * @param frustum the frustum of the tile, which must be fitted
   * @param leaves the owner of the primitives
   */
  public void closest(final TileFrustum frustum, final Leaves leaves) {
    visitLeaves(frustum, null, Double.POSITIVE_INFINITY, leaves);
  }

  /**
   * Visits the leaves that may block segments of a tile, the nearer child of a node first.
   *
   * @param segments the segments, which must be enclosed
   * @param leaves the owner of the primitives
   */
  public void block(final SegmentTile segments, final Leaves leaves) {
    visitLeaves(segments.frustum(), segments, segments.limit(), leaves);
  }

  private void visitLeaves(final TileFrustum frustum, final SegmentTile segments, final double limit, final Leaves leaves) {
    if (isEmpty()) {
      return;
    }
    final float[] outer = frustum.sides().prepared();
    if (frustum.prepare(whole)) {
      visitLeaves(frustum.sides(), segments, Math.nextUp((float) limit), leaves);
    } else {
      leaves.visit(0, size);
    }
    if (outer != null) {
      frustum.prepare(outer);
    }
  }

  /** See above; with segments, boxes that none of them hits are culled. */
  private void visitLeaves(final TileSides sides, final SegmentTile segments, final float limit, final Leaves leaves) {
    final int[] stack = new int[depth + 1];
    int top = 0, node = root;
    float farthest = limit;
    while (true) {
      if (node < 0) {
        farthest = Math.nextUp((float) visit(node, leaves));
      } else {
        final int a = node * 12, b = a + 6;
        final float nearA = sides.nearest(boxes, a), nearB = sides.nearest(boxes, b);
        final boolean meetsA = !(nearA > farthest) && !sides.isOutside(boxes, a)
            && (segments == null || segments.mayMeet(boxes, a));
        final boolean meetsB = !(nearB > farthest) && !sides.isOutside(boxes, b)
            && (segments == null || segments.mayMeet(boxes, b));
        if (meetsA && meetsB) {
          final int nearer = nearB < nearA ? 1 : 0;
          stack[top++] = links[2 * node + 1 - nearer];
          node = links[2 * node + nearer];
          continue;
        }
        if (meetsA || meetsB) {
          node = links[2 * node + (meetsA ? 0 : 1)];
          continue;
        }
      }
      if (top == 0) {
        return;
      }
      node = stack[--top];
    }
  }

  private static double visit(final int leaf, final Leaves leaves) {
    final int first = ~leaf / MOST_IN_LEAF;
    return leaves.visit(first, first + ~leaf % MOST_IN_LEAF + 1);
  }

  private boolean isEmpty() {
    return depth == 0;
  }
}
