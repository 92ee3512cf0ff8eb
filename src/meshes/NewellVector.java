package meshes;

/**
 * The vector area of a polygon, flat or not: half the sum of (P<sub>i</sub> − P<sub>0</sub>) × (P<sub>i+1</sub> −
 * P<sub>0</sub>), which is perpendicular to the best-fitting plane and as long as the polygon's area in it (Newell; see
 * Sutherland, Sproull and Schumacker, "A characterization of ten hidden-surface algorithms", ACM Computing Surveys 6(1),
 * 1974).
 */
final class NewellVector {

  private double x;
  private double y;
  private double z;
  private double extent;

  /** Computes the vector of the polygon of the first {@code size} vertices. */
  void compute(final double[] coordinates, final int[] vertices, final int size) {
    final int origin = 3 * vertices[0];
    final double ox = coordinates[origin], oy = coordinates[origin + 1], oz = coordinates[origin + 2];
    double sx = 0, sy = 0, sz = 0, px = 0, py = 0, pz = 0;
    double minX = 0, minY = 0, minZ = 0, maxX = 0, maxY = 0, maxZ = 0;
    for (int i = 1; i < size; i++) {
      final int q = 3 * vertices[i];
      final double qx = coordinates[q] - ox, qy = coordinates[q + 1] - oy, qz = coordinates[q + 2] - oz;
      sx += py * qz - pz * qy;
      sy += pz * qx - px * qz;
      sz += px * qy - py * qx;
      minX = Math.min(minX, qx);
      minY = Math.min(minY, qy);
      minZ = Math.min(minZ, qz);
      maxX = Math.max(maxX, qx);
      maxY = Math.max(maxY, qy);
      maxZ = Math.max(maxZ, qz);
      px = qx;
      py = qy;
      pz = qz;
    }
    x = sx / 2;
    y = sy / 2;
    z = sz / 2;
    extent = Math.max(maxX - minX, Math.max(maxY - minY, maxZ - minZ));
  }

  double x() {
    return x;
  }

  double y() {
    return y;
  }

  double z() {
    return z;
  }

  /** Largest extent of the polygon along an axis. */
  double extent() {
    return extent;
  }
}
