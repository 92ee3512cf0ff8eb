package acceleration;

/**
 * Fits a regular grid to the rays of a tile. With q = d / (d·W) for a pyramid of rays with one start and mean direction W,
 * or q = start − first start for a prism of rays with one direction W, it finds two vectors perpendicular to W and two
 * numbers such that a·q + a₀ ≈ column and b·q + b₀ ≈ row for all rays, and how far from equality the worst of them is.
 */
final class GridFit {

  /** Least sine of the angle between the directions in which columns and rows grow. */
  private static final double DISTINCT = 1e-3;

  /** Step between pixels where there is only one column or row, so that any value serves. */
  private static final double ANY_STEP = 1e-3;

  private RayTile tile;
  private TileGrid grid;
  private double wx;
  private double wy;
  private double wz;
  private double ax;
  private double ay;
  private double az;
  private double bx;
  private double by;
  private double bz;
  private int first;
  private int end;
  private double stepX;
  private double stepY;
  private double stepZ;

  /** Fits the grid; returns whether the rays allow it. */
  boolean fit(final RayTile rays, final TileGrid fitted) {
    tile = rays;
    grid = fitted;
    end = RayTile.SIZE * rays.rows();
    return findAxis() && findGrid() && findMargins();
  }

  /** Finds what the rays have in common, and W. */
  private boolean findAxis() {
    first = 0;
    while (first < end && !tile.isPresent(first)) {
      first++;
    }
    if (first == end) {
      return false;
    }
    final double originX = tile.startX(first), originY = tile.startY(first), originZ = tile.startZ(first);
    boolean direction = true, pyramid = true;
    double x = 0, y = 0, z = 0;
    for (int i = first; i < end; i++) {
      if (tile.isPresent(i)) {
        pyramid &= tile.startX(i) == originX && tile.startY(i) == originY && tile.startZ(i) == originZ;
        direction &= tile.directionX(i) == tile.directionX(first) && tile.directionY(i) == tile.directionY(first)
            && tile.directionZ(i) == tile.directionZ(first);
        x += tile.directionX(i);
        y += tile.directionY(i);
        z += tile.directionZ(i);
      }
    }
    grid.setOrigin(originX, originY, originZ);
    grid.pyramid = pyramid;
    grid.setAxis(x, y, z);
    wx = grid.axisX;
    wy = grid.axisY;
    wz = grid.axisZ;
    return pyramid || direction;
  }

  private boolean findGrid() {
    sumSteps(tile.rows(), RayTile.SIZE, tile.columns(), 1);
    final double cx = stepX, cy = stepY, cz = stepZ;
    sumSteps(tile.columns(), 1, tile.rows(), RayTile.SIZE);
    final double rx = stepX, ry = stepY, rz = stepZ;
    final boolean noColumns = cx == 0 && cy == 0 && cz == 0, noRows = rx == 0 && ry == 0 && rz == 0;
    if (noColumns && noRows) {
      final double s = Math.abs(wx) < 0.5 ? 1 : 0;
      return dual(ANY_STEP * (s - s * wx * wx - (1 - s) * wx * wy), ANY_STEP * ((1 - s) - s * wx * wy - (1 - s) * wy * wy),
          ANY_STEP * (-s * wx * wz - (1 - s) * wy * wz), true, 0, 0, 0);
    }
    return noColumns ? dual(ry * wz - rz * wy, rz * wx - rx * wz, rx * wy - ry * wx, false, rx, ry, rz)
        : dual(cx, cy, cz, noRows, rx, ry, rz);
  }

  /** The a and b dual to the steps of q along columns and rows; where there are no rows, any perpendicular step serves. */
  private boolean dual(final double cx, final double cy, final double cz, final boolean anyRows,
      final double x, final double y, final double z) {
    final double rx = anyRows ? wy * cz - wz * cy : x, ry = anyRows ? wz * cx - wx * cz : y;
    final double rz = anyRows ? wx * cy - wy * cx : z;
    ax = ry * wz - rz * wy;
    ay = rz * wx - rx * wz;
    az = rx * wy - ry * wx;
    bx = wy * cz - wz * cy;
    by = wz * cx - wx * cz;
    bz = wx * cy - wy * cx;
    grid.setAcross(cx, cy, cz);
    grid.setUp(rx, ry, rz);
    final double area = ax * cx + ay * cy + az * cz;
    final double most = Math.sqrt((cx * cx + cy * cy + cz * cz) * (rx * rx + ry * ry + rz * rz));
    if (!(Math.abs(area) > DISTINCT * most)) {
      return false;
    }
    ax /= area;
    ay /= area;
    az /= area;
    bx /= area;
    by /= area;
    bz /= area;
    return true;
  }

  /** Mean step of q along lines of pixels: from the first to the last ray of each. */
  private void sumSteps(final int lines, final int lineStride, final int pixels, final int stride) {
    final boolean pyramid = grid.pyramid;
    double x = 0, y = 0, z = 0;
    int steps = 0;
    for (int line = 0; line < lines; line++) {
      int i = line * lineStride, j = i + (pixels - 1) * stride;
      while (i < j && !tile.isPresent(i)) {
        i += stride;
      }
      while (i < j && !tile.isPresent(j)) {
        j -= stride;
      }
      if (i < j) {
        steps += (j - i) / stride;
        final double k = 1 / depthOf(i), l = 1 / depthOf(j);
        x += pyramid ? tile.directionX(j) * l - tile.directionX(i) * k : tile.startX(j) - tile.startX(i);
        y += pyramid ? tile.directionY(j) * l - tile.directionY(i) * k : tile.startY(j) - tile.startY(i);
        z += pyramid ? tile.directionZ(j) * l - tile.directionZ(i) * k : tile.startZ(j) - tile.startZ(i);
      }
    }
    stepX = x / Math.max(1, steps);
    stepY = y / Math.max(1, steps);
    stepZ = z / Math.max(1, steps);
  }

  private double depthOf(final int i) {
    return tile.directionX(i) * wx + tile.directionY(i) * wy + tile.directionZ(i) * wz;
  }

  /** Finds a₀ and b₀ in the middle of the values that the rays need, and the margins about them. */
  private boolean findMargins() {
    final boolean pyramid = grid.pyramid;
    double leastA = Double.POSITIVE_INFINITY, mostA = Double.NEGATIVE_INFINITY;
    double leastB = Double.POSITIVE_INFINITY, mostB = Double.NEGATIVE_INFINITY, narrowest = 1;
    for (int row = 0; row < tile.rows(); row++) {
      double column = -1;
      for (int i = row * RayTile.SIZE; i < row * RayTile.SIZE + tile.columns(); i++) {
        column++;
        if (tile.isPresent(i)) {
          final double depth = depthOf(i), k = pyramid ? 1 / depth : 1;
          final double x = pyramid ? tile.directionX(i) : tile.startX(i) - grid.originX;
          final double y = pyramid ? tile.directionY(i) : tile.startY(i) - grid.originY;
          final double z = pyramid ? tile.directionZ(i) : tile.startZ(i) - grid.originZ;
          final double offA = column - k * (ax * x + ay * y + az * z), offB = row - k * (bx * x + by * y + bz * z);
          narrowest = depth < narrowest ? depth : narrowest;
          leastA = offA < leastA ? offA : leastA;
          mostA = offA > mostA ? offA : mostA;
          leastB = offB < leastB ? offB : leastB;
          mostB = offB > mostB ? offB : mostB;
        }
      }
    }
    grid.columnMargin = 0.5 * (mostA - leastA);
    grid.rowMargin = 0.5 * (mostB - leastB);
    takeForms(0.5 * (leastA + mostA), 0.5 * (leastB + mostB));
    return narrowest > TileGrid.NARROW && grid.columnMargin < RayTile.SIZE && grid.rowMargin < RayTile.SIZE;
  }

  private void takeForms(final double a0, final double b0) {
    if (grid.pyramid) {
      grid.setColumn(ax + a0 * wx, ay + a0 * wy, az + a0 * wz, 0);
      grid.setRow(bx + b0 * wx, by + b0 * wy, bz + b0 * wz, 0);
      grid.setDepth(wx, wy, wz, 0);
      takeRays(a0, b0);
    } else {
      grid.setColumn(ax, ay, az, a0);
      grid.setRow(bx, by, bz, b0);
      grid.setDepth(0, 0, 0, 1);
    }
  }

  /** By what the margins are a ray is W + (i − a₀ ± margin) S + (j − b₀ ± margin) T, with a and b dual to S and T. */
  private void takeRays(final double a0, final double b0) {
    final TileGrid g = grid;
    final double column = g.columnMargin + TileFrustum.ROUNDING, row = g.rowMargin + TileFrustum.ROUNDING;
    g.setCorner(wx - a0 * g.acrossX - b0 * g.upX, wy - a0 * g.acrossY - b0 * g.upY, wz - a0 * g.acrossZ - b0 * g.upZ);
    g.setStray(column * Math.abs(g.acrossX) + row * Math.abs(g.upX), column * Math.abs(g.acrossY) + row * Math.abs(g.upY),
        column * Math.abs(g.acrossZ) + row * Math.abs(g.upZ));
  }
}
