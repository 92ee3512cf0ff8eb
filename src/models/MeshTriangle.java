package models;

import java.awt.Color;

import materials.Texture;
import tracer.Hit;

/** A triangle of a mesh that has a texture. */
final class MeshTriangle extends Triangle {

  private final Texture texture;

  MeshTriangle(final double[] coordinates, final int a, final int b, final int c, final Appearance appearance) {
    super(coordinates, a, b, c, new Appearance(appearance.texture().getMeanColor(), appearance.material()));
    this.texture = appearance.texture();
  }

  /** The texel of the hit; the mean colour if the triangle was hit by itself, without its mesh. */
  @Override
  public Color getColorAt(final Hit hit) {
    return Double.isNaN(hit.textureU()) ? getColor() : texture.getColor(hit.textureU(), hit.textureV());
  }

  @Override
  Texture texture() {
    return texture;
  }

  @Override
  boolean isTextured() {
    return true;
  }
}
