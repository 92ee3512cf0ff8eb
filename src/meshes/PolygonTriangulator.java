package meshes;

/**
 * Cuts a polygon into triangles by its ears: an ear is a convex corner whose triangle with its two neighbours contains no
 * other corner; a simple polygon always has one (Meisters, "Polygons have ears", American Mathematical Monthly 82, 1975).
 * The search starts at the second corner and goes on with the corner after the last ear, so that a convex polygon becomes
 * the fan of its first corner.
 *
 * <p>The polygon need not be planar: it is cut by its projection onto the plane of its vector area, given by Newell's
 * formula (Tampieri, "Newell's method for computing the plane equation of a polygon", Graphics Gems III, 1992). A
 * self-intersecting polygon has no triangulation and becomes the fan of its first corner. Not safe for use by several
 * threads.
 */
final class PolygonTriangulator {

  /** Areas up to this fraction of the squared extent of the polygon count as 0. */
  private static final double ROUNDING = 1e-14;

  /** Number of corners from which on a grid finds those near an ear. */
  private static final int MANY = 32;

  private double[] coordinates;
  /** The corners that count, in the order of the facet, and their vertices; two coincident neighbours are one corner. */
  private int[] corners = new int[16];
  private int[] vertices = new int[16];
  private int size;
  private final PlanePolygon shadow = new PlanePolygon();
  private int[] next = new int[16];
  private int[] previous = new int[16];
  private CornerGrid grid;

  private int[] triangles = new int[48];
  private int end;

  /**
   * Cuts a polygon.
   *
   * @param itsCoordinates x, y and z of the vertices
   * @param itsVertices for each corner the number of its vertex
   * @param number number of corners, at least 3
   * @return false if the polygon intersects itself and became a fan
   */
  boolean cut(final double[] itsCoordinates, final int[] itsVertices, final int number) {
    coordinates = itsCoordinates;
    end = 0;
    merge(itsVertices, number);
    if (size < 3) {
      return true;
    }
    final boolean cut = shadow.project(coordinates, vertices, size, ROUNDING) && cutEars();
    if (!cut) {
      fan();
    }
    return cut;
  }

  /** Number of triangles of the last polygon; 0 if it has fewer than three distinct corners. */
  int triangles() {
    return end / 3;
  }

  /** A corner, 0, 1 or 2, of a triangle, as its number within the facet. */
  int corner(final int triangle, final int which) {
    return triangles[3 * triangle + which];
  }

  private void merge(final int[] itsVertices, final int number) {
    if (corners.length < number) {
      corners = new int[2 * number];
      vertices = new int[2 * number];
      next = new int[2 * number];
      previous = new int[2 * number];
      triangles = new int[6 * number];
    }
    size = 0;
    for (int k = 0; k < number; k++) {
      if (size == 0 || !samePlace(vertices[size - 1], itsVertices[k])) {
        corners[size] = k;
        vertices[size++] = itsVertices[k];
      }
    }
    while (size > 1 && samePlace(vertices[size - 1], vertices[0])) {
      size--;
    }
  }

  private boolean samePlace(final int vertex, final int other) {
    final int p = 3 * vertex, q = 3 * other;
    return p == q || coordinates[p] == coordinates[q] && coordinates[p + 1] == coordinates[q + 1]
        && coordinates[p + 2] == coordinates[q + 2];
  }

  private boolean cutEars() {
    for (int i = 0; i < size; i++) {
      next[i] = (i + 1) % size;
      previous[i] = (i + size - 1) % size;
    }
    grid = size < MANY || shadow.isConvex() ? null : new CornerGrid(shadow, size);
    int left = size;
    int passed = 0;
    int c = 1;
    while (left > 3 && passed < left) {
      final int a = previous[c], b = next[c];
      if (isEar(a, c, b)) {
        add(a, c, b);
        remove(c);
        left--;
        passed = 0;
      } else {
        passed++;
      }
      c = b;
    }
    return left == 3 && addLast(c);
  }

  private boolean addLast(final int corner) {
    int a = corner;
    while (previous[a] < a) {
      a = previous[a];
    }
    final int b = next[a], c = next[b];
    add(a, b, c);
    return shadow.side(a, b, c) > shadow.tolerance();
  }

  private void remove(final int c) {
    next[previous[c]] = next[c];
    previous[next[c]] = previous[c];
    if (grid != null) {
      grid.remove(c);
    }
  }

  private boolean isEar(final int a, final int c, final int b) {
    if (!(shadow.side(a, c, b) > shadow.tolerance())) {
      return false;
    }
    if (grid != null) {
      return grid.isEmpty(a, c, b, p -> isElsewhere(p, a, c, b));
    }
    if (!shadow.isConvex()) {
      for (int p = next[b]; p != a; p = next[p]) {
        if (shadow.isInside(p, a, c, b) && isElsewhere(p, a, c, b)) {
          return false;
        }
      }
    }
    return true;
  }

  private boolean isElsewhere(final int p, final int a, final int c, final int b) {
    final int vertex = vertices[p];
    return !samePlace(vertex, vertices[a]) && !samePlace(vertex, vertices[b]) && !samePlace(vertex, vertices[c]);
  }

  private void add(final int a, final int b, final int c) {
    triangles[end++] = corners[a];
    triangles[end++] = corners[b];
    triangles[end++] = corners[c];
  }

  private void fan() {
    end = 0;
    for (int i = 2; i < size; i++) {
      add(0, i - 1, i);
    }
  }
}
