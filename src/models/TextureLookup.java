package models;

import static arguments.Arguments.notNull;

import java.util.Optional;

import materials.Texture;
import tracer.Hit;

/**
 * The texel that a textured object has at a hit.
 *
 * @param texture the texture
 * @param column column of the texel, from the left
 * @param row row of the texel, from the top
 * @param argb the texel, sRGB with alpha
 */
public record TextureLookup(Texture texture, int column, int row, int argb) {

  /**
   * Looks up the texture of the object that was hit.
   *
   * @param hit the hit
   * @return the texel; empty if the object has no texture there
   * @throws IllegalArgumentException if the hit is null
   */
  public static Optional<TextureLookup> of(final Hit hit) {
    final Texture texture = notNull("hit", hit).hits() ? hit.getObject().texture() : null;
    final double u = hit.textureU(), v = hit.textureV();
    return texture == null || Double.isNaN(u) || Double.isNaN(v) ? Optional.empty()
        : Optional.of(new TextureLookup(texture, texture.getColumn(u), texture.getRow(v), texture.getARGB(u, v)));
  }
}
