package models;

/**
 * Error bounds of points: see {@link tracer.Hit#errorBound()}.
 *
 * <p>A shape's arithmetic is a few dozen operations in double on numbers not larger than the coordinates and the size of
 * the shape, each of which adds at most 2<sup>−53</sup> of them. The bound is 128 such errors. That rays start off a surface
 * by the error of the shape is Pharr, Jakob and Humphreys, "Physically Based Rendering", 4th edition, 2023, section 6.8.
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
