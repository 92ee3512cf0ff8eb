package models;

import static arguments.Arguments.index;
import static arguments.Arguments.wrong;

/** The arrays of a mesh: x, y, z of each vertex, and the places there of the x of each triangle's three vertices. */
final class MeshArrays {

  final float[] coordinates;
  final int[] corners;

  private MeshArrays(final float[] coordinates, final int[] corners) {
    this.coordinates = coordinates;
    this.corners = corners;
  }

  /**
   * Arrays from outside, without the triangles that have no area: the coordinates as they are given, new corners.
   *
   * @param given vertex numbers, three to a triangle
   * @throws IllegalArgumentException if something is wrong with them; see {@link TriangularMesh#of}
   */
  static MeshArrays checked(final float[] coordinates, final String name, final int[] given) {
    if (coordinates.length % 3 != 0 || given.length % 3 != 0) {
      throw wrong("triples", coordinates.length, given.length);
    }
    for (int i = 0; i < coordinates.length; i++) {
      if (!Float.isFinite(coordinates[i])) {
        throw wrong("finite", "coordinates[" + i + "]", coordinates[i]);
      }
    }
    final int[] corners = new int[given.length];
    int end = 0;
    for (int i = 0; i < given.length; i += 3) {
      final int a = place(coordinates, given, i), b = place(coordinates, given, i + 1), c = place(coordinates, given, i + 2);
      if (hasArea(coordinates, a, b, c)) {
        corners[end++] = a;
        corners[end++] = b;
        corners[end++] = c;
      }
    }
    if (end == 0) {
      throw wrong("noTriangle", name, given.length / 3);
    }
    return new MeshArrays(coordinates, end == corners.length ? corners : java.util.Arrays.copyOf(corners, end));
  }

  private static int place(final float[] coordinates, final int[] given, final int i) {
    if (given[i] < 0 || given[i] >= coordinates.length / 3) {
      index("corners[" + i + "]", coordinates.length / 3, given[i]);
    }
    return 3 * given[i];
  }

  /** Whether a triangle has an area at all: its normal, in double, is not zero. */
  private static boolean hasArea(final float[] v, final int a, final int b, final int c) {
    final double px = (double) v[b] - v[a], py = (double) v[b + 1] - v[a + 1], pz = (double) v[b + 2] - v[a + 2];
    final double qx = (double) v[c] - v[a], qy = (double) v[c + 1] - v[a + 1], qz = (double) v[c + 2] - v[a + 2];
    return py * qz - pz * qy != 0 || pz * qx - px * qz != 0 || px * qy - py * qx != 0;
  }
}
