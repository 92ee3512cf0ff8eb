package acceleration;

/** Finds where to split the boxes of a node, and partitions them. One for each thread. */
final class Bins {

  private static final int MOST = 16;

  private final float[] boxes;
  private final int[] order;
  private final int[] counts = new int[MOST];
  private final BoxBuilder[] extents = new BoxBuilder[MOST];
  private final double[] rightCosts = new double[MOST];
  private final BoxBuilder sweep = new BoxBuilder();

  /** Number of bins in use. */
  private int used;

  Bins(final float[] boxes, final int[] order) {
    this.boxes = boxes;
    this.order = order;
    for (int i = 0; i < MOST; i++) {
      extents[i] = new BoxBuilder();
    }
  }

  /** Splits where the surface area heuristic expects the least work; null if all centres fall into one bin. */
  Split split(final int first, final int end, final BoxBuilder centres) {
    final int axis = centres.longest();
    used = count(end - first);
    final float least = centres.least(axis), scale = used / centres.length(axis);
    fill(first, end, axis, least, scale);
    final int border = cheapest();
    return border < 0 ? null : part(first, end, axis, least, scale, border);
  }

  /** Few bins are enough for few boxes, and most nodes have few. */
  private static int count(final int boxes) {
    return boxes < 16 ? 4 : boxes < 128 ? 8 : MOST;
  }

  private int bin(final float centre, final float least, final float scale) {
    return Math.max(0, Math.min(used - 1, (int) ((centre - least) * scale)));
  }

  private void fill(final int first, final int end, final int axis, final float least, final float scale) {
    for (int i = 0; i < used; i++) {
      counts[i] = 0;
      extents[i].clear();
    }
    for (int i = first; i < end; i++) {
      final int b = bin(BoxBuilder.centre(boxes, 6 * i, axis), least, scale);
      counts[b]++;
      extents[b].add(boxes, 6 * i);
    }
  }

  /** The bin at which the right side begins; -1 if there is no border with primitives on both sides. */
  private int cheapest() {
    sweep.clear();
    int count = 0;
    for (int b = used - 1; b > 0; b--) {
      sweep.add(extents[b]);
      count += counts[b];
      rightCosts[b] = count == 0 ? Double.POSITIVE_INFINITY : sweep.area() * count;
    }
    sweep.clear();
    count = 0;
    int best = -1;
    double least = Double.POSITIVE_INFINITY;
    for (int b = 1; b < used; b++) {
      sweep.add(extents[b - 1]);
      count += counts[b - 1];
      final double cost = sweep.area() * count + rightCosts[b];
      if (count > 0 && cost < least) {
        least = cost;
        best = b;
      }
    }
    return best;
  }

  private Split part(final int first, final int end, final int axis, final float least, final float scale,
      final int border) {
    final Split split = new Split();
    for (int b = 0; b < used; b++) {
      (b < border ? split.left : split.right).add(extents[b]);
    }
    int i = first, j = end;
    while (i < j) {
      if (bin(BoxBuilder.centre(boxes, 6 * i, axis), least, scale) < border) {
        split.leftCentres.addCentre(boxes, 6 * i++);
      } else {
        swap(i, --j);
        split.rightCentres.addCentre(boxes, 6 * j);
      }
    }
    split.middle = i;
    return split;
  }

  private void swap(final int i, final int j) {
    for (int k = 0; k < 6; k++) {
      final float number = boxes[6 * i + k];
      boxes[6 * i + k] = boxes[6 * j + k];
      boxes[6 * j + k] = number;
    }
    final int thing = order[i];
    order[i] = order[j];
    order[j] = thing;
  }

  /** Splits in the middle of the order, whatever lies where. */
  Split halve(final int first, final int end) {
    final Split split = new Split();
    split.middle = first + (end - first) / 2;
    for (int i = first; i < end; i++) {
      (i < split.middle ? split.left : split.right).add(boxes, 6 * i);
      (i < split.middle ? split.leftCentres : split.rightCentres).addCentre(boxes, 6 * i);
    }
    return split;
  }
}
