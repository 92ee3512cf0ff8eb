package meshes;

import java.util.Arrays;

/** Whole numbers in an array that grows. */
final class IntBuffer {

  int[] values = new int[1024];
  int size;

  /** Makes room for some more. */
  void reserve(final int more) {
    if (size + more > values.length) {
      values = Arrays.copyOf(values, larger(values.length, more));
    }
  }

  void add(final int value) {
    reserve(1);
    values[size++] = value;
  }

  /** Adds a number several times until there are as many as wanted. */
  void fill(final int value, final int wanted) {
    reserve(wanted - size);
    Arrays.fill(values, size, wanted, value);
    size = wanted;
  }

  int[] toArray() {
    return Arrays.copyOf(values, size);
  }

  /** Half as much again; what would not fit an array is left to the attempt to make it. */
  static int larger(final int length, final int more) {
    return (int) Math.min((long) length + Math.max(more, length / 2), Integer.MAX_VALUE);
  }
}
