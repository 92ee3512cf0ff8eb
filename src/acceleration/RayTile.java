package acceleration;

import java.util.Arrays;

import primitives.BoundingBox;

/**
 * The rays of a rectangle of pixels, at most {@link #SIZE} × {@link #SIZE} of them, as plain numbers: a ray generator
 * fills it, and objects are tested against all of it at once. A pixel without a ray (a corner of a fish-eye picture) has
 * NaN for direction, which no comparison accepts.
 *
 * <p>Ray i belongs to column {@code i % SIZE} and row {@code i / SIZE} of the tile. Directions are kept twice: as the
 * floats of a {@code tracer.Ray}, and normalised in double for computations.
 *
 * <p>A tile also has a <em>window</em>, the columns and rows that may hit the current object ({@link #narrowTo}): code
 * that tests an object ray by ray loops over the window only. Not safe for use by several threads: each has its own.
 */
public final class RayTile extends TileRays {

  /** Greatest number of columns and of rows. */
  public static final int SIZE = 32;

  /** How the rays were put in, and so what {@link #close()} has to do. */
  private enum Kind { NONE, RAW, UNIT, EXACT, PENCIL }

  private final double[] vx = new double[SIZE * SIZE];
  private final double[] vy = new double[SIZE * SIZE];
  private final double[] vz = new double[SIZE * SIZE];

  /** For the rays of a pencil, the a and b of each; see {@link Pencil}. */
  private final double[] a = new double[SIZE * SIZE];
  private final double[] b = new double[SIZE * SIZE];
  private Pencil pencil;

  /** The pencil whose start all pixels have at present; null if there is no such pencil. */
  private Pencil started;

  private Kind kind = Kind.NONE;

  /** Whether every pixel is known to have a ray. */
  private boolean complete;
  private int columns;
  private int rows;

  /** An empty tile. */
  public RayTile() {
    super(SIZE * SIZE);
  }

  /**
   * Removes all rays and sets the size. To fill a tile, call this first, then one of the three methods that put a ray in,
   * the same for all pixels, or {@link #fill}, and {@link #close()} last.
   *
   * @param width number of columns, 1 … {@link #SIZE}
   * @param height number of rows, 1 … {@link #SIZE}
   */
  public void open(final int width, final int height) {
    columns = width;
    rows = height;
    kind = Kind.NONE;
  }

  private void begin(final Kind filling) {
    if (kind == Kind.NONE) {
      Arrays.fill(vx, Double.NaN);
      Arrays.fill(directionX, Double.NaN);
      started = null;
    }
    kind = filling;
  }

  /**
   * Puts a ray into a pixel, with a direction of any length: it is rounded to floats as {@code tracer.Ray.towards} does.
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
    begin(Kind.RAW);
    putStart(i, x, y, z);
    putDirection(i, dx, dy, dz);
  }

  /**
   * Puts a ray into a pixel, whose direction is a unit vector of floats already.
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
    begin(Kind.UNIT);
    putStart(i, x, y, z);
    putDirection(i, dx, dy, dz);
  }

  /**
   * Puts a ray into a pixel without rounding its numbers, as {@code tracer.Ray.exactly} does.
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
    begin(Kind.EXACT);
    putStart(i, x, y, z);
    putDirection(i, dx, dy, dz);
    putUnitDirection(i, dx, dy, dz);
  }

  /**
   * Fills the tile with rays of a pencil, rounded as those of {@link #put} are.
   *
   * @param rays the pencil
   * @param columnCentres the a of each column of an image
   * @param m the image's column that is the tile's first
   * @param rowCentres the b of each row of an image
   * @param n the image's row that is the tile's first
   */
  public void fill(final Pencil rays, final double[] columnCentres, final int m, final double[] rowCentres, final int n) {
    kind = Kind.PENCIL;
    pencil = rays;
    for (int row = 0; row < rows; row++) {
      final int first = row * SIZE;
      System.arraycopy(columnCentres, m, a, first, columns);
      Arrays.fill(a, first + columns, first + SIZE, Double.NaN);
      Arrays.fill(b, first, first + SIZE, rowCentres[n + row]);
    }
    rays.directions(SIZE * rows, a, b, vx, vy, vz);
    if (started != rays) {
      Arrays.fill(startX, rays.startX);
      Arrays.fill(startY, rays.startY);
      Arrays.fill(startZ, rays.startZ);
      started = rays;
    }
  }

  private void putDirection(final int i, final double dx, final double dy, final double dz) {
    vx[i] = dx;
    vy[i] = dy;
    vz[i] = dz;
  }

  /** Ends the filling: rounds what has to be rounded, and finds the frustum about the rays. */
  public void close() {
    begin(kind == Kind.NONE ? Kind.UNIT : kind);
    final int n = SIZE * rows;
    complete = kind == Kind.PENCIL && columns == SIZE;
    if (kind == Kind.RAW) {
      RayRounding.roundStarts(n, startX);
      RayRounding.roundStarts(n, startY);
      RayRounding.roundStarts(n, startZ);
    }
    if (kind == Kind.RAW || kind == Kind.PENCIL) {
      RayRounding.roundDirections(n, vx, vy, vz);
    }
    if (kind != Kind.EXACT) {
      RayRounding.bringToUnit(n, vx, vy, vz, directionX, directionY, directionZ);
    }
    if (kind == Kind.PENCIL) {
      frustum().fit(this, pencil, a, b);
    } else {
      frustum().fit(this);
    }
  }

  /**
   * Removes a ray from a closed tile, as if the pixel had none. The frustum still encloses it.
   *
   * @param i number of the pixel, column + SIZE · row
   */
  public void remove(final int i) {
    vx[i] = Double.NaN;
    directionX[i] = Double.NaN;
    complete = false;
  }

  /** Sets the window to the whole tile. */
  public void reset() {
    frustum().window().all();
  }

  /**
   * Sets the window to the pixels whose rays may hit a box: no ray outside it does.
   *
   * @param box the box, perhaps unbounded
   * @return whether any pixel is left
   */
  public boolean narrowTo(final BoundingBox box) {
    if (!frustum().isFitted() || !box.isFinite()) {
      reset();
      return true;
    }
    return frustum().project(box);
  }

  /**
   * The columns and rows that may hit the current object.
   *
   * @return the window, which each projection of the frustum changes
   */
  public TileWindow window() {
    return frustum().window();
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
   * First component of the direction of a ray, as a float.
   *
   * @param i number of the pixel, column + SIZE · row
   * @return the number
   */
  public float vx(final int i) {
    return (float) vx[i];
  }

  /**
   * Second component of the direction of a ray, as a float.
   *
   * @param i number of the pixel, column + SIZE · row
   * @return the number
   */
  public float vy(final int i) {
    return (float) vy[i];
  }

  /**
   * Third component of the direction of a ray, as a float.
   *
   * @param i number of the pixel, column + SIZE · row
   * @return the number
   */
  public float vz(final int i) {
    return (float) vz[i];
  }

  /**
   * Whether all pixels of all columns up to {@link #SIZE} are known to have rays.
   *
   * @return false if some have none, or if that is not known
   */
  public boolean isComplete() {
    return complete;
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
}
