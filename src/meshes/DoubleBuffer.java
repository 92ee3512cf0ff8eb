package meshes;

import java.util.Arrays;

/** A growing array of numbers. */
final class DoubleBuffer {

  double[] values = new double[3 * 1024];
  int size;

  void add(final double x, final double y) {
    if (size + 2 > values.length) {
      grow();
    }
    values[size++] = x;
    values[size++] = y;
  }

  void add(final double x, final double y, final double z) {
    if (size + 3 > values.length) {
      grow();
    }
    values[size] = x;
    values[size + 1] = y;
    values[size + 2] = z;
    size += 3;
  }

  private void grow() {
    values = Arrays.copyOf(values, IntBuffer.larger(values.length, 3));
  }

  double[] toArray() {
    return Arrays.copyOf(values, size);
  }
}
