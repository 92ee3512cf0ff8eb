package acceleration;

import java.util.Arrays;

/** A growing part of a tree: nodes in the order in which they are first visited, in the layout of {@link Bvh}. */
final class Subtree {

  private float[] boxes;
  private int[] links;
  private int nodes;

  /** Longest way from the top of this part to a leaf, in nodes. */
  int depth;

  Subtree(final int expectedNodes) {
    boxes = new float[12 * Math.max(1, expectedNodes)];
    links = new int[2 * Math.max(1, expectedNodes)];
  }

  /** Adds a node with the boxes of its two children; returns its number. */
  int add(final BoxBuilder left, final BoxBuilder right) {
    ensure(nodes + 1);
    left.store(boxes, 12 * nodes);
    right.store(boxes, 12 * nodes + 6);
    return nodes++;
  }

  void link(final int node, final int left, final int right) {
    links[2 * node] = left;
    links[2 * node + 1] = right;
  }

  /** Adds all nodes of another part; returns where its link points to now. */
  int append(final Subtree other, final int link) {
    ensure(nodes + other.nodes);
    System.arraycopy(other.boxes, 0, boxes, 12 * nodes, 12 * other.nodes);
    for (int i = 0; i < 2 * other.nodes; i++) {
      links[2 * nodes + i] = moved(other.links[i]);
    }
    final int there = moved(link);
    nodes += other.nodes;
    depth = Math.max(depth, other.depth);
    return there;
  }

  private int moved(final int link) {
    return link < 0 ? link : link + nodes;
  }

  private void ensure(final int needed) {
    if (12L * needed > boxes.length) {
      final int room = Math.max(needed, nodes + nodes / 2 + 8);
      boxes = Arrays.copyOf(boxes, Math.multiplyExact(12, room));
      links = Arrays.copyOf(links, 2 * room);
    }
  }

  /** The finished tree of primitives within a box. */
  Bvh toBvh(final int size, final int root, final float[] whole) {
    return new Bvh(size, whole, Arrays.copyOf(boxes, 12 * nodes), Arrays.copyOf(links, 2 * nodes), root, depth + 1);
  }
}
