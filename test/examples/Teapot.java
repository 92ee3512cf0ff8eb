package examples;

/**
 * The Utah teapot: 32 bicubic Bézier patches, cut into facets.
 *
 * <p>The control points are those that Martin Newell published (M. Newell, "The Utilization of Procedure Models in
 * Digital Image Synthesis", PhD thesis, University of Utah, 1975; listed in F. Crow, "The Origins of the Teapot", IEEE
 * Computer Graphics and Applications 7(1), 1987), flattened by the factor 1.3 and with a bottom, as usual today. Lid and
 * body turn about the axis, so that profiles are enough to describe them; each quarter of a turn is one patch, in which
 * Newell takes 0.56 for the circle. Handle and spout are halves of tubes, the other half is a mirror image. The parts
 * touch without being joined: the teapot is not a closed mesh.
 */
final class Teapot {

  /** Number of facets along each side of a patch. */
  private static final int CUTS = 16;

  /** Where the inner control points of a quarter of a circle are. */
  private static final double ROUND = 0.56;

  /** Radius and height from the tip of the lid to its edge: two curves, which share a point. */
  private static final double[][] LID = {
      {0, 3.15}, {0.8, 3.15}, {0, 2.85}, {0.2, 2.7},
      {0.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}};

  /** Radius and height from the rim to the middle of the bottom. */
  private static final double[][] BODY = {
      {1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4},
      {1.75, 1.875}, {2, 1.35}, {2, 0.9},
      {2, 0.45}, {1.5, 0.225}, {1.5, 0.15},
      {1.5, 0.075}, {1.425, 0}, {0, 0}};

  /** Rows of control points of a half tube: x and height of the inner and of the outer edge, and half the width. */
  private static final double[][] HANDLE = {
      {-1.6, 2.025, -1.5, 2.25, 0.3}, {-2.3, 2.025, -2.5, 2.25, 0.3}, {-2.7, 2.025, -3, 2.25, 0.3},
      {-2.7, 1.8, -3, 1.8, 0.3},
      {-2.7, 1.575, -3, 1.35, 0.3}, {-2.5, 1.125, -2.65, 0.9375, 0.3}, {-2, 0.9, -1.9, 0.6, 0.3}};

  private static final double[][] SPOUT = {
      {1.7, 1.425, 1.7, 0.6, 0.66}, {2.6, 1.425, 3.1, 0.825, 0.66}, {2.3, 2.1, 2.4, 2.025, 0.25},
      {2.7, 2.4, 3.3, 2.4, 0.25},
      {2.8, 2.475, 3.525, 2.49375, 0.25}, {2.9, 2.475, 3.45, 2.5125, 0.15}, {2.8, 2.4, 3.2, 2.4, 0.15}};

  private final MeshText mesh = new MeshText("The Utah teapot of Martin Newell (1975), from his published control points.",
      "Y is up, the teapot stands on y = 0, its spout points along +x.", "Written by test/examples/Teapot.java.");

  private Teapot() {
  }

  /** The text of the file. */
  static String text() {
    final Teapot teapot = new Teapot();
    teapot.turn(LID);
    teapot.turn(BODY);
    teapot.tube(HANDLE);
    teapot.tube(SPOUT);
    return teapot.mesh.toString();
  }

  /** Adds what a profile describes when it turns about the axis. */
  private void turn(final double[][] profile) {
    final int[][] grid = new int[(profile.length - 1) / 3 * CUTS + 1][4 * CUTS];
    for (int i = 0; i < grid.length; i++) {
      final double[] p = onCurve(profile, i);
      for (int j = 0; j < 4 * CUTS; j++) {
        final boolean pole = p[0] == 0 && j > 0;
        grid[i][j] = pole ? grid[i][0] : mesh.point(p[0] * quarter(j + CUTS), p[1], p[0] * quarter(j));
      }
    }
    mesh.rings(grid, false);
  }

  /** Newell's sine: how far a circle of radius 1 has gone sideways after so many cuts, CUTS of them in a quarter. */
  private static double quarter(final int cut) {
    final int turn = Math.floorMod(cut, 4 * CUTS);
    if (turn >= 2 * CUTS) {
      return -quarter(turn - 2 * CUTS);
    }
    final int rising = Math.min(turn, 2 * CUTS - turn);
    return cubic((double) rising / CUTS, 0, ROUND, 1, 1);
  }

  /** Adds a tube from the rows of control points of its half. */
  private void tube(final double[][] rows) {
    final int[][] grid = new int[(rows.length - 1) / 3 * CUTS + 1][2 * CUTS];
    for (int i = 0; i < grid.length; i++) {
      final double[] row = onCurve(rows, i);
      for (int j = 0; j < 2 * CUTS; j++) {
        final double v = (j <= CUTS ? j : 2.0 * CUTS - j) / CUTS;
        final double side = cubic(v, 0, row[4], row[4], 0);
        grid[i][j] = mesh.point(cubic(v, row[0], row[0], row[2], row[2]), cubic(v, row[1], row[1], row[3], row[3]),
            j <= CUTS ? side : -side);
      }
    }
    mesh.rings(grid, false);
  }

  /** The point of a chain of cubic curves after so many cuts. */
  private static double[] onCurve(final double[][] points, final int cut) {
    final int first = Math.min(cut / CUTS * 3, points.length - 4);
    final double t = (double) cut / CUTS - first / 3;
    final double[] result = new double[points[0].length];
    for (int k = 0; k < result.length; k++) {
      result[k] = cubic(t, points[first][k], points[first + 1][k], points[first + 2][k], points[first + 3][k]);
    }
    return result;
  }

  /** A cubic Bézier curve in one coordinate. */
  private static double cubic(final double t, final double a, final double b, final double c, final double d) {
    final double s = 1 - t;
    return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
  }
}
