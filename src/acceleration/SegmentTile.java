package acceleration;

import java.util.Arrays;

import primitives.BoundingBox;

/**
 * The segments from up to 256 points to one light, tested together for occlusion. Seen from the light they are the rays
 * of a pyramid that end at the points; if all have one direction, a prism. Either is enclosed by a {@link TileFrustum},
 * whose columns and rows form a raster in front of the light, in which each segment has its position and, in a pyramid,
 * its depth. {@link SegmentSets} of the three say at once which segments a part of the raster, from some depth on, may
 * lie on: the irregular sampling of Johnson et al., "The irregular Z-buffer", ACM Transactions on Graphics 24(4), 2005,
 * with sets of bits in place of lists.
 *
 * <p>Blocked segments are dropped.
 *
 * <p>A segment may pass the light by, as it starts beside its point and its numbers are rounded. By how much is measured,
 * and all is conservative: the greatest distance of a line from the light, the displacement, widens the sides of the
 * frustum by itself; and what lies less than 10<sup>6</sup> displacements before the light counts as seen by all of the
 * raster, as beyond that a line is off its place by less than 10<sup>-6</sup> of the slopes.
 */
public final class SegmentTile extends TileRays {

  /** Greatest number of columns and of rows of pixels. */
  public static final int SIZE = 16;

  /** Greatest number of segments. */
  public static final int MOST = SIZE * SIZE;

  /** Number of longs in a set of segments, a bit for each. */
  public static final int WORDS = MOST / Long.SIZE;

  /** Bound of the rounding of a depth, relative to the numbers from which it is computed. */
  private static final double ROUNDING = 0x1p-45;

  final double[] length = new double[MOST];
  /** Places in the raster, and how far along the axis a segment begins or, in a prism, ends. */
  final double[] column = new double[MOST];
  final double[] row = new double[MOST];
  final double[] depth = new double[MOST];

  /** The segments that are not blocked. */
  private final long[] open = new long[WORDS];
  private final long[] candidates = new long[WORDS];
  private final TileFrustum frustum = frustum();
  private final TileWindow window = frustum.window();
  private final SegmentFit fit = new SegmentFit(this, frustum.grid());

  /** The segments by column, by row and by level of depth; sorted when first needed. */
  private final SegmentSets columns = new SegmentSets();
  private final SegmentSets rows = new SegmentSets();
  private final SegmentSets levels = new SegmentSets();
  private boolean sorted;

  private int count;
  private int first;
  private int end;
  private double longest;

  /** The depth of level 0, levels to a unit of depth, and the last level that is not empty. */
  private double leastDepth;
  private double levelsToDepth;
  private int deepest;

  /** Added to depths, so that rounding and displacement hide nothing. */
  private double shift;

  /** An empty tile. */
  public SegmentTile() {
    super(MOST);
  }

  /** Removes all segments. */
  public void clear() {
    Arrays.fill(open, 0);
    count = 0;
  }

  /**
   * Adds a segment, which gets the next number, from 0.
   *
   * @param x first coordinate of its start
   * @param y second coordinate of its start
   * @param z third coordinate of its start
   * @param dx first component of its direction, of unit length
   * @param dy second component of its direction
   * @param dz third component of its direction
   * @param itsLength its length, finite
   */
  public void add(final double x, final double y, final double z, final double dx, final double dy, final double dz,
      final double itsLength) {
    final int i = count++;
    putStart(i, x, y, z);
    putUnitDirection(i, dx, dy, dz);
    length[i] = itsLength;
  }

  /**
   * Encloses a range of segments, to which all further queries are restricted.
   *
   * @param from number of the first
   * @param to number after the last
   * @return whether that is possible; if not, each has to be asked by itself
   */
  public boolean close(final int from, final int to) {
    first = from;
    end = to;
    sorted = false;
    for (int w = 0; w < WORDS; w++) {
      open[w] = bits(to - Long.SIZE * w) & ~bits(from - Long.SIZE * w);
    }
    final boolean possible = to - from > 1 && fit.fit(from, to);
    frustum.encloseRaster(possible, SegmentSets.CELLS);
    if (possible) {
      findDepths();
    }
    return possible;
  }

  /** The n lowest bits. */
  private static long bits(final int n) {
    return n <= 0 ? 0 : n >= Long.SIZE ? -1L : (1L << n) - 1;
  }

  private void findDepths() {
    double least = Double.POSITIVE_INFINITY, most = Double.NEGATIVE_INFINITY, far = 0;
    for (int i = first; i < end; i++) {
      final double d = depth[i], l = length[i];
      least = d < least ? d : least;
      most = d > most ? d : most;
      far = l > far ? l : far;
    }
    longest = far;
    final double slack = ROUNDING * far + (frustum.isPyramid() ? displacement() : 0);
    leastDepth = least - slack;
    levelsToDepth = SegmentFit.LAST / (most - least + 2 * slack);
    deepest = SegmentSets.CELLS - 1;
    shift = slack;
  }

  /**
   * Distance from the frustum's origin, along its axis, beyond which nothing lies on a segment that is not blocked.
   *
   * @return the distance; negative infinity if all are blocked
   */
  public double limit() {
    while (deepest >= 0 && sorted && !isOpen(levels.from, SegmentSets.WORDS * deepest)) {
      deepest--;
    }
    return deepest < 0 ? Double.NEGATIVE_INFINITY : leastDepth + (deepest + 1) / levelsToDepth + shift;
  }

  private boolean isOpen(final long[] sets, final int at) {
    return (open[0] & sets[at] | open[1] & sets[at + 1] | open[2] & sets[at + 2] | open[3] & sets[at + 3]) != 0;
  }

  /**
   * Greatest distance of a segment's line from the origin of a pyramid.
   *
   * @return the displacement
   */
  public double displacement() {
    return frustum.grid().displacement;
  }

  /**
   * Length of the longest segment.
   *
   * @return its length
   */
  public double longest() {
    return longest;
  }

  /**
   * Finds what a box may block.
   *
   * @param box the box
   * @return whether there may be anything, which {@link #candidates} says
   */
  public boolean project(final BoundingBox box) {
    return box.isFinite() ? frustum.project(box) && select(ROUNDING * frustum.greatest(box)) : selectAll();
  }

  /**
   * Makes all segments that are not blocked candidates.
   *
   * @return true
   */
  public boolean selectAll() {
    System.arraycopy(open, 0, candidates, 0, WORDS);
    return true;
  }

  /** Whether a box of a tree may block a segment. */
  boolean mayMeet(final float[] boxes, final int at) {
    return frustum.project(boxes[at], boxes[at + 1], boxes[at + 2], boxes[at + 3], boxes[at + 4], boxes[at + 5])
        && select(ROUNDING * frustum.sides().extent());
  }

  /**
   * Finds the segments that are not blocked and may cross the frustum's last projection.
   *
   * @param error bound of the rounding error of its depth
   * @return whether there may be any, which {@link #candidates} says
   */
  public boolean select(final double error) {
    sort();
    final double level = (frustum.leastDepth() - error - leastDepth) * levelsToDepth;
    if (level > SegmentFit.LAST) {
      return false;
    }
    final int l = SegmentSets.WORDS * (int) Math.max(0, level);
    final int c = SegmentSets.WORDS * (int) Math.max(0, window.leastColumn());
    final int d = SegmentSets.WORDS * (int) (1 + Math.min(SegmentFit.LAST, window.mostColumn()));
    final int r = SegmentSets.WORDS * (int) Math.max(0, window.leastRow());
    final int t = SegmentSets.WORDS * (int) (1 + Math.min(SegmentFit.LAST, window.mostRow()));
    final long[] inColumns = columns.from, inRows = rows.from, inLevels = levels.from;
    long any = 0;
    for (int w = 0; w < WORDS; w++) {
      final long found = open[w] & inColumns[c + w] & ~inColumns[d + w] & inRows[r + w] & ~inRows[t + w] & inLevels[l + w];
      candidates[w] = found;
      any |= found;
    }
    return any != 0;
  }

  private void sort() {
    if (!sorted) {
      sorted = true;
      columns.sort(column, first, end, 0, 1);
      rows.sort(row, first, end, 0, 1);
      levels.sort(depth, first, end, leastDepth - shift, levelsToDepth);
    }
  }

  /**
   * The segments found last, as bits.
   *
   * @param word which 64 of them
   * @return bit k for the segment 64 · word + k
   */
  public long candidates(final int word) {
    return candidates[word];
  }

  /**
   * The segments that are not blocked, as bits.
   *
   * @param word which 64 of them
   * @return bit k for the segment 64 · word + k
   */
  public long open(final int word) {
    return open[word];
  }

  /**
   * Length of a segment.
   *
   * @param i its number
   * @return the length
   */
  public double length(final int i) {
    return length[i];
  }

  /**
   * Drops a segment that is blocked.
   *
   * @param i its number
   */
  public void block(final int i) {
    open[i / Long.SIZE] &= ~(1L << i);
  }
}
