package meshes;

import java.util.Arrays;

/** The vertices and triangles of a mesh while it is read: arrays that grow. Triangles without area are counted only. */
final class TriangleBuffer {

  private float[] coordinates = new float[3 * 1024];
  private int[] corners = new int[3 * 2048];
  private int vertexEnd;
  private int cornerEnd;
  /** Lines of the triangles at the end, whose areas are not looked at yet: many in a row go faster than each alone. */
  private final int[] lines = new int[1024];
  private int unsettled;
  private int dropped;
  private int firstDroppedLine;

  void vertex(final float x, final float y, final float z) {
    if (vertexEnd == coordinates.length) {
      coordinates = Arrays.copyOf(coordinates, larger(vertexEnd));
    }
    coordinates[vertexEnd] = x;
    coordinates[vertexEnd + 1] = y;
    coordinates[vertexEnd + 2] = z;
    vertexEnd += 3;
  }

  /** Adds the triangle of three vertices that a facet of a line gives. */
  void triangle(final int a, final int b, final int c, final int line) {
    if (cornerEnd == corners.length) {
      corners = Arrays.copyOf(corners, larger(cornerEnd));
    }
    corners[cornerEnd] = a;
    corners[cornerEnd + 1] = b;
    corners[cornerEnd + 2] = c;
    cornerEnd += 3;
    lines[unsettled++] = line;
    if (unsettled == lines.length) {
      settle();
    }
  }

  /** Leaves out those of the last triangles that have no area. */
  void settle() {
    int kept = cornerEnd - 3 * unsettled;
    for (int n = 0; n < unsettled; n++) {
      final int i = cornerEnd - 3 * (unsettled - n);
      if (hasArea(3 * corners[i], 3 * corners[i + 1], 3 * corners[i + 2])) {
        corners[kept] = corners[i];
        corners[kept + 1] = corners[i + 1];
        corners[kept + 2] = corners[i + 2];
        kept += 3;
      } else {
        firstDroppedLine = dropped++ == 0 ? lines[n] : firstDroppedLine;
      }
    }
    cornerEnd = kept;
    unsettled = 0;
  }

  /** Half as much again, a multiple of three; what would not fit an array is left to the attempt to make it. */
  private static int larger(final int length) {
    return (int) Math.min((long) length + length / 6 * 3, Integer.MAX_VALUE);
  }

  private boolean hasArea(final int a, final int b, final int c) {
    final float[] p = coordinates;
    final double ux = (double) p[b] - p[a], uy = (double) p[b + 1] - p[a + 1], uz = (double) p[b + 2] - p[a + 2];
    final double vx = (double) p[c] - p[a], vy = (double) p[c + 1] - p[a + 1], vz = (double) p[c + 2] - p[a + 2];
    return uy * vz != uz * vy || uz * vx != ux * vz || ux * vy != uy * vx;
  }

  int vertices() {
    return vertexEnd / 3;
  }

  boolean isEmpty() {
    return cornerEnd == 0;
  }

  int dropped() {
    return dropped;
  }

  /** Line of the first facet with a triangle that was dropped. */
  int firstDroppedLine() {
    return firstDroppedLine;
  }

  ObjReader.Mesh mesh() {
    return new ObjReader.Mesh(Arrays.copyOf(coordinates, vertexEnd), Arrays.copyOf(corners, cornerEnd));
  }
}
