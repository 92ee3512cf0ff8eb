package acceleration;

/** Finds the pyramid or prism of the segments of a {@link SegmentTile}, and the position of each in its raster. */
final class SegmentFit {

  /** Last column and row of the raster: less than the number of cells, so that rounding never exceeds the last cell. */
  static final double LAST = SegmentSets.CELLS - 1;

  /** Least extent of the raster, as a slope or relative to the starts' distances. */
  private static final double LEAST_EXTENT = 1e-6;

  /** Displacement, relative to a segment's length, from which on segments have no common end. */
  private static final double APART = 1e-4;

  /** Bound of the rounding of a difference of coordinates and of what is computed with it, relative to them. */
  private static final double ROUNDING = 0x1p-48;

  /** Greatest difference of directions that count as one. */
  private static final double ONE_DIRECTION = 1e-9;

  /** Segments whose mean direction is the axis. */
  private static final int SAMPLES = 16;

  private final SegmentTile tile;
  private final TileGrid grid;

  /** For each segment how far it passes the origin by, and how far from it it starts. */
  private final double[] error = new double[SegmentTile.MOST];
  private final double[] distance = new double[SegmentTile.MOST];

  private int first;
  private int end;

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

  /** Encloses the segments of some numbers; returns false if they have neither a direction nor an end in common. */
  boolean fit(final int from, final int to) {
    first = from;
    end = to;
    grid.pyramid = !haveOneDirection();
    return grid.pyramid ? fitPyramid() : fitPrism();
  }

  /** Whether directions differ by no more than rounding makes of one; by how much, goes into the displacement later. */
  private boolean haveOneDirection() {
    bend = bend(end - 1);
    for (int i = first; i < end && bend < ONE_DIRECTION; i++) {
      bend = Math.max(bend, bend(i));
    }
    return bend < ONE_DIRECTION;
  }

  private double bend(final int i) {
    return Math.abs(tile.directionX[i] - tile.directionX[first]) + Math.abs(tile.directionY[i] - tile.directionY[first])
        + Math.abs(tile.directionZ[i] - tile.directionZ[first]);
  }

  private boolean fitPyramid() {
    final double length = tile.length[first];
    grid.setOrigin(tile.startX[first] + length * tile.directionX[first],
        tile.startY[first] + length * tile.directionY[first], tile.startZ[first] + length * tile.directionZ[first]);
    takeMeanDirection();
    takePerpendiculars();
    project(tile.startX, tile.startY, tile.startZ, tile.directionX, tile.directionY, tile.directionZ,
        tile.column, tile.row, tile.depth);
    boolean possible = true;
    double displacement = 0;
    for (int i = first; i < end; i++) {
      displacement = error[i] > displacement ? error[i] : displacement;
      possible &= tile.depth[i] > TileGrid.NARROW * distance[i] & error[i] < APART * distance[i];
    }
    grid.displacement = displacement;
    return possible && takePyramid();
  }

  /** The axis need not be exactly the middle, so a few directions are enough. */
  private void takeMeanDirection() {
    double x = 0, y = 0, z = 0;
    for (int k = 0; k < SAMPLES; k++) {
      final int i = first + (end - 1 - first) * k / (SAMPLES - 1);
      x -= tile.directionX[i];
      y -= tile.directionY[i];
      z -= tile.directionZ[i];
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

  /**
   * Finds the slopes of the segments from the light on and their depths; the arrays are parameters so that the compiler
   * vectorises the loop.
   */
  private void project(final double[] startX, final double[] startY, final double[] startZ, final double[] directionX,
      final double[] directionY, final double[] directionZ, final double[] u, final double[] v, final double[] depth) {
    final double ox = grid.originX, oy = grid.originY, oz = grid.originZ;
    final double ax = grid.axisX, ay = grid.axisY, az = grid.axisZ;
    final double px = ux, py = uy, pz = uz, qx = vx, qy = vy, qz = vz;
    final double[] off = error, away = distance;
    for (int i = first; i < end; i++) {
      final double x = startX[i] - ox, y = startY[i] - oy, z = startZ[i] - oz, d = Math.sqrt(x * x + y * y + z * z);
      final double ex = x + d * directionX[i], ey = y + d * directionY[i], ez = z + d * directionZ[i];
      final double ahead = x * ax + y * ay + z * az;
      off[i] = Math.sqrt(ex * ex + ey * ey + ez * ez) + ROUNDING * d;
      away[i] = d;
      depth[i] = ahead;
      u[i] = (x * px + y * py + z * pz) / ahead;
      v[i] = (x * qx + y * qy + z * qz) / ahead;
    }
  }

  private boolean takePyramid() {
    findExtents();
    final double k = LAST / Math.max(LEAST_EXTENT, mostU - leastU), l = LAST / Math.max(LEAST_EXTENT, mostV - leastV);
    final double x = grid.axisX, y = grid.axisY, z = grid.axisZ;
    grid.setColumn(k * (ux - leastU * x), k * (uy - leastU * y), k * (uz - leastU * z), 0);
    grid.setRow(l * (vx - leastV * x), l * (vy - leastV * y), l * (vz - leastV * z), 0);
    grid.setDepth(x, y, z, 0);
    final double steepest = 1 + Math.max(Math.max(-leastU, mostU), Math.max(-leastV, mostV));
    grid.columnMargin = k * steepest / TileFrustum.STRAIGHT;
    grid.rowMargin = l * steepest / TileFrustum.STRAIGHT;
    scale(tile.column, leastU, k);
    scale(tile.row, leastV, l);
    return true;
  }

  private boolean fitPrism() {
    grid.setOrigin(tile.startX[first], tile.startY[first], tile.startZ[first]);
    grid.setAxis(tile.directionX[first], tile.directionY[first], tile.directionZ[first]);
    takePerpendiculars();
    double farthest = 0;
    for (int i = first; i < end; i++) {
      final double x = tile.startX[i] - grid.originX, y = tile.startY[i] - grid.originY, z = tile.startZ[i] - grid.originZ;
      final double ahead = x * grid.axisX + y * grid.axisY + z * grid.axisZ;
      grid.ahead = Math.max(grid.ahead, ahead);
      grid.behind = Math.max(grid.behind, -ahead);
      farthest = Math.max(farthest, Math.abs(x) + Math.abs(y) + Math.abs(z) + tile.length[i]);
      tile.column[i] = x * ux + y * uy + z * uz;
      tile.row[i] = x * vx + y * vy + z * vz;
      tile.depth[i] = ahead + tile.length[i];
    }
    grid.displacement = (bend + ROUNDING) * farthest;
    findExtents();
    return takePrism(LEAST_EXTENT * farthest);
  }

  private boolean takePrism(final double least) {
    final double k = LAST / Math.max(least, mostU - leastU), l = LAST / Math.max(least, mostV - leastV);
    grid.setColumn(k * ux, k * uy, k * uz, -k * leastU);
    grid.setRow(l * vx, l * vy, l * vz, -l * leastV);
    grid.setDepth(0, 0, 0, 1);
    grid.columnMargin = k * grid.displacement;
    grid.rowMargin = l * grid.displacement;
    scale(tile.column, leastU, k);
    scale(tile.row, leastV, l);
    return k < Double.POSITIVE_INFINITY && l < Double.POSITIVE_INFINITY;
  }

  private void findExtents() {
    leastU = Double.POSITIVE_INFINITY;
    mostU = Double.NEGATIVE_INFINITY;
    leastV = Double.POSITIVE_INFINITY;
    mostV = Double.NEGATIVE_INFINITY;
    for (int i = first; i < end; i++) {
      final double u = tile.column[i], v = tile.row[i];
      leastU = u < leastU ? u : leastU;
      mostU = u > mostU ? u : mostU;
      leastV = v < leastV ? v : leastV;
      mostV = v > mostV ? v : mostV;
    }
  }

  /** Turns slopes or offsets into places in the raster. */
  private void scale(final double[] places, final double least, final double k) {
    for (int i = first; i < end; i++) {
      places[i] = k * (places[i] - least);
    }
  }
}
