package acceleration;

import java.util.Arrays;

import primitives.BoundingBox;

/**
 * The segments from up to 256 points to one light, asked together whether anything lies on them. Seen from the light they
 * are the rays of a pyramid that end at the points; if all have one direction, a prism. Either is enclosed by a
 * {@link TileFrustum}, whose columns and rows form a raster before the light, and each segment has its place there; so
 * what is projected onto a part of the raster can lie only on the segments that have their place in that part.
 *
 * <p>Segments are kept in 16 blocks of 16, of 4 × 4 pixels each, which have much in common. Those that are found to be
 * blocked are dropped. A segment is known by its number, {@link #number}.
 *
 * <p>A segment may pass the light by, as it starts beside its point and its numbers are rounded. By how much is measured,
 * and all is conservative: the greatest distance of a line from the light, the displacement, widens the sides of the
 * frustum by itself; and what lies less than 10<sup>6</sup> displacements before the light counts as seen by all of the
 * raster, as beyond that a line is off its place by less than 10<sup>-6</sup> of the slopes.
 */
public final class SegmentTile extends TileRays {

  /** Greatest number of columns and of rows of pixels whose segments have room, and of the raster. */
  public static final int SIZE = 16;

  /** Number of segments in a block, and of blocks. */
  public static final int BLOCK = 16;

  static final int MOST = SIZE * SIZE;

  private final double[] length = new double[MOST];
  private final double[] column = new double[MOST];
  private final double[] row = new double[MOST];

  /** For each block the segments that are not blocked, as bits, and bounds of what they are. */
  private final int[] open = new int[MOST / BLOCK];
  private final double[] leastColumn = new double[MOST / BLOCK];
  private final double[] mostColumn = new double[MOST / BLOCK];
  private final double[] leastRow = new double[MOST / BLOCK];
  private final double[] mostRow = new double[MOST / BLOCK];
  private final double[] farthest = new double[MOST / BLOCK];

  private final TileGrid grid = frustum().grid();
  private final TileWindow window = frustum().window();
  private final SegmentFit fit = new SegmentFit(this, grid);
  private double longest;
  private int first;
  private int count;

  /** An empty tile. */
  public SegmentTile() {
    super(MOST);
  }

  /**
   * Number of the segment of a pixel.
   *
   * @param pixel number of the pixel in a {@link RayTile}; those of {@link #SIZE} × {@link #SIZE} pixels differ
   * @return the number, 0 … 255
   */
  public static int number(final int pixel) {
    final int column = pixel % RayTile.SIZE, row = pixel / RayTile.SIZE;
    return column & 3 | (row & 3) << 2 | (column & 0xc) << 2 | (row & 0xc) << 4;
  }

  /** Removes all segments. */
  public void clear() {
    Arrays.fill(open, 0);
    count = 0;
    longest = 0;
  }

  /**
   * Adds a segment.
   *
   * @param i its number
   * @param x first coordinate of its start
   * @param y second coordinate of its start
   * @param z third coordinate of its start
   * @param dx first component of its direction, of unit length
   * @param dy second component of its direction
   * @param dz third component of its direction
   * @param itsLength its length, finite
   */
  public void add(final int i, final double x, final double y, final double z,
      final double dx, final double dy, final double dz, final double itsLength) {
    putStart(i, x, y, z);
    putUnitDirection(i, dx, dy, dz);
    length[i] = itsLength;
    open[i / BLOCK] |= 1 << i % BLOCK;
    longest = Math.max(longest, itsLength);
    first = i;
    count++;
  }

  /**
   * Encloses the segments.
   *
   * @return whether that is possible; if not, each has to be asked by itself
   */
  public boolean close() {
    if (count < 2) {
      return false;
    }
    final boolean possible = fit.fit();
    frustum().encloseRaster(possible, SIZE);
    if (possible) {
      for (int block = 0; block < open.length; block++) {
        bound(block);
      }
    }
    return possible;
  }

  private void bound(final int block) {
    double fromC = Double.POSITIVE_INFINITY, toC = Double.NEGATIVE_INFINITY;
    double fromR = Double.POSITIVE_INFINITY, toR = Double.NEGATIVE_INFINITY, far = Double.NEGATIVE_INFINITY;
    for (int bits = open[block]; bits != 0; bits &= bits - 1) {
      final int i = block * BLOCK + Integer.numberOfTrailingZeros(bits);
      fromC = Math.min(fromC, column[i]);
      toC = Math.max(toC, column[i]);
      fromR = Math.min(fromR, row[i]);
      toR = Math.max(toR, row[i]);
      far = Math.max(far, depth(i));
    }
    leastColumn[block] = fromC;
    mostColumn[block] = toC;
    leastRow[block] = fromR;
    mostRow[block] = toR;
    farthest[block] = far;
  }

  /** How far from the frustum's origin, along the axis, a segment reaches. */
  private double depth(final int i) {
    final TileGrid g = grid;
    final double start = (startX[i] - g.originX) * g.axisX + (startY[i] - g.originY) * g.axisY
        + (startZ[i] - g.originZ) * g.axisZ;
    return start + (g.pyramid ? g.displacement : length[i]);
  }

  /**
   * Distance from the frustum's origin, along its axis, beyond which nothing lies on a segment that is not blocked.
   *
   * @return the distance; negative infinity if all are blocked
   */
  public double limit() {
    double limit = Double.NEGATIVE_INFINITY;
    for (int block = 0; block < open.length; block++) {
      limit = open[block] != 0 ? Math.max(limit, farthest[block]) : limit;
    }
    return limit;
  }

  /**
   * Greatest distance of a segment's line from the origin of a pyramid.
   *
   * @return the displacement
   */
  public double displacement() {
    return grid.displacement;
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
   * The segments of a block that are not blocked and may lie where the frustum's last projection was.
   *
   * @param block number of the block, 0 … 15
   * @return bit k for the segment 16 · block + k
   */
  public int candidates(final int block) {
    return open[block] != 0
        && window.overlaps(leastColumn[block], mostColumn[block], leastRow[block], mostRow[block]) ? open[block] : 0;
  }

  /**
   * All segments of a block that are not blocked.
   *
   * @param block number of the block, 0 … 15
   * @return bit k for the segment 16 · block + k
   */
  public int open(final int block) {
    return open[block];
  }

  /**
   * Whether the frustum's last projection may lie on a segment.
   *
   * @param i number of the segment
   * @return false if it does not
   */
  public boolean isCandidate(final int i) {
    return window.contains(column[i], row[i]);
  }

  /**
   * Finds what a box may block.
   *
   * @param box the box
   * @return whether there may be anything, which {@link #candidates} says
   */
  public boolean project(final BoundingBox box) {
    return box.isFinite() ? frustum().project(box) : window.all();
  }

  /**
   * Drops a segment that is blocked.
   *
   * @param i its number
   */
  public void block(final int i) {
    open[i / BLOCK] &= ~(1 << i % BLOCK);
  }

  double length(final int i) {
    return length[i];
  }

  int first() {
    return first;
  }

  void place(final int i, final double itsColumn, final double itsRow) {
    column[i] = itsColumn;
    row[i] = itsRow;
  }

  double column(final int i) {
    return column[i];
  }

  double row(final int i) {
    return row[i];
  }

  boolean isOpen(final int i) {
    return (open[i / BLOCK] >> i % BLOCK & 1) != 0;
  }
}
