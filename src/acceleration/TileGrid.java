package acceleration;

/**
 * The projection of space onto the pixels of a tile: with V = P − O, column = (C·V + c) / (D·V + d), and the same for the
 * row. {@link GridFit} measures it from any rays, {@link PencilGrid} derives it for rays that the tile itself has made. The
 * rays stray from it by at most the two margins.
 */
final class TileGrid {

  /** Least cosine between a ray of a pyramid and its axis. */
  static final double NARROW = 0.25;

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

  void setDepth(final double x, final double y, final double z, final double at) {
    depthX = x;
    depthY = y;
    depthZ = z;
    depthAt = at;
  }
}
