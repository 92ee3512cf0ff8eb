package acceleration;

/** A growing box, empty at first. */
final class BoxBuilder {

  private float minX;
  private float minY;
  private float minZ;
  private float maxX;
  private float maxY;
  private float maxZ;

  BoxBuilder() {
    clear();
  }

  /** Extent of the centres of boxes. */
  static BoxBuilder ofCentres(final float[] boxes, final int first, final int end) {
    final BoxBuilder extent = new BoxBuilder();
    for (int i = first; i < end; i++) {
      extent.addCentre(boxes, 6 * i);
    }
    return extent;
  }

  void clear() {
    minX = Float.POSITIVE_INFINITY;
    minY = Float.POSITIVE_INFINITY;
    minZ = Float.POSITIVE_INFINITY;
    maxX = Float.NEGATIVE_INFINITY;
    maxY = Float.NEGATIVE_INFINITY;
    maxZ = Float.NEGATIVE_INFINITY;
  }

  /** Adds a box of an array. */
  void add(final float[] boxes, final int at) {
    add(boxes[at], boxes[at + 1], boxes[at + 2], boxes[at + 3], boxes[at + 4], boxes[at + 5]);
  }

  void add(final BoxBuilder box) {
    add(box.minX, box.minY, box.minZ, box.maxX, box.maxY, box.maxZ);
  }

  /** Adds the centre of a box of an array. */
  void addCentre(final float[] boxes, final int at) {
    final float x = centre(boxes, at, 0), y = centre(boxes, at, 1), z = centre(boxes, at, 2);
    add(x, y, z, x, y, z);
  }

  /** Stores only what changes, and without a loop: half the work of building a tree is done here. */
  private void add(final float leastX, final float leastY, final float leastZ, final float mostX, final float mostY,
      final float mostZ) {
    if (leastX < minX) {
      minX = leastX;
    }
    if (leastY < minY) {
      minY = leastY;
    }
    if (leastZ < minZ) {
      minZ = leastZ;
    }
    if (mostX > maxX) {
      maxX = mostX;
    }
    if (mostY > maxY) {
      maxY = mostY;
    }
    if (mostZ > maxZ) {
      maxZ = mostZ;
    }
  }

  /** Coordinate k of the centre of a box of an array, without overflow of the sum. */
  static float centre(final float[] boxes, final int at, final int k) {
    return 0.5f * boxes[at + k] + 0.5f * boxes[at + k + 3];
  }

  /** Writes the least x, y, z and the greatest into an array. */
  void store(final float[] boxes, final int at) {
    boxes[at] = minX;
    boxes[at + 1] = minY;
    boxes[at + 2] = minZ;
    boxes[at + 3] = maxX;
    boxes[at + 4] = maxY;
    boxes[at + 5] = maxZ;
  }

  /** The coordinate along which it is longest. */
  int longest() {
    final float x = maxX - minX, y = maxY - minY, z = maxZ - minZ;
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  }

  float least(final int k) {
    return k == 0 ? minX : k == 1 ? minY : minZ;
  }

  float length(final int k) {
    return k == 0 ? maxX - minX : k == 1 ? maxY - minY : maxZ - minZ;
  }

  /** Half the surface of the box; 0 if it is empty. In double, as products of extents can overflow float. */
  double area() {
    final double x = (double) maxX - minX, y = (double) maxY - minY, z = (double) maxZ - minZ;
    return x >= 0 ? x * y + y * z + z * x : 0;
  }
}
