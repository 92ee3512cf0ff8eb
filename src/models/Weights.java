package models;

/**
 * The barycentric coordinates of a point in a triangle: the weight of each vertex. None is negative, and their sum is 1.
 *
 * @param a of the first vertex
 * @param b of the second vertex
 * @param c of the third vertex
 */
record Weights(double a, double b, double c) {

  /** The weights of three numbers that are proportional to them up to rounding. */
  static Weights proportionalTo(final double a, final double b, final double c) {
    final double x = Math.max(0, a), y = Math.max(0, b), z = Math.max(0, c), sum = x + y + z;
    return new Weights(x / sum, y / sum, z / sum);
  }

  /** The weight of a vertex, 0, 1 or 2. */
  double of(final int vertex) {
    return vertex == 0 ? a : vertex == 1 ? b : c;
  }
}
