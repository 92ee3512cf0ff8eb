package acceleration;

import primitives.BoundingBox;

/**
 * The pyramid or prism that encloses the rays of a tile, and the projection of space onto the tile's pixels.
 *
 * <p>It is computed from the rays alone, whatever camera made them. If they share a start, their slopes about the mean
 * direction are nearly a regular grid (a pyramid); if they share a direction, their starts are (a prism). A grid is
 * fitted, and how far the rays stray from it, in pixels, is kept as a margin: each ray is projected to within the margin
 * of its own column and row. So all results are conservative: nothing that a ray of the tile can hit is reported as
 * outside. Rays that share neither start nor direction are not fitted.
 *
 * <p>The projection is homogeneous: with V = P − O, column = (C·V + c) / (D·V + d) and the same for the row, where D·V +
 * d is the depth in a pyramid and 1 in a prism. Enclosing rays by planes to trace them together: Reshetov, Soupikov and
 * Hurley, "Multi-Level Ray Tracing Algorithm", SIGGRAPH 2005.
 */
public final class TileFrustum {

  /** Added to the margin, in pixels, for the rounding of double. */
  static final double ROUNDING = 1e-6;

  /**
   * Depth below which a projection may be off by more than {@link #ROUNDING}, relative to the sum of |n| |V| of a side
   * plane: some ten roundings of 2^-53 in C·V, and as many in D·V times the greatest column.
   */
  private static final double SHALLOW = 1e-8;

  /**
   * The same for a prism, which has no depth that keeps the error small: of a projection relative to that sum, some sixteen
   * roundings of 2^-53 in C·V, and in half the sum and the difference of a box's coordinates.
   */
  private static final double HUGE = 0x1p-48;

  /** Multiples of the displacement from which on a displaced line is taken for one through the origin. */
  static final double STRAIGHT = 1e6;

  private final TileGrid grid = new TileGrid();
  private final GridFit measured = new GridFit();
  private final PencilGrid derived = new PencilGrid();

  private final TileSides sides = new TileSides();
  private final TileWindow window = new TileWindow();
  private final TileCoverage coverage = new TileCoverage(grid, window);

  private boolean fitted;

  /** Depth below which vertices within the box last prepared for are not projected. */
  private double least;
  private double columnMargin;
  private double rowMargin;

  /** Depth of the nearest point of what was projected last; negative infinity if it is not known. */
  private double leastDepth;

  TileFrustum() {
  }

  /** Encloses the rays of a tile, if possible. */
  void fit(final RayTile tile) {
    final boolean possible = measured.fit(tile, grid);
    if (possible && !grid.pyramid) {
      findStarts(tile);
    }
    enclose(possible, tile.columns(), tile.rows(), false);
  }

  /** Encloses the rays that the tile made of a pencil and the centres of its pixels. */
  void fit(final RayTile tile, final Pencil pencil, final double[] a, final double[] b) {
    enclose(derived.derive(pencil, tile, a, b, grid) || measured.fit(tile, grid), tile.columns(), tile.rows(), false);
  }

  /** The grid to be found by whoever encloses rays of another kind. */
  TileGrid grid() {
    return grid;
  }

  /** Takes the grid of rays that may lie between columns and rows, of so many of each, if it was possible to find it. */
  void encloseRaster(final boolean possible, final int size) {
    enclose(possible, size, size, true);
  }

  private void enclose(final boolean possible, final int columns, final int rows, final boolean between) {
    fitted = possible;
    window.open(columns, rows, between);
    if (fitted) {
      least = grid.pyramid ? STRAIGHT * grid.displacement : 0;
      columnMargin = grid.columnMargin + ROUNDING;
      rowMargin = grid.rowMargin + ROUNDING;
      sides.enclose(grid, columns, rows, columnMargin, rowMargin);
    }
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

  /**
   * Whether the rays are enclosed; if not, no other method may be called.
   *
   * @return false if the rays have nothing in common, are spread too far, or are none
   */
  public boolean isFitted() {
    return fitted;
  }

  /**
   * Prepares for boxes, and triangles, that lie within a box.
   *
   * @return false if floats could overflow, so that {@link #sides} must not be used
   */
  boolean prepare(final float[] whole) {
    final boolean possible = sides.prepare(whole);
    least = grid.pyramid ? Math.max(SHALLOW * sides.greatest(), STRAIGHT * grid.displacement) : 0;
    final double rounding = grid.pyramid ? ROUNDING : ROUNDING + HUGE * sides.greatest();
    columnMargin = grid.columnMargin + rounding;
    rowMargin = grid.rowMargin + rounding;
    return possible;
  }

  /** The sides, which leave out boxes within the one last prepared for. */
  TileSides sides() {
    return sides;
  }

  /**
   * Finds the pixels whose rays may hit a box.
   *
   * @param box a finite box
   * @return whether there are any; if so, the {@link #window} says which
   */
  boolean project(final BoundingBox box) {
    return project(box.minX(), box.minY(), box.minZ(), box.maxX(), box.maxY(), box.maxZ());
  }

  /** The same for the least and the greatest coordinates of a box. */
  boolean project(final double fromX, final double fromY, final double fromZ,
      final double toX, final double toY, final double toZ) {
    final TileGrid g = grid;
    final double x = 0.5 * (fromX + toX) - g.originX, hx = 0.5 * (toX - fromX);
    final double y = 0.5 * (fromY + toY) - g.originY, hy = 0.5 * (toY - fromY);
    final double z = 0.5 * (fromZ + toZ) - g.originZ, hz = 0.5 * (toZ - fromZ);
    final double depth = g.depthX * x + g.depthY * y + g.depthZ * z + g.depthAt;
    final double reach = Math.abs(g.depthX) * hx + Math.abs(g.depthY) * hy + Math.abs(g.depthZ) * hz;
    leastDepth = Double.NEGATIVE_INFINITY;
    if (!(depth - reach > least)) {
      return window.all() && depth + reach >= -least;
    }
    leastDepth = g.pyramid ? depth - reach : Double.NEGATIVE_INFINITY;
    final double near = 1 / (depth - reach), far = 1 / (depth + reach);
    final double c = g.columnX * x + g.columnY * y + g.columnZ * z + g.columnAt;
    final double overC = Math.abs(g.columnX) * hx + Math.abs(g.columnY) * hy + Math.abs(g.columnZ) * hz;
    final double r = g.rowX * x + g.rowY * y + g.rowZ * z + g.rowAt;
    final double overR = Math.abs(g.rowX) * hx + Math.abs(g.rowY) * hy + Math.abs(g.rowZ) * hz;
    return limit(Math.min((c - overC) * near, (c - overC) * far), Math.max((c + overC) * near, (c + overC) * far),
        Math.min((r - overR) * near, (r - overR) * far), Math.max((r + overR) * near, (r + overR) * far));
  }

  /**
   * Finds the pixels whose rays may hit a triangle, whose vertices are given relative to the origin.
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
   * @return whether there are any; if so, the {@link #window} says which
   */
  public boolean project(final double ax, final double ay, final double az,
      final double bx, final double by, final double bz, final double cx, final double cy, final double cz) {
    final TileGrid g = grid;
    final double a = g.depthX * ax + g.depthY * ay + g.depthZ * az + g.depthAt;
    final double b = g.depthX * bx + g.depthY * by + g.depthZ * bz + g.depthAt;
    final double c = g.depthX * cx + g.depthY * cy + g.depthZ * cz + g.depthAt;
    leastDepth = Double.NEGATIVE_INFINITY;
    if (!(a > least && b > least && c > least)) {
      return window.all() && !(a < -least && b < -least && c < -least);
    }
    leastDepth = g.pyramid ? Math.min(a, Math.min(b, c)) : Double.NEGATIVE_INFINITY;
    final double ka = 1 / a, kb = 1 / b, kc = 1 / c;
    final double ca = (g.columnX * ax + g.columnY * ay + g.columnZ * az + g.columnAt) * ka;
    final double cb = (g.columnX * bx + g.columnY * by + g.columnZ * bz + g.columnAt) * kb;
    final double cc = (g.columnX * cx + g.columnY * cy + g.columnZ * cz + g.columnAt) * kc;
    final double ra = (g.rowX * ax + g.rowY * ay + g.rowZ * az + g.rowAt) * ka;
    final double rb = (g.rowX * bx + g.rowY * by + g.rowZ * bz + g.rowAt) * kb;
    final double rc = (g.rowX * cx + g.rowY * cy + g.rowZ * cz + g.rowAt) * kc;
    return limit(Math.min(ca, Math.min(cb, cc)), Math.max(ca, Math.max(cb, cc)),
        Math.min(ra, Math.min(rb, rc)), Math.max(ra, Math.max(rb, rc)));
  }

  /** Limits the window to the pixels that lie, with the margin, between two columns and two rows. */
  private boolean limit(final double fromColumn, final double toColumn, final double fromRow, final double toRow) {
    return window.limit(fromColumn - columnMargin, toColumn + columnMargin, fromRow - rowMargin, toRow + rowMargin);
  }

  /**
   * Where what was projected last may lie.
   *
   * @return the window, which each projection changes; nothing in it is valid after one that returned false
   */
  public TileWindow window() {
    return window;
  }

  double leastDepth() {
    return leastDepth;
  }

  /** Sum of the greatest coordinates of a point of a box, seen from the origin. */
  double greatest(final BoundingBox box) {
    return Math.max(Math.abs(box.minX() - grid.originX), Math.abs(box.maxX() - grid.originX))
        + Math.max(Math.abs(box.minY() - grid.originY), Math.abs(box.maxY() - grid.originY))
        + Math.max(Math.abs(box.minZ() - grid.originZ), Math.abs(box.maxZ() - grid.originZ));
  }

  /**
   * Finds which rays in the window lie on the inner side of planes, if they are a pyramid.
   *
   * @return the coverage, which is reused for each triangle
   */
  public TileCoverage coverage() {
    return coverage;
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
    return grid.originX;
  }

  /**
   * Second coordinate of the origin.
   *
   * @return the number
   */
  public double originY() {
    return grid.originY;
  }

  /**
   * Third coordinate of the origin.
   *
   * @return the number
   */
  public double originZ() {
    return grid.originZ;
  }
}
