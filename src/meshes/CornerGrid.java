package meshes;

import java.util.Arrays;
import java.util.function.IntPredicate;

/**
 * The corners of a large polygon in the cells of a grid over its plane, so that those in an ear are found without testing
 * all of them. An ear is looked up row by row in the cells that it overlaps: a long thin one overlaps few.
 */
final class CornerGrid {

  private static final int NONE = -1;

  private final PlanePolygon polygon;
  private final int cells;
  private final double minX;
  private final double minY;
  private final double cellX;
  private final double cellY;
  private final int[] first;
  private final int[] next;

  /** The range of cells of a row that the current ear overlaps. */
  private double low;
  private double high;

  CornerGrid(final PlanePolygon polygon, final int size) {
    this.polygon = polygon;
    this.cells = (int) Math.ceil(Math.sqrt(size));
    double left = polygon.x(0), right = left, bottom = polygon.y(0), top = bottom;
    for (int i = 1; i < size; i++) {
      left = Math.min(left, polygon.x(i));
      right = Math.max(right, polygon.x(i));
      bottom = Math.min(bottom, polygon.y(i));
      top = Math.max(top, polygon.y(i));
    }
    minX = left;
    minY = bottom;
    cellX = (right - left) / cells;
    cellY = (top - bottom) / cells;
    first = new int[cells * cells];
    next = new int[size];
    Arrays.fill(first, NONE);
    for (int i = 0; i < size; i++) {
      final int cell = cellOf(i);
      next[i] = first[cell];
      first[cell] = i;
    }
  }

  private int cellOf(final int i) {
    return row(polygon.y(i)) * cells + column(polygon.x(i));
  }

  private int row(final double y) {
    return Math.max(0, Math.min(cells - 1, (int) ((y - minY) / cellY)));
  }

  private int column(final double x) {
    return Math.max(0, Math.min(cells - 1, (int) ((x - minX) / cellX)));
  }

  /** Removes a corner. */
  void remove(final int corner) {
    final int cell = cellOf(corner);
    if (first[cell] == corner) {
      first[cell] = next[corner];
      return;
    }
    int before = first[cell];
    while (next[before] != corner) {
      before = next[before];
    }
    next[before] = next[corner];
  }

  /**
   * Whether no corner lies in a triangle of positive area, its edges included.
   *
   * @param counts whether a corner counts; the three of the triangle must not
   */
  boolean isEmpty(final int a, final int b, final int c, final IntPredicate counts) {
    final double margin = margin(a, b, c);
    final int top = row(Math.max(polygon.y(a), Math.max(polygon.y(b), polygon.y(c))) + margin);
    for (int row = row(Math.min(polygon.y(a), Math.min(polygon.y(b), polygon.y(c))) - margin); row <= top; row++) {
      final double from = minY + row * cellY - margin, to = minY + (row + 1) * cellY + margin;
      low = Double.POSITIVE_INFINITY;
      high = Double.NEGATIVE_INFINITY;
      clip(a, b, from, to);
      clip(b, c, from, to);
      clip(c, a, from, to);
      for (int cell = row * cells + column(low - margin); cell <= row * cells + column(high + margin); cell++) {
        for (int p = first[cell]; p != NONE; p = next[p]) {
          if (polygon.isInside(p, a, b, c) && counts.test(p)) {
            return false;
          }
        }
      }
    }
    return true;
  }

  /**
   * How far from the triangle a corner can lie that counts as inside by the tolerance of areas: its barycentric
   * coordinates are at least −tolerance / area. The rounding of row positions is added.
   */
  private double margin(final int a, final int b, final int c) {
    final double width = Math.abs(polygon.x(b) - polygon.x(a)) + Math.abs(polygon.x(c) - polygon.x(a)),
        height = Math.abs(polygon.y(b) - polygon.y(a)) + Math.abs(polygon.y(c) - polygon.y(a));
    return 6 * polygon.tolerance() / polygon.side(a, b, c) * (width + height) + 1e-12 * cells * (cellX + cellY);
  }

  /** Widens the range by the part of an edge within a row. */
  private void clip(final int p, final int q, final double from, final double to) {
    final double px = polygon.x(p), py = polygon.y(p), qx = polygon.x(q), qy = polygon.y(q);
    if (Math.max(py, qy) < from || Math.min(py, qy) > to) {
      return;
    }
    widen(py, px, from, to, qx, qy);
    widen(qy, qx, from, to, px, py);
  }

  /** Widens the range by the end of an edge, clipped to the row. */
  private void widen(final double y, final double x, final double from, final double to, final double otherX,
      final double otherY) {
    final double border = Math.max(from, Math.min(to, y));
    final double at = border == y ? x : x + (border - y) / (otherY - y) * (otherX - x);
    low = Math.min(low, at);
    high = Math.max(high, at);
  }
}
