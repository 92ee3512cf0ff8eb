package models;

import javax.vecmath.TexCoord2f;

/** The texture coordinates of the corners of a mesh. */
final class CornerTexCoords {

  private final double[] values;
  private final int[] corners;

  /** The texture coordinates of the triangles of arrays that were rounded from data. */
  CornerTexCoords(final MeshData data, final MeshArrays arrays) {
    this.values = data.texCoords().values();
    this.corners = new int[3 * arrays.size()];
    for (int i = 0; i < corners.length; i++) {
      final int given = 3 * arrays.given(i / 3) + i % 3, pair = data.texCoords().pair(given);
      corners[i] = pair;
    }
  }

  /** The texture coordinates of a corner of a triangle; null if it has none. */
  TexCoord2f pair(final int facet, final int k) {
    final int pair = corners[3 * facet + k];
    return pair < 0 ? null : new TexCoord2f((float) values[2 * pair], (float) values[2 * pair + 1]);
  }

  /** u and v of the three corners of a facet; null if one has none. */
  double[] of(final int facet) {
    final double[] pairs = new double[2 * 3];
    for (int i = 0; i < pairs.length; i++) {
      final int pair = corners[3 * facet + i / 2];
      if (pair < 0) {
        return null;
      }
      pairs[i] = values[2 * pair + i % 2];
    }
    return pairs;
  }
}
