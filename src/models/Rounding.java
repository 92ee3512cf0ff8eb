package models;

/**
 * Error bounds of points: see {@link tracer.Hit#errorBound()}.
 *
 * <p>The arithmetic of a shape is a few dozen operations in double on numbers no larger than its coordinates and its
 * size, each with a relative error of at most 2<sup>−53</sup>. The bound is 128 such errors. Starting rays off a surface
 * by the error of the shape: Pharr, Jakob and Humphreys, "Physically Based Rendering", 4th edition, 2023, section 6.8.
 */
final class Rounding {

  private static final double PART = 0x1p-46;

  private Rounding() {
  }

  /** The bound for a point on a shape, both given by numbers of the scene that they were computed from. */
  static double bound(final double x, final double y, final double z, final double size) {
    return PART * (Math.abs(x) + Math.abs(y) + Math.abs(z) + size);
  }
}
