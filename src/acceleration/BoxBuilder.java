package acceleration;

import java.util.Arrays;

/** A growing box of six floats: least x, y, z, greatest x, y, z. */
final class BoxBuilder {

  private final float[] numbers = new float[6];

  BoxBuilder() {
    Arrays.fill(numbers, 0, 3, Float.POSITIVE_INFINITY);
    Arrays.fill(numbers, 3, 6, Float.NEGATIVE_INFINITY);
  }

  /** Extent of the centres of boxes. */
  static BoxBuilder of(final float[] boxes, final int first, final int end) {
    final BoxBuilder extent = new BoxBuilder();
    for (int i = first; i < end; i++) {
      extent.addCentre(boxes, 6 * i);
    }
    return extent;
  }

  float[] numbers() {
    return numbers;
  }

  /** Takes in a box. */
  void add(final float[] boxes, final int at) {
    for (int k = 0; k < 3; k++) {
      numbers[k] = boxes[at + k] < numbers[k] ? boxes[at + k] : numbers[k];
      numbers[k + 3] = boxes[at + k + 3] > numbers[k + 3] ? boxes[at + k + 3] : numbers[k + 3];
    }
  }

  /** Takes in the centre of a box. */
  void addCentre(final float[] boxes, final int at) {
    for (int k = 0; k < 3; k++) {
      final float c = centre(boxes, at, k);
      numbers[k] = c < numbers[k] ? c : numbers[k];
      numbers[k + 3] = c > numbers[k + 3] ? c : numbers[k + 3];
    }
  }

  /** Coordinate k of the centre of a box, without the overflow of a sum. */
  static float centre(final float[] boxes, final int at, final int k) {
    return 0.5f * boxes[at + k] + 0.5f * boxes[at + k + 3];
  }

  /** The coordinate along which it is longest. */
  int longest() {
    final float x = numbers[3] - numbers[0], y = numbers[4] - numbers[1], z = numbers[5] - numbers[2];
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  }

  float least(final int k) {
    return numbers[k];
  }

  float length(final int k) {
    return numbers[k + 3] - numbers[k];
  }

  /** Half the surface of the box; 0 if it is empty. In double, for extents whose products no float holds. */
  double area() {
    final double x = (double) numbers[3] - numbers[0], y = (double) numbers[4] - numbers[1];
    final double z = (double) numbers[5] - numbers[2];
    return x >= 0 ? x * y + y * z + z * x : 0;
  }

  void clear() {
    Arrays.fill(numbers, 0, 3, Float.POSITIVE_INFINITY);
    Arrays.fill(numbers, 3, 6, Float.NEGATIVE_INFINITY);
  }
}
