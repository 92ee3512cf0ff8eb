package rendering;

import java.util.Arrays;

import tracer.Ray;

/** A stack of rays to be followed, each with its depth and its weight. Mutable, one for each thread. */
final class RayStack {

  private Ray[] rays = new Ray[16];
  private int[] depths = new int[16];
  private double[] weights = new double[3 * 16];
  private int top;

  boolean isEmpty() {
    return top == 0;
  }

  void clear() {
    top = 0;
  }

  void push(final Ray ray, final int depth, final double wr, final double wg, final double wb) {
    if (top == rays.length) {
      rays = Arrays.copyOf(rays, 2 * top);
      depths = Arrays.copyOf(depths, 2 * top);
      weights = Arrays.copyOf(weights, 6 * top);
    }
    rays[top] = ray;
    depths[top] = depth;
    weights[3 * top] = wr;
    weights[3 * top + 1] = wg;
    weights[3 * top + 2] = wb;
    top++;
  }

  /** Pops the last ray, whose numbers the methods below return until the next one is pushed. */
  Ray pop() {
    return rays[--top];
  }

  int depth() {
    return depths[top];
  }

  /** The weight in a channel, 0, 1 or 2. */
  double weight(final int channel) {
    return weights[3 * top + channel];
  }
}
