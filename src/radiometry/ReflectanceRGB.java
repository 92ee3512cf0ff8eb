package radiometry;

import static arguments.Arguments.notNull;
import static arguments.Arguments.within;

import java.awt.Color;

/**
 * The fraction of light that is reflected or transmitted, a factor from 0 to 1 for each of the channels red, green and
 * blue of linear sRGB. Immutable.
 */
public final class ReflectanceRGB {

  private final float r;
  private final float g;
  private final float b;

  /**
   * The reflectance of three factors, used as they are.
   *
   * @param r red, from 0 to 1
   * @param g green, from 0 to 1
   * @param b blue, from 0 to 1
   * @throws IllegalArgumentException if a factor is less than 0, greater than 1, or NaN
   */
  public ReflectanceRGB(final float r, final float g, final float b) {
    this.r = within("r", 0f, 1f, r);
    this.g = within("g", 0f, 1f, g);
    this.b = within("b", 0f, 1f, b);
  }

  /**
   * The reflectance of a matte surface of a colour of the screen: its components decoded to linear by IEC 61966-2-1,
   * "Default RGB colour space - sRGB", 1999. Alpha is ignored.
   *
   * @param srgb the colour
   * @throws IllegalArgumentException if the colour is null
   */
  public ReflectanceRGB(final Color srgb) {
    this(linear(notNull("srgb", srgb).getRed()), linear(srgb.getGreen()), linear(srgb.getBlue()));
  }

  private static float linear(final int component) {
    final double s = component / 255.0;
    return (float) (s <= 0.04045 ? s / 12.92 : Math.pow((s + 0.055) / 1.055, 2.4));
  }

  /**
   * Red.
   *
   * @return the factor, from 0 to 1
   */
  public float getR() {
    return r;
  }

  /**
   * Green.
   *
   * @return the factor, from 0 to 1
   */
  public float getG() {
    return g;
  }

  /**
   * Blue.
   *
   * @return the factor, from 0 to 1
   */
  public float getB() {
    return b;
  }

  /**
   * Whether nothing is reflected.
   *
   * @return true if all three factors are 0
   */
  public boolean isBlack() {
    return r == 0 && g == 0 && b == 0;
  }

  @Override
  public String toString() {
    return "ReflectanceRGB(" + r + ", " + g + ", " + b + ")";
  }
}
