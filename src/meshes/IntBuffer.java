package meshes;

import java.util.Arrays;

/** A growing array of integers. */
final class IntBuffer {

  int[] values = new int[1024];
  int size;

  /** Ensures room for more numbers. */
  void reserve(final int more) {
    if (size + more > values.length) {
      values = Arrays.copyOf(values, larger(values.length, more));
    }
  }

  void add(final int value) {
    reserve(1);
    values[size++] = value;
  }

  /** Pads with a number up to a size. */
  void fill(final int value, final int wanted) {
    reserve(wanted - size);
    Arrays.fill(values, size, wanted, value);
    size = wanted;
  }

  int[] toArray() {
    return Arrays.copyOf(values, size);
  }

  /** Half as much again; a size beyond that of arrays fails when the array is allocated. */
  static int larger(final int length, final int more) {
    return (int) Math.min((long) length + Math.max(more, length / 2), Integer.MAX_VALUE);
  }
}
