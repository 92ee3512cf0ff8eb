package acceleration;

/**
 * Which rays of a pyramid may lie on the inner side of three planes through their common start, such as those of a
 * triangle's edges. Along the columns and rows of the tile the distance from a plane is an affine function of the pixel,
 * so that it takes one addition a pixel, and no look at the rays themselves; what {@link TileGrid} knows of how far they
 * stray from the grid, and of rounding, is added to it. So the result is conservative: a ray left out has a distance
 * that is negative beyond doubt. Source of the stepping: Pineda, "A Parallel Algorithm for Polygon Rasterization",
 * SIGGRAPH 1988.
 *
 * <p>The window is looked at some rows at a time, as many as fit into the bits of a number: bit k is for column k %
 * width and row k / width, from the window's first column and the first of these rows on.
 */
public final class TileCoverage {

  private final TileGrid grid;
  private final TileWindow window;

  /** Distances of the next row's first ray, with what they may be wrong by added, and what columns and rows add to them. */
  private double e;
  private double f;
  private double g;
  private double eRight;
  private double fRight;
  private double gRight;
  private double eUp;
  private double fUp;
  private double gUp;
  private int width;

  TileCoverage(final TileGrid grid, final TileWindow window) {
    this.grid = grid;
    this.window = window;
  }

  /**
   * Begins with the lowest row of the window. The planes are given by their inner normals.
   *
   * @param ex first component of the first normal
   * @param ey second component of the first normal
   * @param ez third component of the first normal
   * @param fx first component of the second normal
   * @param fy second component of the second normal
   * @param fz third component of the second normal
   * @param gx first component of the third normal
   * @param gy second component of the third normal
   * @param gz third component of the third normal
   * @param error what the product of a normal and a ray's unit direction may be below 0 and still count as inside
   */
  public void begin(final double ex, final double ey, final double ez, final double fx, final double fy, final double fz,
      final double gx, final double gy, final double gz, final double error) {
    final TileGrid t = grid;
    final int column = window.firstColumn(), row = window.firstRow();
    final double x = t.cornerX + column * t.acrossX + row * t.upX, y = t.cornerY + column * t.acrossY + row * t.upY,
        z = t.cornerZ + column * t.acrossZ + row * t.upZ, doubt = error * t.longest;
    e = ex * x + ey * y + ez * z + (doubt + t.stray(ex, ey, ez));
    f = fx * x + fy * y + fz * z + (doubt + t.stray(fx, fy, fz));
    g = gx * x + gy * y + gz * z + (doubt + t.stray(gx, gy, gz));
    eRight = t.across(ex, ey, ez);
    fRight = t.across(fx, fy, fz);
    gRight = t.across(gx, gy, gz);
    eUp = t.up(ex, ey, ez);
    fUp = t.up(fx, fy, fz);
    gUp = t.up(gx, gy, gz);
    width = window.lastColumn() - column + 1;
  }

  /**
   * Looks at the next rows.
   *
   * @param rows how many, such that their pixels are no more than 64
   * @return the rays that may lie inside, as bits
   */
  public long next(final int rows) {
    long mask = 0;
    for (int row = 0; row < rows; row += 2) {
      mask |= pair(1L << width, row + 1 < rows ? width : 64, e, f, g) << row * width;
      e += 2 * eUp;
      f += 2 * fUp;
      g += 2 * gUp;
    }
    return mask;
  }

  /** Two rows. */
  private long pair(final long end, final int shift, final double atE, final double atF, final double atG) {
    final double eStep = eRight, fStep = fRight, gStep = gRight;
    double x = atE, y = atF, z = atG, above = x + eUp, yAbove = y + fUp, zAbove = z + gUp;
    long lower = 0, upper = 0;
    for (long bit = 1; bit != end; bit <<= 1) { // not counted by additions: the compiler would put loops before and after it
      lower |= bit & ~(bits(x) | bits(y) | bits(z)) >> 63;
      upper |= bit & ~(bits(above) | bits(yAbove) | bits(zAbove)) >> 63;
      x += eStep;
      y += fStep;
      z += gStep;
      above += eStep;
      yAbove += fStep;
      zAbove += gStep;
    }
    return shift < 64 ? lower | upper << shift : lower;
  }

  private static long bits(final double x) {
    return Double.doubleToRawLongBits(x);
  }
}
