package acceleration;

/**
 * A side of a {@link TileFrustum}: the points with n·V + c ≥ 0 are inside, V being relative to the frustum's origin.
 * Boxes are tested in floats, with c increased so that rounding culls none.
 */
final class SidePlane {

  /** Bound of what rounding to floats can do to n·V + c, relative to the sum of |n| |V|: six roundings of 2^-24 each. */
  static final double ROUNDING = 0x1p-21;

  private double x;
  private double y;
  private double z;
  private double c;
  private float floatX;
  private float floatY;
  private float floatZ;
  private float loose;

  /** Which of the six numbers of a box are farthest along n. */
  private int farX;
  private int farY;
  private int farZ;

  void set(final double nx, final double ny, final double nz, final double at) {
    x = nx;
    y = ny;
    z = nz;
    c = at;
    floatX = (float) nx;
    floatY = (float) ny;
    floatZ = (float) nz;
    farX = nx > 0 ? 3 : 0;
    farY = ny > 0 ? 4 : 1;
    farZ = nz > 0 ? 5 : 2;
  }

  /** Allows for the rounding of coordinates, seen from the origin, up to the given ones; returns what they can add up to. */
  double loosen(final double mostX, final double mostY, final double mostZ) {
    final double most = Math.abs(x) * mostX + Math.abs(y) * mostY + Math.abs(z) * mostZ + Math.abs(c);
    loose = Math.nextUp((float) (c + ROUNDING * most));
    return most;
  }

  /** A negative number if all of a box lies outside. */
  int sign(final float[] boxes, final int at, final float originX, final float originY, final float originZ) {
    return Float.floatToRawIntBits((boxes[at + farX] - originX) * floatX + (boxes[at + farY] - originY) * floatY
        + (boxes[at + farZ] - originZ) * floatZ + loose);
  }
}
