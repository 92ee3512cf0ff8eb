package meshes;

import java.awt.Color;

import materials.Texture;
import models.Appearance;

/**
 * A material of a file: what it says of the colour of facets.
 *
 * @param color its diffuse colour, with the opacity as alpha
 * @param texture what replaces the colour where facets have texture coordinates; null if there is none
 */
record MtlMaterial(Color color, Texture texture) {

  /** What a facet has whose material is not known, or that has none. */
  static final MtlMaterial DEFAULT = new MtlMaterial(new Color(204, 204, 204), null);

  /** What a triangle looks like; where it has no texture coordinates, it has the colour. */
  Appearance appearance() {
    return new Appearance(color, null, texture);
  }
}
