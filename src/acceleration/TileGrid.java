package acceleration;

/**
 * The projection of space onto the pixels of a tile: with V = P − O, column = (C·V + c) / (D·V + d), and the same for the
 * row. {@link GridFit} measures it from any rays, {@link PencilGrid} derives it for rays that the tile itself has made. The
 * rays stray from it by at most the two margins.
 */
final class TileGrid {

  /** Least cosine between a ray of a pyramid and its axis. */
  static final double NARROW = 0.25;

  /**
   * Bound of the rounding of double in a product with corner and steps, relative to the greatest terms: the product itself,
   * 32 + 32 steps whose lengths are wrong by four roundings each, and as many sums; fewer than 400 of 2^-53.
   */
  private static final double STEPPING = 0x1p-44;

  /** Whether all rays have one start; if not, they have one direction. */
  boolean pyramid;
  double originX;
  double originY;
  double originZ;

  /** The mean direction of the rays, of unit length. */
  double axisX;
  double axisY;
  double axisZ;

  double columnX;
  double columnY;
  double columnZ;
  double columnAt;
  double rowX;
  double rowY;
  double rowZ;
  double rowAt;
  double depthX;
  double depthY;
  double depthZ;
  double depthAt;

  /** Greatest distances of a ray from its own column and row, in pixels. */
  double columnMargin;
  double rowMargin;

  /** For a pyramid, the direction of the pixel (0, 0), what it changes by from column to column, and from row to row. */
  double cornerX;
  double cornerY;
  double cornerZ;
  double acrossX;
  double acrossY;
  double acrossZ;
  double upX;
  double upY;
  double upZ;

  /** How far, at most, each component of some multiple of a ray's direction is from what the three above make of it. */
  private double strayX;
  private double strayY;
  private double strayZ;

  /** Greatest length of these multiples. */
  double longest;

  /** How far before and behind the origin, along the axis, rays start. */
  double ahead;
  double behind;

  /** Greatest distance of a ray's line from the origin of a pyramid; 0 if they all start there. */
  double displacement;

  void setOrigin(final double x, final double y, final double z) {
    originX = x;
    originY = y;
    originZ = z;
    ahead = 0;
    behind = 0;
    displacement = 0;
  }

  /** Takes any vector along the axis. */
  void setAxis(final double x, final double y, final double z) {
    final double length = Math.sqrt(x * x + y * y + z * z);
    axisX = x / length;
    axisY = y / length;
    axisZ = z / length;
  }

  void setColumn(final double x, final double y, final double z, final double at) {
    columnX = x;
    columnY = y;
    columnZ = z;
    columnAt = at;
  }

  void setRow(final double x, final double y, final double z, final double at) {
    rowX = x;
    rowY = y;
    rowZ = z;
    rowAt = at;
  }

  void setCorner(final double x, final double y, final double z) {
    cornerX = x;
    cornerY = y;
    cornerZ = z;
  }

  void setAcross(final double x, final double y, final double z) {
    acrossX = x;
    acrossY = y;
    acrossZ = z;
  }

  void setUp(final double x, final double y, final double z) {
    upX = x;
    upY = y;
    upZ = z;
  }

  /** Takes how far components stray; adds what it takes to evaluate a product with a direction step by step. */
  void setStray(final double x, final double y, final double z) {
    final double mostX = Math.abs(cornerX) + RayTile.SIZE * (Math.abs(acrossX) + Math.abs(upX));
    final double mostY = Math.abs(cornerY) + RayTile.SIZE * (Math.abs(acrossY) + Math.abs(upY));
    final double mostZ = Math.abs(cornerZ) + RayTile.SIZE * (Math.abs(acrossZ) + Math.abs(upZ));
    strayX = x + STEPPING * mostX;
    strayY = y + STEPPING * mostY;
    strayZ = z + STEPPING * mostZ;
    longest = mostX + strayX + mostY + strayY + mostZ + strayZ;
  }

  /** What a product with n changes by from column to column. */
  double across(final double nx, final double ny, final double nz) {
    return nx * acrossX + ny * acrossY + nz * acrossZ;
  }

  /** What a product with n changes by from row to row. */
  double up(final double nx, final double ny, final double nz) {
    return nx * upX + ny * upY + nz * upZ;
  }

  /** How far the product of n with a ray can be from what corner and steps make of it. */
  double stray(final double nx, final double ny, final double nz) {
    return Math.abs(nx) * strayX + Math.abs(ny) * strayY + Math.abs(nz) * strayZ;
  }

  void setDepth(final double x, final double y, final double z, final double at) {
    depthX = x;
    depthY = y;
    depthZ = z;
    depthAt = at;
  }
}
