package radiometry;

import static arguments.Arguments.notNegative;
import static arguments.Arguments.wrong;

/**
 * How a power is shared among the channels red, green and blue of linear sRGB: three shares, at least 0, whose sum is 1.
 * Immutable.
 */
public final class SpectrumRGB {

  /** How far the sum of the shares may be from 1: files give them with four digits or more. */
  private static final double TOLERANCE = 1e-4;

  private final float r;
  private final float g;
  private final float b;

  /**
   * The spectrum of three shares. They are divided by their sum, which may differ from 1 by 1e-4.
   *
   * @param r share of red, at least 0
   * @param g share of green, at least 0
   * @param b share of blue, at least 0
   * @throws IllegalArgumentException if a share is negative, infinite or NaN, or if the sum is not 1 within 1e-4
   */
  public SpectrumRGB(final float r, final float g, final float b) {
    this.r = notNegative("r", r);
    this.g = notNegative("g", g);
    this.b = notNegative("b", b);
    if (!(Math.abs(sum() - 1) <= TOLERANCE)) {
      throw wrong("spectrum", this, (float) sum());
    }
  }

  private double sum() {
    return (double) r + g + b;
  }

  /**
   * Shares a power among the channels.
   *
   * @param power the power, at least 0
   * @return in each channel 3 · share · power, so that equal shares give the power in each channel
   * @throws IllegalArgumentException if the power is negative, infinite or NaN
   */
  public RadianceRGB distribute(final double power) {
    final double unit = 3 * notNegative("power", power) / sum();
    return new RadianceRGB(r * unit, g * unit, b * unit);
  }

  @Override
  public String toString() {
    return "SpectrumRGB(" + r + ", " + g + ", " + b + ")";
  }
}
