package acceleration;

/** Finds the pyramid or prism of the segments of a {@link SegmentTile}, and the place of each in its raster. */
final class SegmentFit {

  private static final int MOST = SegmentTile.MOST;

  /** Last column and row of the raster. */
  private static final int LAST = SegmentTile.SIZE - 1;

  /** Least extent of the raster, as a slope or relative to the starts' distances. */
  private static final double LEAST_EXTENT = 1e-6;

  /** Displacement, relative to a segment's length, from which on segments have no common end. */
  private static final double APART = 1e-4;

  /** Bound of the rounding of a difference of coordinates and of what is computed with it, relative to them. */
  private static final double ROUNDING = 0x1p-48;

  /** Greatest difference of directions that count as one. */
  private static final double ONE_DIRECTION = 1e-9;

  private final SegmentTile tile;
  private final TileGrid grid;

  /** Two vectors of unit length perpendicular to the axis. */
  private double ux;
  private double uy;
  private double uz;
  private double vx;
  private double vy;
  private double vz;

  /** Greatest difference of a direction from the first. */
  private double bend;

  private double leastU;
  private double mostU;
  private double leastV;
  private double mostV;

  SegmentFit(final SegmentTile tile, final TileGrid grid) {
    this.tile = tile;
    this.grid = grid;
  }

  boolean fit() {
    leastU = Double.POSITIVE_INFINITY;
    mostU = Double.NEGATIVE_INFINITY;
    leastV = Double.POSITIVE_INFINITY;
    mostV = Double.NEGATIVE_INFINITY;
    grid.pyramid = !haveOneDirection();
    return grid.pyramid ? fitPyramid() : fitPrism();
  }

  /** Whether directions differ by no more than rounding makes of one; by how much, goes into the displacement later. */
  private boolean haveOneDirection() {
    final int f = tile.first();
    bend = 0;
    for (int i = 0; i < MOST; i++) {
      if (tile.isOpen(i)) {
        bend = Math.max(bend, Math.abs(tile.directionX(i) - tile.directionX(f))
            + Math.abs(tile.directionY(i) - tile.directionY(f)) + Math.abs(tile.directionZ(i) - tile.directionZ(f)));
      }
    }
    return bend < ONE_DIRECTION;
  }

  private boolean fitPyramid() {
    final int f = tile.first();
    final double length = tile.length(f);
    grid.setOrigin(tile.startX(f) + length * tile.directionX(f), tile.startY(f) + length * tile.directionY(f),
        tile.startZ(f) + length * tile.directionZ(f));
    takeMeanDirection();
    takePerpendiculars();
    boolean possible = true;
    for (int i = 0; possible && i < MOST; i++) {
      if (tile.isOpen(i)) {
        possible = place(i);
      }
    }
    return possible && takePyramid();
  }

  private void takeMeanDirection() {
    double x = 0, y = 0, z = 0;
    for (int i = 0; i < MOST; i++) {
      if (tile.isOpen(i)) {
        x -= tile.directionX(i);
        y -= tile.directionY(i);
        z -= tile.directionZ(i);
      }
    }
    grid.setAxis(x, y, z);
  }

  private void takePerpendiculars() {
    final double x = grid.axisX, y = grid.axisY, z = grid.axisZ;
    final double sx = Math.abs(x) < 0.5 ? 1 : 0, sy = 1 - sx;
    final double px = -sy * z, py = sx * z, pz = sy * x - sx * y, length = Math.sqrt(px * px + py * py + pz * pz);
    ux = px / length;
    uy = py / length;
    uz = pz / length;
    vx = y * uz - z * uy;
    vy = z * ux - x * uz;
    vz = x * uy - y * ux;
  }

  /** Finds the slopes of a segment from the light on; returns whether it ends there and is not far from the axis. */
  private boolean place(final int i) {
    final double x = tile.startX(i) - grid.originX, y = tile.startY(i) - grid.originY, z = tile.startZ(i) - grid.originZ;
    final double distance = Math.sqrt(x * x + y * y + z * z), depth = x * grid.axisX + y * grid.axisY + z * grid.axisZ;
    final double ex = x + distance * tile.directionX(i), ey = y + distance * tile.directionY(i);
    final double ez = z + distance * tile.directionZ(i), error = Math.sqrt(ex * ex + ey * ey + ez * ez);
    grid.displacement = Math.max(grid.displacement, error + ROUNDING * distance);
    put(i, (x * ux + y * uy + z * uz) / depth, (x * vx + y * vy + z * vz) / depth);
    return depth > TileGrid.NARROW * distance && grid.displacement < APART * distance;
  }

  private void put(final int i, final double u, final double v) {
    leastU = Math.min(leastU, u);
    mostU = Math.max(mostU, u);
    leastV = Math.min(leastV, v);
    mostV = Math.max(mostV, v);
    tile.place(i, u, v);
  }

  private boolean takePyramid() {
    final double k = LAST / Math.max(LEAST_EXTENT, mostU - leastU), l = LAST / Math.max(LEAST_EXTENT, mostV - leastV);
    final double x = grid.axisX, y = grid.axisY, z = grid.axisZ;
    grid.setColumn(k * (ux - leastU * x), k * (uy - leastU * y), k * (uz - leastU * z), 0);
    grid.setRow(l * (vx - leastV * x), l * (vy - leastV * y), l * (vz - leastV * z), 0);
    grid.setDepth(x, y, z, 0);
    final double steepest = 1 + Math.max(Math.max(-leastU, mostU), Math.max(-leastV, mostV));
    grid.columnMargin = k * steepest / TileFrustum.STRAIGHT;
    grid.rowMargin = l * steepest / TileFrustum.STRAIGHT;
    scale(k, l);
    return true;
  }

  private boolean fitPrism() {
    final int f = tile.first();
    grid.setOrigin(tile.startX(f), tile.startY(f), tile.startZ(f));
    grid.setAxis(tile.directionX(f), tile.directionY(f), tile.directionZ(f));
    takePerpendiculars();
    double farthest = 0;
    for (int i = 0; i < MOST; i++) {
      if (tile.isOpen(i)) {
        final double x = tile.startX(i) - grid.originX, y = tile.startY(i) - grid.originY, z = tile.startZ(i) - grid.originZ;
        final double ahead = x * grid.axisX + y * grid.axisY + z * grid.axisZ;
        grid.ahead = Math.max(grid.ahead, ahead);
        grid.behind = Math.max(grid.behind, -ahead);
        farthest = Math.max(farthest, Math.abs(x) + Math.abs(y) + Math.abs(z) + tile.length(i));
        put(i, x * ux + y * uy + z * uz, x * vx + y * vy + z * vz);
      }
    }
    grid.displacement = (bend + ROUNDING) * farthest;
    return takePrism(LEAST_EXTENT * farthest);
  }

  private boolean takePrism(final double least) {
    final double k = LAST / Math.max(least, mostU - leastU), l = LAST / Math.max(least, mostV - leastV);
    grid.setColumn(k * ux, k * uy, k * uz, -k * leastU);
    grid.setRow(l * vx, l * vy, l * vz, -l * leastV);
    grid.setDepth(0, 0, 0, 1);
    grid.columnMargin = k * grid.displacement;
    grid.rowMargin = l * grid.displacement;
    scale(k, l);
    return k < Double.POSITIVE_INFINITY && l < Double.POSITIVE_INFINITY;
  }

  /** Turns slopes or offsets into places in the raster. */
  private void scale(final double k, final double l) {
    for (int i = 0; i < MOST; i++) {
      if (tile.isOpen(i)) {
        tile.place(i, k * (tile.column(i) - leastU), l * (tile.row(i) - leastV));
      }
    }
  }
}
