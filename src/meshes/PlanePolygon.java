package meshes;

/** The corners of a polygon in its own plane: two numbers each, and on which side of two corners a third one lies. */
final class PlanePolygon {

  private double[] x = new double[16];
  private double[] y = new double[16];
  private double tolerance;
  private boolean convex;

  /**
   * Projects corners onto the plane of the polygon's vector area.
   *
   * @param coordinates x, y and z of the vertices
   * @param vertices for each corner the number of its vertex
   * @param size number of corners, at least 3
   * @param rounding areas up to this fraction of the squared largest extent count as 0
   * @return false if the vector area is that small, so that there is no plane
   */
  boolean project(final double[] coordinates, final int[] vertices, final int size, final double rounding) {
    final int origin = 3 * vertices[0];
    final double ox = coordinates[origin], oy = coordinates[origin + 1], oz = coordinates[origin + 2];
    final NewellVector area = new NewellVector();
    area.compute(coordinates, vertices, size);
    tolerance = rounding * area.extent() * area.extent();
    final double length = Math.sqrt(area.x() * area.x() + area.y() * area.y() + area.z() * area.z());
    if (!(length > tolerance)) {
      return false;
    }
    final double nx = area.x() / length, ny = area.y() / length, nz = area.z() / length;
    // Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017: exact where the plane is that of two axes.
    final double sign = Math.copySign(1, nz), a = -1 / (sign + nz), b = nx * ny * a;
    if (x.length < size) {
      x = new double[2 * size];
      y = new double[2 * size];
    }
    for (int i = 0; i < size; i++) {
      final int p = 3 * vertices[i];
      final double px = coordinates[p] - ox, py = coordinates[p + 1] - oy, pz = coordinates[p + 2] - oz;
      x[i] = (1 + sign * nx * nx * a) * px + sign * b * py - sign * nx * pz;
      y[i] = b * px + (sign + ny * ny * a) * py - ny * pz;
    }
    convex = isConvex(size);
    return true;
  }

  /** Whether all corners turn strictly to the left, once around in total: then no corner lies in an ear. */
  private boolean isConvex(final int size) {
    int ups = 0;
    for (int i = 0; i < size; i++) {
      final int a = (i + size - 1) % size, b = (i + 1) % size;
      if (!(side(a, i, b) > tolerance)) {
        return false;
      }
      ups += isUpwards(a, i) && !isUpwards(i, b) ? 1 : 0;
    }
    return ups == 1;
  }

  private boolean isUpwards(final int from, final int to) {
    return y[to] > y[from] || y[to] == y[from] && x[to] > x[from];
  }

  boolean isConvex() {
    return convex;
  }

  double x(final int i) {
    return x[i];
  }

  double y(final int i) {
    return y[i];
  }

  /** Areas up to this one count as 0. */
  double tolerance() {
    return tolerance;
  }

  /** Twice the area of the triangle of three corners, negative if they turn to the right. */
  double side(final int p, final int q, final int r) {
    return (x[q] - x[p]) * (y[r] - y[p]) - (y[q] - y[p]) * (x[r] - x[p]);
  }

  /** Whether a corner lies in the triangle of three others, its edges included. */
  boolean isInside(final int p, final int a, final int b, final int c) {
    return side(a, b, p) >= -tolerance && side(b, c, p) >= -tolerance && side(c, a, p) >= -tolerance;
  }
}
