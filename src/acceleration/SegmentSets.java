package acceleration;

import java.util.Arrays;

/**
 * Segments sorted into cells along one coordinate, so that those in a range of cells are found at once, as sets of 256
 * bits: for each cell the set of all segments in it or in a later one.
 */
final class SegmentSets {

  /** Number of cells. */
  static final int CELLS = 64;

  /** Number of longs in a set. */
  static final int WORDS = 4;

  /** The sets of the cells, followed by an empty one. */
  final long[] from = new long[WORDS * (CELLS + 1)];

  /** Sorts some segments by their coordinates relative to the least, with a number of cells per unit. */
  void sort(final double[] coordinates, final int first, final int end, final double least, final double cells) {
    Arrays.fill(from, 0);
    for (int i = first; i < end; i++) {
      from[WORDS * (int) ((coordinates[i] - least) * cells) + i / Long.SIZE] |= 1L << i;
    }
    for (int k = WORDS * CELLS - 1; k >= 0; k--) {
      from[k] |= from[k + WORDS];
    }
  }
}
