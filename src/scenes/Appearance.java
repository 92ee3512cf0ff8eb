package scenes;

import java.awt.Color;

import materials.Material;

/**
 * What an object of a scene looks like.
 *
 * @param color its colour; of a material, the one that stands for it
 * @param material its material; null if it has none: then it is matte, where there is illumination
 */
record Appearance(Color color, Material material) {

  static Appearance of(final Color color) {
    return new Appearance(color, null);
  }

  static Appearance of(final Material material) {
    return new Appearance(material.getColor(), material);
  }

  boolean isMaterial() {
    return material != null;
  }
}
