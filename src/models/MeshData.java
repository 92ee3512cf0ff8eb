package models;

import static arguments.Arguments.notNull;

/**
 * A mesh as arrays in double precision, for sources of many triangles, such as readers of files. The arrays are not
 * copied, and must not be changed afterwards.
 *
 * @param coordinates x, y and z of each vertex
 * @param corners the three vertices of each triangle, counter-clockwise, as numbers from 0
 * @param normals the shading normals; null for a flat mesh
 * @param texCoords the texture coordinates; null if there are none
 */
public record MeshData(double[] coordinates, int[] corners, Normals normals, TexCoords texCoords) {

  /**
   * Normals of corners.
   *
   * @param values three components of each normal, of unit length; one of zeros counts as none
   * @param corners for each corner of each triangle the number of its normal, from 0; negative: none
   */
  public record Normals(float[] values, int[] corners) {
  }

  /**
   * Texture coordinates of corners.
   *
   * @param values u and v of each; one with NaN counts as none
   * @param corners for each corner of each triangle the number of its pair, from 0; negative: none
   */
  public record TexCoords(double[] values, int[] corners) {

    /** Number of the pair of a corner; −1 if it has none. The last triangles may have no corners here. */
    int pair(final int corner) {
      final int pair = corner < corners.length ? corners[corner] : -1;
      return pair < 0 || Double.isNaN(values[2 * pair]) ? -1 : pair;
    }
  }

  /**
   * Checks that the arrays are not null.
   *
   * @param coordinates x, y and z of each vertex
   * @param corners the three vertices of each triangle
   * @param normals the shading normals, or null
   * @param texCoords the texture coordinates, or null
   * @throws IllegalArgumentException if the coordinates or the corners are null
   */
  public MeshData {
    notNull("coordinates", coordinates);
    notNull("corners", corners);
  }
}
