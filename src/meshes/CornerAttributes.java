package meshes;

import java.util.Arrays;

/**
 * The normals and texture coordinates that the corners of facets can name, and the number of missing ones: statements
 * without numbers, and invalid indices.
 */
final class CornerAttributes {

  /** Normals of unit length; zeros stand for one that is missing or has no direction. */
  private float[] normals = new float[3 * 1024];
  private int normalEnd;
  /** NaN stands for a pair that is missing. */
  private final DoubleBuffer texCoords = new DoubleBuffer();
  private int missing;
  private int firstMissingLine;

  /** Adds a normal of any length. */
  void normal(final double x, final double y, final double z) {
    if (normalEnd + 3 > normals.length) {
      normals = Arrays.copyOf(normals, IntBuffer.larger(normalEnd, 3));
    }
    final double length = Math.sqrt(x * x + y * y + z * z);
    if (length > 0 && length < Double.POSITIVE_INFINITY) {
      normals[normalEnd] = (float) (x / length);
      normals[normalEnd + 1] = (float) (y / length);
      normals[normalEnd + 2] = (float) (z / length);
    } else if (length == Double.POSITIVE_INFINITY || x != 0 || y != 0 || z != 0) {
      final double s = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
      if (s < Double.POSITIVE_INFINITY) {
        normal(x / s, y / s, z / s);
        return;
      }
    }
    normalEnd += 3;
  }

  void texCoord(final double u, final double v) {
    final boolean finite = Double.isFinite(u) && Double.isFinite(v);
    texCoords.add(finite ? u : Double.NaN, finite ? v : Double.NaN);
  }

  /** Whether a number is that of texture coordinates that are not missing. */
  boolean isTexCoord(final int number) {
    return number >= 0 && !Double.isNaN(texCoords.values[2 * number]);
  }

  int normalCount() {
    return normalEnd / 3;
  }

  int texCoordCount() {
    return texCoords.size / 2;
  }

  /** Counts a missing one in a line. */
  void miss(final int line) {
    firstMissingLine = missing++ == 0 ? line : firstMissingLine;
  }

  int missing() {
    return missing;
  }

  int firstMissingLine() {
    return firstMissingLine;
  }

  float[] normals() {
    return Arrays.copyOf(normals, normalEnd);
  }

  double[] texCoords() {
    return texCoords.toArray();
  }
}
