package materials;

import static arguments.Arguments.notNull;
import static arguments.Arguments.within;

import java.awt.Color;
import java.awt.image.BufferedImage;

/**
 * An image that colours a surface by its coordinates (u, v): u to the right, v upwards, (0, 0) the lower left corner of
 * the image, which repeats in both directions. Lookups return the nearest texel, without filtering. Immutable.
 *
 * <p>Texels are sRGB of 8 bits with alpha, as they are stored: a grey g is (g, g, g), 16 bits are rounded to 8, palettes are
 * resolved, and colour profiles ignored.
 */
public final class Texture {

  private final int width;
  private final int height;
  private final int[] texels;
  private final Color mean;

  /**
   * The texture of an image.
   *
   * @param image the image, which is copied
   * @throws IllegalArgumentException if it is null
   */
  public Texture(final BufferedImage image) {
    this.width = notNull("image", image).getWidth();
    this.height = image.getHeight();
    this.texels = new StoredTexels(image).read();
    this.mean = new Color(mean(16), mean(8), mean(0), mean(24));
  }

  private Texture(final Texture texture, final double opacity) {
    this.width = texture.width;
    this.height = texture.height;
    this.texels = texture.texels.clone();
    for (int i = 0; i < texels.length; i++) {
      texels[i] = texels[i] & 0xFFFFFF | (int) Math.floor((texels[i] >>> 24) * opacity + 0.5) << 24;
    }
    this.mean = new Color(mean(16), mean(8), mean(0), mean(24));
  }

  /**
   * The texture with reduced opacity.
   *
   * @param opacity factor of the alpha of each texel, from 0 to 1
   * @return the texture, its alpha rounded
   * @throws IllegalArgumentException if the opacity is out of range
   */
  public Texture withOpacity(final double opacity) {
    return new Texture(this, within("opacity", 0.0, 1.0, opacity));
  }

  private int mean(final int shift) {
    long sum = 0;
    for (final int texel : texels) {
      sum += texel >>> shift & 0xFF;
    }
    return (int) ((2 * sum + texels.length) / (2L * texels.length));
  }

  /**
   * The texel at texture coordinates.
   *
   * @param u first coordinate, to the right; its integer part is without effect
   * @param v second coordinate, upwards
   * @return its colour
   */
  public Color getColor(final double u, final double v) {
    return new Color(getARGB(u, v), true);
  }

  /**
   * The texel at texture coordinates as a number, for renderers.
   *
   * @param u first coordinate, to the right; its integer part is without effect
   * @param v second coordinate, upwards
   * @return sRGB with alpha in the highest byte
   */
  public int getARGB(final double u, final double v) {
    return texels[getRow(v) * width + getColumn(u)];
  }

  /**
   * The column of the texel at a place.
   *
   * @param u first coordinate, to the right; its integer part is without effect
   * @return 0 … width − 1, from the left
   */
  public int getColumn(final double u) {
    return index(u, width);
  }

  /**
   * The row of the texel at a place.
   *
   * @param v second coordinate, upwards; its integer part is without effect
   * @return 0 … height − 1, from the top
   */
  public int getRow(final double v) {
    return height - 1 - index(v, height);
  }

  /** The index of a coordinate among the texels of a row or column; the fraction of a tiny negative number rounds to 1. */
  private static int index(final double coordinate, final int count) {
    return Math.min(count - 1, (int) ((coordinate - Math.floor(coordinate)) * count));
  }

  /**
   * The mean colour of the image.
   *
   * @return each channel's mean over all texels, alpha too, rounded
   */
  public Color getMeanColor() {
    return mean;
  }

  /**
   * Width of the image.
   *
   * @return number of columns
   */
  public int getWidth() {
    return width;
  }

  /**
   * Height of the image.
   *
   * @return number of rows
   */
  public int getHeight() {
    return height;
  }

  @Override
  public String toString() {
    return "Texture(" + width + " x " + height + ")";
  }
}
