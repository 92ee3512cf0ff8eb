package meshes;

import java.awt.Color;

import materials.Texture;
import models.Appearance;

/**
 * A material of a file, as far as it concerns the colour of facets.
 *
 * @param color its diffuse colour, with the opacity as alpha
 * @param texture texture in place of the colour where facets have texture coordinates; null if none
 */
record MtlMaterial(Color color, Texture texture) {

  /** The material of facets that have none, or an unknown one. */
  static final MtlMaterial DEFAULT = new MtlMaterial(new Color(204, 204, 204), null);

  /** The appearance of a triangle; without texture coordinates it has the colour. */
  Appearance appearance() {
    return new Appearance(color, null, texture);
  }
}
