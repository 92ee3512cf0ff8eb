package acceleration;

/**
 * A rectangle of a tile's columns and rows: the extent of the last projection of a {@link TileFrustum}. It is kept in
 * whole pixels, and with its margin between pixels.
 */
public final class TileWindow {

  /** Added before truncation to round up; numbers just above an integer are rounded down to it, which is harmless. */
  private static final double UP = 1 - 1e-9;

  private int columns;
  private int rows;

  /** Whether rays may lie between columns and rows. */
  private boolean between;
  private double leastColumn;
  private double mostColumn;
  private double leastRow;
  private double mostRow;
  private int firstColumn;
  private int lastColumn;
  private int firstRow;
  private int lastRow;

  TileWindow() {
  }

  /** The whole of a tile of some columns and rows. */
  void open(final int itsColumns, final int itsRows, final boolean itsRaysLieBetween) {
    columns = itsColumns;
    rows = itsRows;
    between = itsRaysLieBetween;
    all();
  }

  /** Sets the window to the whole tile; returns true. */
  boolean all() {
    leastColumn = -1;
    mostColumn = columns;
    leastRow = -1;
    mostRow = rows;
    firstColumn = 0;
    lastColumn = columns - 1;
    firstRow = 0;
    lastRow = rows - 1;
    return true;
  }

  /** Limits the window to what lies between two columns and two rows; returns whether any ray may lie there. */
  boolean limit(final double left, final double right, final double bottom, final double top) {
    leastColumn = left;
    mostColumn = right;
    leastRow = bottom;
    mostRow = top;
    if (right < 0 || left > columns - 1 || top < 0 || bottom > rows - 1) {
      return false;
    }
    firstColumn = (int) Math.max(0, left + UP);
    lastColumn = (int) Math.min(columns - 1, right);
    firstRow = (int) Math.max(0, bottom + UP);
    lastRow = (int) Math.min(rows - 1, top);
    return between || firstColumn <= lastColumn && firstRow <= lastRow;
  }

  double leastColumn() {
    return leastColumn;
  }

  double mostColumn() {
    return mostColumn;
  }

  double leastRow() {
    return leastRow;
  }

  double mostRow() {
    return mostRow;
  }

  /**
   * First column.
   *
   * @return the number, from 0
   */
  public int firstColumn() {
    return firstColumn;
  }

  /**
   * Last column.
   *
   * @return the number, from 0
   */
  public int lastColumn() {
    return lastColumn;
  }

  /**
   * First row.
   *
   * @return the number, from 0
   */
  public int firstRow() {
    return firstRow;
  }

  /**
   * Last row.
   *
   * @return the number, from 0
   */
  public int lastRow() {
    return lastRow;
  }
}
