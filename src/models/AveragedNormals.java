package models;

import java.util.Arrays;

/**
 * Normals of vertices as averages of the facets around them, each weighted by its area (Gouraud, "Continuous shading of
 * curved surfaces", IEEE Transactions on Computers C-20(6), 1971; the weights follow from adding vector areas).
 */
public final class AveragedNormals {

  /** Relative size below which a sum is the rounding error of areas that cancel. */
  private static final double CANCELLED = 1e-6;

  /** Polygons of more corners are sorted to find vertices that occur twice. */
  private static final int FEW = 16;

  /** For each vertex x, y and z of the sum of vector areas, and the sum of their lengths. */
  private double[] sums = new double[4 * 1024];

  /**
   * Adds a facet.
   *
   * @param x first component of its vector area
   * @param y second component
   * @param z third component
   * @param vertices the vertices at its corners, from 0; one that occurs twice counts once
   * @param number number of corners
   */
  public void add(final double x, final double y, final double z, final int[] vertices, final int number) {
    final double area = Math.sqrt(x * x + y * y + z * z);
    final int[] corners = number > FEW ? Arrays.copyOf(vertices, number) : vertices;
    if (number > FEW) {
      Arrays.sort(corners);
    }
    for (int i = 0; i < number; i++) {
      if (!occursBefore(corners, i, number > FEW ? i - 1 : 0)) {
        add(4 * corners[i], x, y, z, area);
      }
    }
  }

  private static boolean occursBefore(final int[] corners, final int i, final int from) {
    for (int k = Math.max(0, from); k < i; k++) {
      if (corners[k] == corners[i]) {
        return true;
      }
    }
    return false;
  }

  private void add(final int at, final double x, final double y, final double z, final double area) {
    if (at >= sums.length) {
      sums = Arrays.copyOf(sums, Math.max(at + 4, sums.length + sums.length / 8 * 4));
    }
    sums[at] += x;
    sums[at + 1] += y;
    sums[at + 2] += z;
    sums[at + 3] += area;
  }

  /**
   * The averages.
   *
   * @param number number of vertices
   * @return three components of a unit vector for each vertex; zeros where the facets cancel, or where there are none
   */
  public float[] of(final int number) {
    final float[] normals = new float[3 * number];
    for (int i = 0; i < number && 4 * i < sums.length; i++) {
      final double x = sums[4 * i], y = sums[4 * i + 1], z = sums[4 * i + 2], length = Math.sqrt(x * x + y * y + z * z);
      if (length > CANCELLED * sums[4 * i + 3] && length < Double.POSITIVE_INFINITY) {
        normals[3 * i] = (float) (x / length);
        normals[3 * i + 1] = (float) (y / length);
        normals[3 * i + 2] = (float) (z / length);
      }
    }
    return normals;
  }
}
