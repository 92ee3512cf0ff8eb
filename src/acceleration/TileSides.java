package acceleration;

/**
 * The four side planes of a {@link TileFrustum} and the extent of its rays along the axis, in floats, to cull the boxes
 * of a tree. It is prepared for boxes within a given one, whose numbers bound what rounding to floats can do to theirs.
 */
final class TileSides {

  /** Sums below this cannot overflow a float. */
  private static final double HUGE = 1e37;

  private final SidePlane left = new SidePlane();
  private final SidePlane right = new SidePlane();
  private final SidePlane below = new SidePlane();
  private final SidePlane above = new SidePlane();

  private double originX;
  private double originY;
  private double originZ;
  private double mostAhead;
  private double mostBehind;
  private float floatX;
  private float floatY;
  private float floatZ;
  private float axisX;
  private float axisY;
  private float axisZ;
  private float nearLoose;
  private float farLoose;
  private int nearX;
  private int nearY;
  private int nearZ;

  /** The box last prepared for; null if there was none yet. */
  private float[] prepared;
  private double greatest;
  private double extent;

  /** Sets the sides to those of a grid of columns and rows, whose rays stray by no more than the two margins. */
  void enclose(final TileGrid g, final int columns, final int rows, final double columnMargin, final double rowMargin) {
    prepared = null;
    originX = g.originX;
    originY = g.originY;
    originZ = g.originZ;
    floatX = (float) g.originX;
    floatY = (float) g.originY;
    floatZ = (float) g.originZ;
    axisX = (float) g.axisX;
    axisY = (float) g.axisY;
    axisZ = (float) g.axisZ;
    nearX = g.axisX > 0 ? 0 : 3;
    nearY = g.axisY > 0 ? 1 : 4;
    nearZ = g.axisZ > 0 ? 2 : 5;
    mostAhead = g.ahead;
    mostBehind = g.behind + g.displacement;
    final double lastC = columns - 1 + columnMargin, lastR = rows - 1 + rowMargin;
    set(left, g, columnMargin, g.columnX, g.columnY, g.columnZ, g.columnAt);
    set(right, g, lastC, -g.columnX, -g.columnY, -g.columnZ, -g.columnAt);
    set(below, g, rowMargin, g.rowX, g.rowY, g.rowZ, g.rowAt);
    set(above, g, lastR, -g.rowX, -g.rowY, -g.rowZ, -g.rowAt);
  }

  /** The side (x, y, z, at) + k D, moved outwards so that lines that miss the origin by the displacement stay inside too. */
  private static void set(final SidePlane side, final TileGrid g, final double k,
      final double x, final double y, final double z, final double at) {
    final double nx = x + k * g.depthX, ny = y + k * g.depthY, nz = z + k * g.depthZ;
    side.set(nx, ny, nz, at + k * g.depthAt + g.displacement * Math.sqrt(nx * nx + ny * ny + nz * nz));
  }

  /**
   * Prepares for boxes that lie within a box.
   *
   * @return false if floats could overflow, so that no box may be tested
   */
  boolean prepare(final float[] whole) {
    prepared = whole;
    final double x = most(whole[0], whole[3], originX), y = most(whole[1], whole[4], originY);
    final double z = most(whole[2], whole[5], originZ);
    greatest = Math.max(Math.max(left.loosen(x, y, z), right.loosen(x, y, z)),
        Math.max(below.loosen(x, y, z), above.loosen(x, y, z)));
    extent = x + y + z;
    nearLoose = (float) (-mostAhead - SidePlane.ROUNDING * (x + y + z + mostAhead));
    farLoose = (float) (mostBehind + SidePlane.ROUNDING * (x + y + z + mostBehind));
    return greatest < HUGE && x + y + z + mostAhead + mostBehind < HUGE;
  }

  /** Greatest distance of an interval's points from an origin, and twice what the origin's own rounding adds to it. */
  private static double most(final float from, final float to, final double origin) {
    return Math.max(Math.abs(from - origin), Math.abs(to - origin))
        + 2 * Math.abs(origin - (float) origin) / SidePlane.ROUNDING;
  }

  /** The box last prepared for; null if there was none. */
  float[] prepared() {
    return prepared;
  }

  /** What n·V + c of a side can add up to for a point V of the box last prepared for. */
  double greatest() {
    return greatest;
  }

  /** Sum of the greatest coordinates of a point of the box last prepared for, seen from the origin. */
  double extent() {
    return extent;
  }

  /** A distance before which no ray of the tile can be within a box; the box is the one at a place of an array. */
  float nearest(final float[] boxes, final int at) {
    return (boxes[at + nearX] - floatX) * axisX + (boxes[at + nearY] - floatY) * axisY
        + (boxes[at + nearZ] - floatZ) * axisZ + nearLoose;
  }

  /**
   * Whether no ray of the tile can be within a box. The signs of all five sides are gathered without a branch, which
   * would be mispredicted too often.
   */
  boolean isOutside(final float[] boxes, final int at) {
    final float x = floatX, y = floatY, z = floatZ;
    final float far = (boxes[at + 3 - nearX] - x) * axisX + (boxes[at + 5 - nearY] - y) * axisY
        + (boxes[at + 7 - nearZ] - z) * axisZ + farLoose;
    return (Float.floatToRawIntBits(far) | left.sign(boxes, at, x, y, z) | right.sign(boxes, at, x, y, z)
        | below.sign(boxes, at, x, y, z) | above.sign(boxes, at, x, y, z)) < 0;
  }
}
