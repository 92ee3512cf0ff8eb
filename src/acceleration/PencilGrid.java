package acceleration;

/**
 * The grid of the rays of a {@link Pencil}, by derivation instead of measurement.
 *
 * <p>The ray of column i and row j has the direction d = X aᵢ + (Y bⱼ + L). If the centres aᵢ and bⱼ were evenly spaced and
 * nothing were rounded, that would be g = G + i S + j T, with G the direction of pixel (0, 0), S the step X (aₙ − a₀) / n
 * and T the same for rows. The basis C, R, D dual to S, T, G then gives C·g = i, R·g = j, D·g = 1, so that C·V / D·V is the
 * column of a point V.
 *
 * <p><b>The margin.</b> In truth the direction is a positive multiple of g + e, and no component of e exceeds
 * E = (2<sup>-24</sup> + 2<sup>-44</sup>) B + |X| α + |Y| β, where B = |X| max |aᵢ| + |Y| max |bⱼ| + |L|, which bounds every
 * |d|, and α and β are how far the centres are found to stray from even spacing:
 * <ul>
 * <li>rounding a component to the 24 digits of a float moves it by at most 2<sup>-24</sup> |d|;</li>
 * <li>uneven centres move it by |X| α + |Y| β;</li>
 * <li>about 40 roundings of double, in d, in G, S, T (of i S: i |S| ≤ 2 |X| max |a|) and in scaling d, are below
 *     40 · 2<sup>-53</sup> B.</li>
 * </ul>
 * Nor are the forms exact: let |C·g − i| ≤ ρ and |D·g − 1| ≤ σ over the tile, which is found by applying them to G, S and T
 * (n times as much for S and T as they do once); evaluating that is wrong by no more than a few 2<sup>-53</sup> Σ |C| B,
 * which the surplus of 2<sup>-44</sup> B in E covers as well. With n the greatest i, the ray's own column is then off by
 * <blockquote>
 * |C·(g+e) − i D·(g+e)| / D·(g+e)  ≤  (ρ + Σ|C|E + n (σ + Σ|D|E)) / (1 − σ − Σ|D|E).
 * </blockquote>
 */
final class PencilGrid {

  /** Bound of the rounding of a component to float, with what double needs added. */
  private static final double ROUNDING = 0x1p-24 + 0x1p-44;

  /** Greatest margin, in pixels, that is of any use; larger ones are left to measurement. */
  private static final double USEFUL = 0.5;

  /** Bound of each component of e. */
  private double errorX;
  private double errorY;
  private double errorZ;

  private double sx;
  private double sy;
  private double sz;
  private double tx;
  private double ty;
  private double tz;
  private double gx;
  private double gy;
  private double gz;
  private int lastColumn;
  private int lastRow;

  /**
   * Derives the grid of a tile.
   *
   * @param a the column centres of all pixels, {@code RayTile.SIZE} to a row
   * @param b the row centres of all pixels
   * @return false if it is too narrow or too wide for that, or has a single column or row
   */
  boolean derive(final Pencil p, final RayTile tile, final double[] a, final double[] b, final TileGrid grid) {
    lastColumn = tile.columns() - 1;
    lastRow = tile.rows() - 1;
    if (lastColumn == 0 || lastRow == 0) {
      return false;
    }
    final double stepA = (a[lastColumn] - a[0]) / lastColumn, stepB = (b[RayTile.SIZE * lastRow] - b[0]) / lastRow;
    takeSteps(p, a[0], b[0], stepA, stepB);
    final int top = RayTile.SIZE * lastRow;
    bound(p, Math.max(Math.abs(a[0]), Math.abs(a[lastColumn])), Math.max(Math.abs(b[0]), Math.abs(b[top])),
        unevenness(a, 1, lastColumn, stepA), unevenness(b, RayTile.SIZE, lastRow, stepB));
    takeForms(grid);
    takeMargins(grid);
    grid.setCorner(gx, gy, gz);
    grid.setAcross(sx, sy, sz);
    grid.setUp(tx, ty, tz);
    grid.setStray(errorX, errorY, errorZ);
    grid.pyramid = true;
    grid.setOrigin(p.startX, p.startY, p.startZ);
    return grid.columnMargin < USEFUL && grid.rowMargin < USEFUL && takeAxis(tile, grid);
  }

  private void takeSteps(final Pencil p, final double a, final double b, final double stepA, final double stepB) {
    sx = p.acrossX * stepA;
    sy = p.acrossY * stepA;
    sz = p.acrossZ * stepA;
    tx = p.upX * stepB;
    ty = p.upY * stepB;
    tz = p.upZ * stepB;
    gx = p.acrossX * a + (p.upX * b + p.lookX);
    gy = p.acrossY * a + (p.upY * b + p.lookY);
    gz = p.acrossZ * a + (p.upZ * b + p.lookZ);
  }

  /** How far the centres of columns or rows stray from even spacing. */
  private static double unevenness(final double[] centres, final int stride, final int last, final double step) {
    double most = 0;
    for (int i = 1; i < last; i++) {
      most = Math.max(most, Math.abs(centres[stride * i] - (centres[0] + i * step)));
    }
    return most;
  }

  private void bound(final Pencil p, final double mostA, final double mostB, final double alpha, final double beta) {
    final double a = ROUNDING * mostA + alpha, b = ROUNDING * mostB + beta;
    errorX = Math.abs(p.acrossX) * a + Math.abs(p.upX) * b + ROUNDING * Math.abs(p.lookX);
    errorY = Math.abs(p.acrossY) * a + Math.abs(p.upY) * b + ROUNDING * Math.abs(p.lookY);
    errorZ = Math.abs(p.acrossZ) * a + Math.abs(p.upZ) * b + ROUNDING * Math.abs(p.lookZ);
  }

  /** The dual basis, by cross products. */
  private void takeForms(final TileGrid grid) {
    final double dx = sy * tz - sz * ty, dy = sz * tx - sx * tz, dz = sx * ty - sy * tx;
    final double k = 1 / (gx * dx + gy * dy + gz * dz);
    grid.setColumn(k * (ty * gz - tz * gy), k * (tz * gx - tx * gz), k * (tx * gy - ty * gx), 0);
    grid.setRow(k * (gy * sz - gz * sy), k * (gz * sx - gx * sz), k * (gx * sy - gy * sx), 0);
    grid.setDepth(k * dx, k * dy, k * dz, 0);
  }

  private void takeMargins(final TileGrid g) {
    final double sigma = stray(g.depthX, g.depthY, g.depthZ, 0, 0, 1);
    final double depth = sigma + error(g.depthX, g.depthY, g.depthZ);
    final double column = stray(g.columnX, g.columnY, g.columnZ, 1, 0, 0) + error(g.columnX, g.columnY, g.columnZ);
    final double row = stray(g.rowX, g.rowY, g.rowZ, 0, 1, 0) + error(g.rowX, g.rowY, g.rowZ);
    g.columnMargin = depth < 1 ? (column + lastColumn * depth) / (1 - depth) : Double.NaN;
    g.rowMargin = depth < 1 ? (row + lastRow * depth) / (1 - depth) : Double.NaN;
  }

  /** How far a form can be, over the tile, from its exact value at S, T and G. */
  private double stray(final double x, final double y, final double z, final int atS, final int atT, final int atG) {
    return lastColumn * Math.abs(x * sx + y * sy + z * sz - atS) + lastRow * Math.abs(x * tx + y * ty + z * tz - atT)
        + Math.abs(x * gx + y * gy + z * gz - atG);
  }

  private double error(final double x, final double y, final double z) {
    return Math.abs(x) * errorX + Math.abs(y) * errorY + Math.abs(z) * errorZ;
  }

  /** The sum of the rays in the corners as axis; if none of them is far from it, neither is any ray between them. */
  private boolean takeAxis(final RayTile tile, final TileGrid grid) {
    final int top = RayTile.SIZE * lastRow;
    grid.setAxis(
        tile.directionX(0) + tile.directionX(lastColumn) + tile.directionX(top) + tile.directionX(top + lastColumn),
        tile.directionY(0) + tile.directionY(lastColumn) + tile.directionY(top) + tile.directionY(top + lastColumn),
        tile.directionZ(0) + tile.directionZ(lastColumn) + tile.directionZ(top) + tile.directionZ(top + lastColumn));
    return Math.min(Math.min(cosine(tile, grid, 0), cosine(tile, grid, lastColumn)),
        Math.min(cosine(tile, grid, top), cosine(tile, grid, top + lastColumn))) > TileGrid.NARROW;
  }

  private static double cosine(final RayTile tile, final TileGrid grid, final int i) {
    return tile.directionX(i) * grid.axisX + tile.directionY(i) * grid.axisY + tile.directionZ(i) * grid.axisZ;
  }
}
