package acceleration;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.RecursiveTask;

/**
 * Builds a tree from boxes, from the top down: the boxes of a node are sorted into bins by their centres along the longest
 * side of the centres' box, and split between two bins where the surface area heuristic expects the least work: the sum
 * over both sides of area times number of primitives. Source: Wald, "On fast Construction of SAH-based Bounding Volume
 * Hierarchies", Symposium on Interactive Ray Tracing, 2007. Where all centres coincide, and far down, the primitives are
 * halved.
 *
 * <p>The boxes themselves are moved, not referenced, so that every pass reads memory in order. Large parts are built by
 * several threads; the tree is the same.
 */
final class BvhBuilder {

  /** Smallest number of primitives for a separate task. */
  private static final int PARALLEL = 1 << 13;

  /** Depth at which primitives are halved instead, so that no order of boxes makes a tree too deep. */
  private static final int DEEP = 48;

  private final float[] boxes;
  private final int[] order;
  private final int leaf;

  BvhBuilder(final float[] boxes, final int leaf, final int[] order) {
    this.boxes = boxes;
    this.leaf = leaf;
    this.order = order;
    for (int i = 0; i < order.length; i++) {
      order[i] = i;
    }
  }

  Bvh build() {
    final int n = order.length;
    if (n == 0) {
      return Bvh.EMPTY;
    }
    final BoxBuilder whole = new BoxBuilder();
    for (int i = 0; i < n; i++) {
      whole.add(boxes, 6 * i);
    }
    final float[] numbers = new float[6];
    whole.store(numbers, 0);
    final Task task = new Task(0, n, BoxBuilder.ofCentres(boxes, 0, n), 0);
    final Subtree tree = n < PARALLEL ? task.compute() : ForkJoinPool.commonPool().invoke(task);
    return tree.toBvh(n, task.link, numbers);
  }

  /** A part of the tree, built by one thread, or split over several if it is large. */
  private final class Task extends RecursiveTask<Subtree> {

    private static final long serialVersionUID = 1L;

    private final int first;
    private final int end;
    private final transient BoxBuilder centres;
    private final int depth;
    private int link;
    private transient Bins bins;

    Task(final int first, final int end, final BoxBuilder centres, final int depth) {
      this.first = first;
      this.end = end;
      this.centres = centres;
      this.depth = depth;
    }

    @Override
    protected Subtree compute() {
      bins = new Bins(boxes, order);
      final Subtree tree = new Subtree((end - first) / leaf);
      link = end - first < PARALLEL ? build(tree, first, end, centres, depth) : fork(tree);
      return tree;
    }

    private int fork(final Subtree tree) {
      final Split split = split(first, end, centres, depth);
      final Task left = new Task(first, split.middle, split.leftCentres, depth + 1);
      final Task right = new Task(split.middle, end, split.rightCentres, depth + 1);
      invokeAll(left, right);
      final int node = tree.add(split.left, split.right);
      tree.link(node, tree.append(left.join(), left.link), tree.append(right.join(), right.link));
      return node;
    }

    private int build(final Subtree tree, final int from, final int to, final BoxBuilder middles, final int level) {
      if (to - from <= leaf) {
        tree.depth = Math.max(tree.depth, level);
        return Bvh.leaf(from, to - from);
      }
      final Split split = split(from, to, middles, level);
      final int node = tree.add(split.left, split.right);
      final int left = build(tree, from, split.middle, split.leftCentres, level + 1);
      tree.link(node, left, build(tree, split.middle, to, split.rightCentres, level + 1));
      return node;
    }

    private Split split(final int from, final int to, final BoxBuilder middles, final int level) {
      final Split split = level < DEEP ? bins.split(from, to, middles) : null;
      return split != null ? split : bins.halve(from, to);
    }
  }
}
