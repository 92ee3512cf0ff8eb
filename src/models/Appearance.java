package models;

import static arguments.Arguments.notNull;
import static arguments.Arguments.wrongState;

import java.awt.Color;
import java.util.Objects;

import materials.Material;
import materials.Texture;

/**
 * How an object looks: its colour or its texture where there is no illumination, and its material where there is. So each
 * shape has one constructor that does the work, and others that wrap a colour or a material.
 *
 * @param color the colour, or the mean of a texture; null for an object whose parts have colours of their own
 * @param material the material; null if the object is matte, of its colour at each point
 * @param texture the texture; null if the object has one colour everywhere
 */
public record Appearance(Color color, Material material, Texture texture) {

  /** The appearance of an object with neither colour nor material of its own. */
  static final Appearance NONE = new Appearance(null, null, null);

  /** An appearance without texture. */
  Appearance(final Color color, final Material material) {
    this(color, material, null);
  }

  /**
   * The appearance of a colour.
   *
   * @param color the colour
   * @return the appearance
   * @throws IllegalArgumentException if the colour is null
   */
  public static Appearance of(final Color color) {
    return new Appearance(notNull("color", color), null);
  }

  /**
   * The appearance of a material, in the colour that it has without illumination.
   *
   * @param material the material
   * @return the appearance
   * @throws IllegalArgumentException if the material is null
   */
  public static Appearance of(final Material material) {
    final Color color = notNull("material", material).getColor();
    if (color == null) {
      throw wrongState("nullResult", material.getClass().getName(), "getColor");
    }
    return new Appearance(color, material);
  }

  /**
   * The appearance of a texture; its colour is the mean of the texels.
   *
   * @param texture the texture
   * @return the appearance
   * @throws IllegalArgumentException if the texture is null
   */
  public static Appearance of(final Texture texture) {
    return new Appearance(notNull("texture", texture).getMeanColor(), null, texture);
  }

  /**
   * Whether there is a material.
   *
   * @return false if the object is matte
   */
  public boolean isMaterial() {
    return material != null;
  }

  /** The equality of records, without the method handles that would be linked for it whenever the program starts. */
  @Override
  public boolean equals(final Object other) {
    return other instanceof Appearance same && Objects.equals(color, same.color)
        && Objects.equals(material, same.material) && Objects.equals(texture, same.texture);
  }

  @Override
  public int hashCode() {
    return Objects.hash(color, material, texture);
  }

  /** The same without texture. */
  Appearance untextured() {
    return texture == null ? this : new Appearance(color, material);
  }
}
