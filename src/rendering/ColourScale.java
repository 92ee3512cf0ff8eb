package rendering;

/**
 * A scale that maps numbers to colours, non-linearly, so that the many small ones can be distinguished and the few large
 * ones fit too.
 */
public final class ColourScale {

  private final boolean depth;
  private final double least;
  private final double greatest;

  private ColourScale(final boolean depth, final double least, final double greatest) {
    this.depth = depth;
    this.least = least;
    this.greatest = greatest;
  }

  /**
   * The scale of distances, from white to black, linear in 1/t: so an infinite plane leaves shades for the objects on it.
   *
   * @param near least distance, &gt; 0
   * @param far greatest distance, at least the least one
   * @return the scale
   */
  public static ColourScale ofDepth(final double near, final double far) {
    return new ColourScale(true, near, far);
  }

  /**
   * The scale of costs, from black over red and yellow to white, linear in the logarithm of 1 + c.
   *
   * @param greatest the greatest cost, at least 0; the least one is 0
   * @return the scale
   */
  public static ColourScale ofCost(final double greatest) {
    return new ColourScale(false, 0, greatest);
  }

  /**
   * Whether this is a scale of distances.
   *
   * @return true for distances, false for costs
   */
  public boolean isDepth() {
    return depth;
  }

  /**
   * The number at one end.
   *
   * @return the least number
   */
  public double least() {
    return least;
  }

  /**
   * The number at the other end.
   *
   * @return the greatest number
   */
  public double greatest() {
    return greatest;
  }

  /**
   * The position of a number on the scale.
   *
   * @param value the number
   * @return 0 at the least number, 1 at the greatest; numbers beyond are clamped
   */
  public double position(final double value) {
    final double position = depth ? (1 / least - 1 / value) / (1 / least - 1 / greatest)
        : Math.log1p(value) / Math.log1p(greatest);
    return greatest > least ? Math.max(0, Math.min(1, position)) : 0;
  }

  /**
   * The number at a position of the scale.
   *
   * @param position 0 … 1
   * @return the number
   */
  public double value(final double position) {
    return depth ? 1 / (1 / least + position * (1 / greatest - 1 / least)) : Math.expm1(position * Math.log1p(greatest));
  }

  /**
   * The colour at a position of the scale.
   *
   * @param position 0 … 1
   * @return sRGB, opaque
   */
  public static int heat(final double position) {
    return 0xff << 24 | level(3 * position) << 16 | level(3 * position - 1) << 8 | level(3 * position - 2);
  }

  private static int level(final double k) {
    return (int) (255 * Math.max(0, Math.min(1, k)) + 0.5);
  }

  /**
   * The colour of a number.
   *
   * @param value the number
   * @return sRGB, opaque
   */
  public int argb(final double value) {
    return argbAt(position(value));
  }

  /**
   * The colour at a position of this scale.
   *
   * @param position 0 … 1
   * @return sRGB, opaque
   */
  public int argbAt(final double position) {
    return depth ? 0xff << 24 | level(1 - position) * 0x010101 : heat(position);
  }
}
