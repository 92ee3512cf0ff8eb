package models;

import primitives.Vector3D;

/**
 * The normals that shade the corners of a mesh, interpolated between them (Phong, "Illumination for computer generated
 * pictures", CACM 18(6), 1975). They are those of the front, which the winding of the triangle decides: where the three
 * normals of a triangle together point behind it, all three are reversed. A corner without a normal has that of its
 * triangle.
 */
final class CornerNormals {

  private final float[] values;
  /** For each corner 0 if it has no normal, else its number from 1, negative if it is reversed. */
  private final int[] corners;

  /** The normals of the triangles of arrays that were rounded from data. */
  CornerNormals(final MeshData data, final MeshArrays arrays) {
    this.values = data.normals().values();
    this.corners = new int[3 * arrays.size()];
    for (int facet = 0; facet < arrays.size(); facet++) {
      final int sign = isBehind(data, 3 * arrays.given(facet)) ? -1 : 1;
      for (int k = 0; k < 3; k++) {
        corners[3 * facet + k] = sign * number(data.normals().corners()[3 * arrays.given(facet) + k]);
      }
    }
  }

  private int number(final int normal) {
    final int at = 3 * normal;
    return normal < 0 || values[at] == 0 && values[at + 1] == 0 && values[at + 2] == 0 ? 0 : normal + 1;
  }

  private boolean isBehind(final MeshData data, final int i) {
    final double[] p = data.coordinates();
    final int a = 3 * data.corners()[i], b = 3 * data.corners()[i + 1], c = 3 * data.corners()[i + 2];
    final double ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
    final double vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
    double x = 0, y = 0, z = 0;
    for (int k = 0; k < 3; k++) {
      final int normal = 3 * data.normals().corners()[i + k];
      x += normal < 0 ? 0 : values[normal];
      y += normal < 0 ? 0 : values[normal + 1];
      z += normal < 0 ? 0 : values[normal + 2];
    }
    return x * (uy * vz - uz * vy) + y * (uz * vx - ux * vz) + z * (ux * vy - uy * vx) < 0;
  }

  /** The normal of a corner of a triangle, on its front; null if it has none. */
  Vector3D normal(final int facet, final int k) {
    final int corner = corners[3 * facet + k], at = 3 * (Math.abs(corner) - 1);
    return corner == 0 ? null
        : new Vector3D(Math.signum(corner) * values[at], Math.signum(corner) * values[at + 1],
            Math.signum(corner) * values[at + 2]);
  }

  /**
   * The normals of the three corners of a facet, the triangle's own where one has none; null if none of them has one.
   */
  float[] of(final int facet, final Triangle triangle) {
    final float[] own = triangle.unitNormal(), normals = new float[3 * 3];
    boolean isSmooth = false;
    for (int i = 0; i < normals.length; i++) {
      final int corner = corners[3 * facet + i / 3], at = 3 * (Math.abs(corner) - 1) + i % 3;
      normals[i] = corner == 0 ? own[i % 3] : corner > 0 ? values[at] : -values[at];
      isSmooth |= corner != 0;
    }
    return isSmooth ? normals : null;
  }
}
