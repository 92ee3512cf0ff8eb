package models;

import javax.vecmath.TexCoord2f;

/** The texture coordinates of the corners of a mesh. */
final class CornerTexCoords {

  private final double[] values;
  private final int[] corners;

  /** Those of the triangles of arrays that were rounded from data. */
  CornerTexCoords(final MeshData data, final MeshArrays arrays) {
    this.values = data.texCoords().values();
    this.corners = new int[3 * arrays.size()];
    for (int i = 0; i < corners.length; i++) {
      final int given = 3 * arrays.given(i / 3) + i % 3, pair = data.texCoords().pair(given);
      corners[i] = pair;
    }
  }

  /** Whether all three corners of a triangle have texture coordinates. */
  boolean has(final int facet) {
    return corners[3 * facet] >= 0 && corners[3 * facet + 1] >= 0 && corners[3 * facet + 2] >= 0;
  }

  /** The texture coordinates of a corner of a triangle; null if it has none. */
  TexCoord2f pair(final int facet, final int k) {
    final int pair = corners[3 * facet + k];
    return pair < 0 ? null : new TexCoord2f((float) values[2 * pair], (float) values[2 * pair + 1]);
  }

  /** The weighted u, 0, or v, 1, of a triangle's corners; NaN if one has none. */
  double coordinate(final int facet, final int which, final Weights weights) {
    double sum = 0;
    for (int k = 0; k < 3; k++) {
      final int pair = corners[3 * facet + k];
      sum += pair < 0 ? Double.NaN : weights.of(k) * values[2 * pair + which];
    }
    return sum;
  }
}
