package acceleration;

import java.util.Arrays;

import primitives.BoundingBox;

/**
 * The rays of a rectangle of pixels, at most {@link #SIZE} × {@link #SIZE} of them, as plain numbers: what a ray
 * generator fills and objects are asked about at once. A pixel without a ray (a corner of a fish-eye picture) has
 * NaN for direction, which no comparison accepts.
 *
 * <p>Ray i belongs to column {@code i % SIZE} and row {@code i / SIZE} of the tile. Directions are kept twice: as the
 * floats of a {@code tracer.Ray}, and brought to unit length in double, which is what computations use.
 *
 * <p>A tile also has a <em>window</em>, the columns and rows that may meet the object at hand ({@link #look});
 * who asks an object's rays one by one needs to walk the window only. Not safe for use by several threads: each has
 * its own.
 */
public final class RayTile {

  /** Greatest number of columns and of rows. */
  public static final int SIZE = 16;

  private final double[] startX = new double[SIZE * SIZE];
  private final double[] startY = new double[SIZE * SIZE];
  private final double[] startZ = new double[SIZE * SIZE];
  private final double[] directionX = new double[SIZE * SIZE];
  private final double[] directionY = new double[SIZE * SIZE];
  private final double[] directionZ = new double[SIZE * SIZE];
  private final float[] vx = new float[SIZE * SIZE];
  private final float[] vy = new float[SIZE * SIZE];
  private final float[] vz = new float[SIZE * SIZE];
  private final TileFrustum frustum = new TileFrustum();

  private int columns;
  private int rows;
  private int firstColumn;
  private int lastColumn;
  private int firstRow;
  private int lastRow;

  /** An empty tile. */
  public RayTile() {
  }

  /**
   * Forgets all rays and sets the size. Whoever fills a tile calls this first and {@link #close()} last.
   *
   * @param columns number of columns, 1 … {@link #SIZE}
   * @param rows number of rows, 1 … {@link #SIZE}
   */
  public void open(final int columns, final int rows) {
    this.columns = columns;
    this.rows = rows;
    Arrays.fill(directionX, Double.NaN);
    Arrays.fill(directionY, Double.NaN);
    Arrays.fill(directionZ, Double.NaN);
  }

  /**
   * Puts a ray into a pixel, rounded as {@code tracer.Ray.towards} rounds it.
   *
   * @param i number of the pixel, column + SIZE · row
   * @param x first coordinate of the start
   * @param y second coordinate of the start
   * @param z third coordinate of the start
   * @param dx first component of the direction, of any length but 0
   * @param dy second component of the direction
   * @param dz third component of the direction
   */
  public void put(final int i, final double x, final double y, final double z,
      final double dx, final double dy, final double dz) {
    final double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
    putUnit(i, (float) x, (float) y, (float) z, (float) (dx / length), (float) (dy / length), (float) (dz / length));
  }

  /**
   * Puts a ray into a pixel whose direction is a unit vector of floats already.
   *
   * @param i number of the pixel, column + SIZE · row
   * @param x first coordinate of the start
   * @param y second coordinate of the start
   * @param z third coordinate of the start
   * @param dx first component of the direction
   * @param dy second component of the direction
   * @param dz third component of the direction
   */
  public void putUnit(final int i, final double x, final double y, final double z,
      final float dx, final float dy, final float dz) {
    final double length = Math.sqrt((double) dx * dx + (double) dy * dy + (double) dz * dz);
    putExactly(i, x, y, z, dx / length, dy / length, dz / length);
    vx[i] = dx;
    vy[i] = dy;
    vz[i] = dz;
  }

  /**
   * Puts a ray into a pixel whose numbers keep all their digits, as {@code tracer.Ray.exactly} does.
   *
   * @param i number of the pixel, column + SIZE · row
   * @param x first coordinate of the start
   * @param y second coordinate of the start
   * @param z third coordinate of the start
   * @param dx first component of the direction, of unit length in double
   * @param dy second component of the direction
   * @param dz third component of the direction
   */
  public void putExactly(final int i, final double x, final double y, final double z,
      final double dx, final double dy, final double dz) {
    startX[i] = x;
    startY[i] = y;
    startZ[i] = z;
    directionX[i] = dx;
    directionY[i] = dy;
    directionZ[i] = dz;
    vx[i] = (float) dx;
    vy[i] = (float) dy;
    vz[i] = (float) dz;
  }

  /** Ends the filling: finds the frustum about the rays. */
  public void close() {
    frustum.fit(this);
    lookEverywhere();
  }

  /** Makes the whole tile the window. */
  public void lookEverywhere() {
    firstColumn = 0;
    lastColumn = columns - 1;
    firstRow = 0;
    lastRow = rows - 1;
  }

  /**
   * Makes the pixels whose rays may cross a box the window: no ray outside it does.
   *
   * @param box the box, perhaps without end
   * @return whether any pixel is left
   */
  public boolean look(final BoundingBox box) {
    lookEverywhere();
    return !frustum.isFitted() || !box.isFinite() || look(frustum, box);
  }

  private boolean look(final TileFrustum f, final BoundingBox box) {
    f.project(box);
    firstColumn = Math.max(firstColumn, f.firstColumn());
    lastColumn = Math.min(lastColumn, f.lastColumn());
    firstRow = Math.max(firstRow, f.firstRow());
    lastRow = Math.min(lastRow, f.lastRow());
    return firstColumn <= lastColumn && firstRow <= lastRow;
  }

  /**
   * Number of columns.
   *
   * @return the number, at most SIZE
   */
  public int columns() {
    return columns;
  }

  /**
   * Number of rows.
   *
   * @return the number, at most SIZE
   */
  public int rows() {
    return rows;
  }

  /**
   * First column of the window.
   *
   * @return the number, from 0
   */
  public int firstColumn() {
    return firstColumn;
  }

  /**
   * Last column of the window.
   *
   * @return the number, from 0
   */
  public int lastColumn() {
    return lastColumn;
  }

  /**
   * First row of the window.
   *
   * @return the number, from 0
   */
  public int firstRow() {
    return firstRow;
  }

  /**
   * Last row of the window.
   *
   * @return the number, from 0
   */
  public int lastRow() {
    return lastRow;
  }

  /**
   * First coordinate of the start of a ray.
   *
   * @param i number of the pixel, column + SIZE · row
   * @return the number
   */
  public double startX(final int i) {
    return startX[i];
  }

  /**
   * Second coordinate of the start of a ray.
   *
   * @param i number of the pixel, column + SIZE · row
   * @return the number
   */
  public double startY(final int i) {
    return startY[i];
  }

  /**
   * Third coordinate of the start of a ray.
   *
   * @param i number of the pixel, column + SIZE · row
   * @return the number
   */
  public double startZ(final int i) {
    return startZ[i];
  }

  /**
   * First component of the direction of a ray.
   *
   * @param i number of the pixel, column + SIZE · row
   * @return the number; NaN if the pixel has no ray
   */
  public double directionX(final int i) {
    return directionX[i];
  }

  /**
   * Second component of the direction of a ray.
   *
   * @param i number of the pixel, column + SIZE · row
   * @return the number; NaN if the pixel has no ray
   */
  public double directionY(final int i) {
    return directionY[i];
  }

  /**
   * Third component of the direction of a ray.
   *
   * @param i number of the pixel, column + SIZE · row
   * @return the number; NaN if the pixel has no ray
   */
  public double directionZ(final int i) {
    return directionZ[i];
  }

  /**
   * First component of the direction of a ray, as its floats have it.
   *
   * @param i number of the pixel, column + SIZE · row
   * @return the number
   */
  public float vx(final int i) {
    return vx[i];
  }

  /**
   * Second component of the direction of a ray, as its floats have it.
   *
   * @param i number of the pixel, column + SIZE · row
   * @return the number
   */
  public float vy(final int i) {
    return vy[i];
  }

  /**
   * Third component of the direction of a ray, as its floats have it.
   *
   * @param i number of the pixel, column + SIZE · row
   * @return the number
   */
  public float vz(final int i) {
    return vz[i];
  }

  /**
   * Whether a pixel has a ray.
   *
   * @param i number of the pixel, column + SIZE · row
   * @return false if it has none
   */
  public boolean isPresent(final int i) {
    return !Double.isNaN(directionX[i]);
  }

  /**
   * The frustum about the rays.
   *
   * @return the frustum, refitted by each {@link #close()}
   */
  public TileFrustum frustum() {
    return frustum;
  }
}
