package models;

import static arguments.Arguments.index;
import static arguments.Arguments.wrong;

import java.awt.Color;
import java.util.Arrays;

/**
 * The arrays of a mesh for intersection: x, y, z of each vertex in floats, and the indices of the x of each triangle's
 * three vertices. Triangles that have no area in floats are left out.
 */
final class MeshArrays {

  final float[] coordinates;
  final int[] corners;

  /** For each triangle its number in the arrays that were given; null if none is left out. */
  private final int[] given;

  private MeshArrays(final float[] coordinates, final int[] corners, final int[] given) {
    this.coordinates = coordinates;
    this.corners = corners;
    this.given = given;
  }

  int size() {
    return corners.length / 3;
  }

  /** The number that a triangle had before others were left out. */
  int given(final int facet) {
    return given == null ? facet : given[facet];
  }

  /**
   * Arrays given by a caller, without the triangles that have no area: the given coordinates, and new corners.
   *
   * @param numbers vertex numbers, three to a triangle
   * @throws IllegalArgumentException if they are invalid; see {@link TriangularMesh#of(float[], int[], Color)}
   */
  static MeshArrays checked(final float[] coordinates, final String name, final int[] numbers) {
    if (coordinates.length % 3 != 0 || numbers.length % 3 != 0) {
      throw wrong("triples", coordinates.length, numbers.length);
    }
    for (int i = 0; i < coordinates.length; i++) {
      if (!Float.isFinite(coordinates[i])) {
        throw wrong("finite", "coordinates[" + i + "]", coordinates[i]);
      }
    }
    final int[] corners = new int[numbers.length];
    final int[] given = new int[numbers.length / 3];
    int end = 0;
    for (int i = 0; i < numbers.length; i += 3) {
      final int a = place(coordinates, numbers, i), b = place(coordinates, numbers, i + 1),
          c = place(coordinates, numbers, i + 2);
      if (hasArea(coordinates, a, b, c)) {
        given[end / 3] = i / 3;
        corners[end++] = a;
        corners[end++] = b;
        corners[end++] = c;
      }
    }
    if (end == 0) {
      throw wrong("noTriangle", name, numbers.length / 3);
    }
    return end == corners.length ? new MeshArrays(coordinates, corners, null)
        : new MeshArrays(coordinates, Arrays.copyOf(corners, end), Arrays.copyOf(given, end / 3));
  }

  /** Arrays in double, rounded to floats. */
  static MeshArrays rounded(final MeshData data) {
    final float[] coordinates = new float[data.coordinates().length];
    for (int i = 0; i < coordinates.length; i++) {
      coordinates[i] = (float) data.coordinates()[i];
    }
    return checked(coordinates, "corners", data.corners());
  }

  private static int place(final float[] coordinates, final int[] numbers, final int i) {
    if (numbers[i] < 0 || numbers[i] >= coordinates.length / 3) {
      index("corners[" + i + "]", coordinates.length / 3, numbers[i]);
    }
    return 3 * numbers[i];
  }

  /** Whether a triangle has an area: its normal, in double, is not zero. */
  private static boolean hasArea(final float[] v, final int a, final int b, final int c) {
    final double px = (double) v[b] - v[a], py = (double) v[b + 1] - v[a + 1], pz = (double) v[b + 2] - v[a + 2];
    final double qx = (double) v[c] - v[a], qy = (double) v[c + 1] - v[a + 1], qz = (double) v[c + 2] - v[a + 2];
    return py * qz - pz * qy != 0 || pz * qx - px * qz != 0 || px * qy - py * qx != 0;
  }
}
