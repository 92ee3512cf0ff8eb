package examples;

/** The text of a mesh in the Wavefront OBJ format: points, and facets between them. */
final class MeshText {

  private final StringBuilder text = new StringBuilder();
  private int points;

  MeshText(final String... comment) {
    for (final String line : comment) {
      text.append("# ").append(line).append('\n');
    }
  }

  /** Adds a point and returns its number, from 1. */
  int point(final double x, final double y, final double z) {
    text.append("v ").append(Numbers.text(x, 4)).append(' ').append(Numbers.text(y, 4)).append(' ')
        .append(Numbers.text(z, 4)).append('\n');
    return ++points;
  }

  /** Adds a facet, its points counter-clockwise seen from outside; of repeated points one counts. */
  void facet(final int... numbers) {
    text.append('f');
    for (int i = 0; i < numbers.length; i++) {
      if (numbers[i] != numbers[(i + 1) % numbers.length]) {
        text.append(' ').append(numbers[i]);
      }
    }
    text.append('\n');
  }

  /**
   * Adds the facets between neighbours of a grid of points.
   *
   * @param grid the numbers of the points: rows that go round, each closed into a ring
   * @param closed whether the last row is joined to the first
   */
  void rings(final int[][] grid, final boolean closed) {
    for (int i = 0; i < (closed ? grid.length : grid.length - 1); i++) {
      final int[] row = grid[i];
      final int[] next = grid[(i + 1) % grid.length];
      for (int j = 0; j < row.length; j++) {
        final int k = (j + 1) % row.length;
        facet(row[j], row[k], next[k], next[j]);
      }
    }
  }

  @Override
  public String toString() {
    return text.toString();
  }
}
