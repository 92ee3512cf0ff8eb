package models;

import static arguments.Arguments.notNull;

/**
 * A mesh as arrays in double precision, for whoever has many triangles, such as a reader of files. The arrays are kept as
 * they are and must not be changed afterwards.
 *
 * @param coordinates x, y and z of each vertex
 * @param corners the three vertices of each triangle, counter-clockwise, as numbers from 0
 * @param normals what shades the corners; null for a flat mesh
 * @param texCoords where the corners lie in a texture; null for a mesh without texture coordinates
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
   * Checks that the arrays are there.
   *
   * @param coordinates x, y and z of each vertex
   * @param corners the three vertices of each triangle
   * @param normals what shades the corners, or null
   * @param texCoords where the corners lie in a texture, or null
   * @throws IllegalArgumentException if the coordinates or the corners are null
   */
  public MeshData {
    notNull("coordinates", coordinates);
    notNull("corners", corners);
  }
}
