package acceleration;

/**
 * The rays of a tile as plain numbers, an array for each coordinate of their starts and of their unit directions in double,
 * and the frustum about them. Not safe for use by several threads.
 */
public abstract class TileRays {

  final double[] startX;
  final double[] startY;
  final double[] startZ;
  final double[] directionX;
  final double[] directionY;
  final double[] directionZ;
  private final TileFrustum frustum = new TileFrustum();

  /** Storage for a number of rays. */
  TileRays(final int most) {
    startX = new double[most];
    startY = new double[most];
    startZ = new double[most];
    directionX = new double[most];
    directionY = new double[most];
    directionZ = new double[most];
  }

  final void putStart(final int i, final double x, final double y, final double z) {
    startX[i] = x;
    startY[i] = y;
    startZ[i] = z;
  }

  final void putUnitDirection(final int i, final double x, final double y, final double z) {
    directionX[i] = x;
    directionY[i] = y;
    directionZ[i] = z;
  }

  /**
   * First coordinate of the start of a ray.
   *
   * @param i number of the ray
   * @return the number
   */
  public final double startX(final int i) {
    return startX[i];
  }

  /**
   * Second coordinate of the start of a ray.
   *
   * @param i number of the ray
   * @return the number
   */
  public final double startY(final int i) {
    return startY[i];
  }

  /**
   * Third coordinate of the start of a ray.
   *
   * @param i number of the ray
   * @return the number
   */
  public final double startZ(final int i) {
    return startZ[i];
  }

  /**
   * First component of the direction of a ray.
   *
   * @param i number of the ray
   * @return the number; NaN if there is no such ray
   */
  public final double directionX(final int i) {
    return directionX[i];
  }

  /**
   * Second component of the direction of a ray.
   *
   * @param i number of the ray
   * @return the number; NaN if there is no such ray
   */
  public final double directionY(final int i) {
    return directionY[i];
  }

  /**
   * Third component of the direction of a ray.
   *
   * @param i number of the ray
   * @return the number; NaN if there is no such ray
   */
  public final double directionZ(final int i) {
    return directionZ[i];
  }

  /**
   * The frustum about the rays.
   *
   * @return the frustum, fitted anew each time that the tile is closed
   */
  public final TileFrustum frustum() {
    return frustum;
  }
}
