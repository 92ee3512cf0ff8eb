package models;

import static arguments.Arguments.notNull;
import static arguments.Arguments.wrongState;

import java.awt.Color;

import materials.Material;

/**
 * How an object looks: its colour where there is no illumination, and its material where there is. With it a shape has one
 * constructor that does the work, and two that say what it is made of.
 *
 * @param color the colour; null for an object whose parts have theirs
 * @param material the material; null if the object is matte, of its colour
 */
record Appearance(Color color, Material material) {

  /** The appearance of what has neither colour nor material of its own. */
  static final Appearance NONE = new Appearance(null, null);

  static Appearance of(final Color color) {
    return new Appearance(notNull("color", color), null);
  }

  /** The appearance of a material; its colour is the one that stands for it. */
  static Appearance of(final Material material) {
    final Color color = notNull("material", material).getColor();
    if (color == null) {
      throw wrongState("nullResult", material.getClass().getName(), "getColor");
    }
    return new Appearance(color, material);
  }
}
