package radiometry;

import static arguments.Arguments.notNegative;
import static arguments.Arguments.notNull;

/**
 * Three numbers, at least 0 and finite, for the channels red, green and blue of linear sRGB: a radiance, or equally an
 * irradiance, an intensity or a power. Immutable.
 */
public final class RadianceRGB {

  /** No light: 0 in each channel. */
  public static final RadianceRGB NORADIANCE = new RadianceRGB(0, 0, 0);

  private final double r;
  private final double g;
  private final double b;

  /**
   * The radiance of three numbers.
   *
   * @param r red, at least 0
   * @param g green, at least 0
   * @param b blue, at least 0
   * @throws IllegalArgumentException if a number is negative, infinite or NaN
   */
  public RadianceRGB(final double r, final double g, final double b) {
    this.r = notNegative("r", r);
    this.g = notNegative("g", g);
    this.b = notNegative("b", b);
  }

  /**
   * Red.
   *
   * @return the number, at least 0
   */
  public double getR() {
    return r;
  }

  /**
   * Green.
   *
   * @return the number, at least 0
   */
  public double getG() {
    return g;
  }

  /**
   * Blue.
   *
   * @return the number, at least 0
   */
  public double getB() {
    return b;
  }

  /**
   * Adds two radiances.
   *
   * @param other the radiance to add
   * @return the sum, channel by channel
   * @throws IllegalArgumentException if other is null, or if the sum overflows
   */
  public RadianceRGB plus(final RadianceRGB other) {
    notNull("other", other);
    return new RadianceRGB(r + other.r, g + other.g, b + other.b);
  }

  /**
   * Scales a radiance.
   *
   * @param factor a number, at least 0
   * @return each channel times the factor
   * @throws IllegalArgumentException if the factor is negative, infinite or NaN, or if the product overflows
   */
  public RadianceRGB times(final double factor) {
    notNegative("factor", factor);
    return new RadianceRGB(factor * r, factor * g, factor * b);
  }

  /**
   * What is left after a reflection.
   *
   * @param factors the part of each channel that is reflected
   * @return each channel times its factor
   * @throws IllegalArgumentException if factors is null
   */
  public RadianceRGB times(final ReflectanceRGB factors) {
    notNull("factors", factors);
    return new RadianceRGB(r * factors.getR(), g * factors.getG(), b * factors.getB());
  }

  @Override
  public String toString() {
    return "RadianceRGB(" + r + ", " + g + ", " + b + ")";
  }
}
