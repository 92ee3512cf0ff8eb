package acceleration;

import primitives.BoundingBox;

/**
 * The pyramid or prism that encloses the rays of a tile, and the projection of space onto the tile's pixels.
 *
 * <p>Found from the rays alone, whatever camera made them. If they share a start, their slopes about the mean direction are
 * nearly a regular grid (a pyramid); if they share a direction, their starts are (a prism). A grid is fitted, and how far
 * the rays stray from it, in pixels, is kept as a margin: each ray is projected to within the margin of its own column and
 * row. So all results are conservative: what a ray of the tile can hit is never said to be outside. Rays that share neither
 * start nor direction are not fitted.
 *
 * <p>The projection is homogeneous: with V = P − O, column = (C·V + c) / (D·V + d) and the same for the row, where
 * D·V + d is the depth in a pyramid and 1 in a prism. Enclosing rays by planes to trace them together is the idea of
 * Reshetov, Soupikov and Hurley, "Multi-Level Ray Tracing Algorithm", SIGGRAPH 2005.
 */
public final class TileFrustum {

  /** Added to the margin, in pixels, for the rounding of double. */
  private static final double ROUNDING = 1e-6;

  /** Added before digits are cut off to round up; numbers just above a whole one go down to it, which does no harm. */
  private static final double UP = 1 - 1e-9;

  /**
   * Depth below which a projection may be off by more than {@link #ROUNDING}, relative to the sum of |n| |V| of a side
   * plane: some ten roundings of 2^-53 in C·V, and as many in D·V times the greatest column.
   */
  private static final double SHALLOW = 1e-8;

  /** Multiples of the displacement from which on a displaced line is taken for one through the origin. */
  static final double STRAIGHT = 1e6;

  /** Sums below this cannot overflow a float. */
  private static final double HUGE = 1e37;

  private final TileGrid grid = new TileGrid();
  private final GridFit measured = new GridFit();
  private final PencilGrid derived = new PencilGrid();

  private final SidePlane left = new SidePlane();
  private final SidePlane right = new SidePlane();
  private final SidePlane below = new SidePlane();
  private final SidePlane above = new SidePlane();

  private boolean fitted;

  /** Whether rays may lie between columns and rows. */
  private boolean between;
  private double originX;
  private double originY;
  private double originZ;
  private double columnX;
  private double columnY;
  private double columnZ;
  private double columnAt;
  private double rowX;
  private double rowY;
  private double rowZ;
  private double rowAt;
  private double depthX;
  private double depthY;
  private double depthZ;
  private double depthAt;
  private double axisX;
  private double axisY;
  private double axisZ;
  private double mostAhead;
  private double mostBehind;
  private float floatX;
  private float floatY;
  private float floatZ;
  private float floatAxisX;
  private float floatAxisY;
  private float floatAxisZ;
  private float nearLoose;
  private float farLoose;
  private int nearX;
  private int nearY;
  private int nearZ;

  /** Depth below which vertices within the box last prepared for are not projected. */
  private double least;
  private double columnMargin;
  private double rowMargin;
  private int columns;
  private int rows;

  /** What was found by the last projection, with the margin, between pixels. */
  private double leastColumn;
  private double mostColumn;
  private double leastRow;
  private double mostRow;
  private int firstColumn;
  private int lastColumn;
  private int firstRow;
  private int lastRow;

  /** The box last prepared for; null if there was none yet. */
  private float[] prepared;

  TileFrustum() {
  }

  /** Encloses the rays of a tile, if they allow it. */
  void fit(final RayTile tile) {
    final boolean possible = measured.fit(tile, grid);
    if (possible && !grid.pyramid) {
      findStarts(tile);
    }
    enclose(possible, tile.columns(), tile.rows());
  }

  /** Encloses the rays that the tile made of a pencil and the centres of its pixels. */
  void fit(final RayTile tile, final Pencil pencil, final double[] a, final double[] b) {
    enclose(derived.derive(pencil, tile, a, b, grid) || measured.fit(tile, grid), tile.columns(), tile.rows());
  }

  /** The grid to be found by whoever encloses rays of another kind. */
  TileGrid grid() {
    return grid;
  }

  /** Takes the grid of rays that may lie between columns and rows, of so many of each, if it was possible to find it. */
  void encloseRaster(final boolean possible, final int size) {
    enclose(possible, size, size);
    between = true;
  }

  private void enclose(final boolean possible, final int itsColumns, final int itsRows) {
    fitted = possible;
    between = false;
    prepared = null;
    least = grid.pyramid ? STRAIGHT * grid.displacement : 0;
    if (fitted) {
      columns = itsColumns;
      rows = itsRows;
      takeProjection();
      takePlanes();
    }
  }

  private void takeProjection() {
    final TileGrid g = grid;
    originX = g.originX;
    originY = g.originY;
    originZ = g.originZ;
    columnX = g.columnX;
    columnY = g.columnY;
    columnZ = g.columnZ;
    columnAt = g.columnAt;
    rowX = g.rowX;
    rowY = g.rowY;
    rowZ = g.rowZ;
    rowAt = g.rowAt;
    depthX = g.depthX;
    depthY = g.depthY;
    depthZ = g.depthZ;
    depthAt = g.depthAt;
    columnMargin = g.columnMargin + ROUNDING;
    rowMargin = g.rowMargin + ROUNDING;
    axisX = g.axisX;
    axisY = g.axisY;
    axisZ = g.axisZ;
    mostAhead = grid.ahead;
    mostBehind = grid.behind + grid.displacement;
    floatAxisX = (float) axisX;
    floatAxisY = (float) axisY;
    floatAxisZ = (float) axisZ;
    nearX = axisX > 0 ? 0 : 3;
    nearY = axisY > 0 ? 1 : 4;
    nearZ = axisZ > 0 ? 2 : 5;
  }

  /** Finds how far before and behind the origin, along the axis, rays start: the starts of a prism may lie on a slant. */
  private void findStarts(final RayTile tile) {
    for (int i = 0; i < RayTile.SIZE * tile.rows(); i++) {
      if (tile.isPresent(i)) {
        final double ahead = (tile.startX(i) - grid.originX) * grid.axisX + (tile.startY(i) - grid.originY) * grid.axisY
            + (tile.startZ(i) - grid.originZ) * grid.axisZ;
        grid.ahead = Math.max(grid.ahead, ahead);
        grid.behind = Math.max(grid.behind, -ahead);
      }
    }
  }

  private void takePlanes() {
    final double firstC = columnMargin, lastC = columns - 1 + columnMargin, firstR = rowMargin, lastR = rows - 1 + rowMargin;
    set(left, columnX + firstC * depthX, columnY + firstC * depthY, columnZ + firstC * depthZ, columnAt + firstC * depthAt);
    set(right, lastC * depthX - columnX, lastC * depthY - columnY, lastC * depthZ - columnZ, lastC * depthAt - columnAt);
    set(below, rowX + firstR * depthX, rowY + firstR * depthY, rowZ + firstR * depthZ, rowAt + firstR * depthAt);
    set(above, lastR * depthX - rowX, lastR * depthY - rowY, lastR * depthZ - rowZ, lastR * depthAt - rowAt);
  }

  /** A side that lines which pass the origin by, at the displacement, do not leave either. */
  private void set(final SidePlane side, final double x, final double y, final double z, final double at) {
    side.set(x, y, z, at + grid.displacement * Math.sqrt(x * x + y * y + z * z));
  }

  /**
   * Whether the rays are enclosed; if not, nothing else may be asked.
   *
   * @return false if the rays have nothing in common, are spread too far, or are none
   */
  public boolean isFitted() {
    return fitted;
  }

  /**
   * Prepares for boxes that lie within a box, whose six numbers bound what rounding to floats can do to theirs.
   *
   * @return false if floats could overflow, so that nothing may be asked of boxes
   */
  boolean prepare(final float[] whole) {
    prepared = whole;
    floatX = (float) originX;
    floatY = (float) originY;
    floatZ = (float) originZ;
    final double x = most(whole[0], whole[3], originX), y = most(whole[1], whole[4], originY);
    final double z = most(whole[2], whole[5], originZ);
    final double greatest = Math.max(Math.max(left.loosen(x, y, z), right.loosen(x, y, z)),
        Math.max(below.loosen(x, y, z), above.loosen(x, y, z)));
    least = grid.pyramid ? Math.max(SHALLOW * greatest, STRAIGHT * grid.displacement) : 0;
    nearLoose = (float) (-mostAhead - SidePlane.ROUNDING * (x + y + z + mostAhead));
    farLoose = (float) (mostBehind + SidePlane.ROUNDING * (x + y + z + mostBehind));
    return greatest < HUGE && x + y + z + mostAhead + mostBehind < HUGE;
  }

  /** The box that was prepared for last; null if none was. */
  float[] prepared() {
    return prepared;
  }

  /** Greatest distance of an interval's points from an origin, and twice what the origin's own rounding adds to it. */
  private static double most(final float from, final float to, final double origin) {
    return Math.max(Math.abs(from - origin), Math.abs(to - origin))
        + 2 * Math.abs(origin - (float) origin) / SidePlane.ROUNDING;
  }

  /** A distance before which no ray of the tile can be within a box; the box is the one at a place of an array. */
  float nearest(final float[] boxes, final int at) {
    return (boxes[at + nearX] - floatX) * floatAxisX + (boxes[at + nearY] - floatY) * floatAxisY
        + (boxes[at + nearZ] - floatZ) * floatAxisZ + nearLoose;
  }

  /**
   * Whether no ray of the tile can be within a box. The signs of all five sides are gathered without a branch, which the
   * processor would guess wrong too often.
   */
  boolean isOutside(final float[] boxes, final int at) {
    final float x = floatX, y = floatY, z = floatZ;
    final float far = (boxes[at + 3 - nearX] - x) * floatAxisX + (boxes[at + 5 - nearY] - y) * floatAxisY
        + (boxes[at + 7 - nearZ] - z) * floatAxisZ + farLoose;
    return (Float.floatToRawIntBits(far) | left.sign(boxes, at, x, y, z) | right.sign(boxes, at, x, y, z)
        | below.sign(boxes, at, x, y, z) | above.sign(boxes, at, x, y, z)) < 0;
  }

  /**
   * Finds the pixels whose rays may cross a box.
   *
   * @param box a finite box
   * @return whether there are any; if so, {@link #firstColumn} and its kin say which
   */
  boolean project(final BoundingBox box) {
    final double x = 0.5 * ((double) box.minX() + box.maxX()) - originX, hx = 0.5 * ((double) box.maxX() - box.minX());
    final double y = 0.5 * ((double) box.minY() + box.maxY()) - originY, hy = 0.5 * ((double) box.maxY() - box.minY());
    final double z = 0.5 * ((double) box.minZ() + box.maxZ()) - originZ, hz = 0.5 * ((double) box.maxZ() - box.minZ());
    final double depth = depthX * x + depthY * y + depthZ * z + depthAt;
    final double reach = Math.abs(depthX) * hx + Math.abs(depthY) * hy + Math.abs(depthZ) * hz;
    if (!(depth - reach > least)) {
      return all() && depth + reach >= -least;
    }
    final double c = columnX * x + columnY * y + columnZ * z + columnAt;
    final double overC = Math.abs(columnX) * hx + Math.abs(columnY) * hy + Math.abs(columnZ) * hz;
    final double r = rowX * x + rowY * y + rowZ * z + rowAt;
    final double overR = Math.abs(rowX) * hx + Math.abs(rowY) * hy + Math.abs(rowZ) * hz;
    return limit(quotient(c - overC, depth + reach, depth - reach), quotient(c + overC, depth - reach, depth + reach),
        quotient(r - overR, depth + reach, depth - reach), quotient(r + overR, depth - reach, depth + reach));
  }

  private static double quotient(final double number, final double ifPositive, final double ifNegative) {
    return number / (number > 0 ? ifPositive : ifNegative);
  }

  /**
   * Finds the pixels whose rays may meet a triangle, whose vertices are given less the origin.
   *
   * @param ax first coordinate of the first vertex
   * @param ay second coordinate of the first vertex
   * @param az third coordinate of the first vertex
   * @param bx first coordinate of the second vertex
   * @param by second coordinate of the second vertex
   * @param bz third coordinate of the second vertex
   * @param cx first coordinate of the third vertex
   * @param cy second coordinate of the third vertex
   * @param cz third coordinate of the third vertex
   * @return whether there are any; if so, {@link #firstColumn} and its kin say which
   */
  public boolean project(final double ax, final double ay, final double az,
      final double bx, final double by, final double bz, final double cx, final double cy, final double cz) {
    final double a = depthX * ax + depthY * ay + depthZ * az + depthAt;
    final double b = depthX * bx + depthY * by + depthZ * bz + depthAt;
    final double c = depthX * cx + depthY * cy + depthZ * cz + depthAt;
    if (!(a > least && b > least && c > least)) {
      return all() && !(a < -least && b < -least && c < -least);
    }
    final double ka = 1 / a, kb = 1 / b, kc = 1 / c;
    final double ca = (columnX * ax + columnY * ay + columnZ * az + columnAt) * ka;
    final double cb = (columnX * bx + columnY * by + columnZ * bz + columnAt) * kb;
    final double cc = (columnX * cx + columnY * cy + columnZ * cz + columnAt) * kc;
    final double ra = (rowX * ax + rowY * ay + rowZ * az + rowAt) * ka;
    final double rb = (rowX * bx + rowY * by + rowZ * bz + rowAt) * kb;
    final double rc = (rowX * cx + rowY * cy + rowZ * cz + rowAt) * kc;
    return limit(Math.min(ca, Math.min(cb, cc)), Math.max(ca, Math.max(cb, cc)),
        Math.min(ra, Math.min(rb, rc)), Math.max(ra, Math.max(rb, rc)));
  }

  /** Makes all of the tile the window. */
  boolean all() {
    leastColumn = -1;
    mostColumn = columns;
    leastRow = -1;
    mostRow = rows;
    firstColumn = 0;
    lastColumn = columns - 1;
    firstRow = 0;
    lastRow = rows - 1;
    return true;
  }

  /** Limits the window to the pixels that lie, with the margin, between two columns and two rows. */
  private boolean limit(final double fromColumn, final double toColumn, final double fromRow, final double toRow) {
    final double left = fromColumn - columnMargin, right = toColumn + columnMargin;
    final double bottom = fromRow - rowMargin, top = toRow + rowMargin;
    leastColumn = left;
    mostColumn = right;
    leastRow = bottom;
    mostRow = top;
    if (right < 0 || left > columns - 1 || top < 0 || bottom > rows - 1) {
      return false;
    }
    firstColumn = (int) Math.max(0, left + UP);
    lastColumn = (int) Math.min(columns - 1, right);
    firstRow = (int) Math.max(0, bottom + UP);
    lastRow = (int) Math.min(rows - 1, top);
    return between || firstColumn <= lastColumn && firstRow <= lastRow;
  }

  /**
   * Whether all rays of the tile have the same start.
   *
   * @return true for a pyramid, false for a prism
   */
  public boolean isPyramid() {
    return grid.pyramid;
  }

  /**
   * First coordinate of the origin: the start of the first ray, and of all rays of a pyramid.
   *
   * @return the number
   */
  public double originX() {
    return originX;
  }

  /**
   * Second coordinate of the origin.
   *
   * @return the number
   */
  public double originY() {
    return originY;
  }

  /**
   * Third coordinate of the origin.
   *
   * @return the number
   */
  public double originZ() {
    return originZ;
  }

  double leastColumn() {
    return leastColumn;
  }

  double mostColumn() {
    return mostColumn;
  }

  double leastRow() {
    return leastRow;
  }

  double mostRow() {
    return mostRow;
  }

  /**
   * First column found by the last projection.
   *
   * @return the number
   */
  public int firstColumn() {
    return firstColumn;
  }

  /**
   * Last column found.
   *
   * @return the number
   */
  public int lastColumn() {
    return lastColumn;
  }

  /**
   * First row found.
   *
   * @return the number
   */
  public int firstRow() {
    return firstRow;
  }

  /**
   * Last row found.
   *
   * @return the number
   */
  public int lastRow() {
    return lastRow;
  }
}
