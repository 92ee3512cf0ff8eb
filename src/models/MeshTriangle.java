package models;

import java.awt.Color;

import materials.Texture;
import tracer.Hit;
import tracer.Ray;

/** A triangle of a mesh that is smooth or has a texture. What shades it lies with it, where hits need it. */
final class MeshTriangle extends Triangle {

  /** Interpolated normals shorter than this have no direction left: the triangle's own counts. */
  private static final double SHORTEST = 1e-6;

  private final float nax;
  private final float nay;
  private final float naz;
  private final float nbx;
  private final float nby;
  private final float nbz;
  private final float ncx;
  private final float ncy;
  private final float ncz;
  private final boolean isSmooth;
  private final Texture texture;
  /** u and v of each corner; null if one has none. */
  private final double[] texCoords;

  /**
   * A triangle of a mesh.
   *
   * @param triangle the same without what its mesh adds
   * @param appearance what it looks like; with a texture, its colour is the mean of the texels
   * @param normals three components of the unit normal of each corner; null for the triangle's own
   * @param texCoords u and v of each corner; null if there are none
   */
  MeshTriangle(final Triangle triangle, final Appearance appearance, final float[] normals, final double[] texCoords) {
    super(triangle, appearance.texture() == null ? appearance
        : new Appearance(appearance.texture().getMeanColor(), appearance.material()));
    final float[] n = normals == null ? new float[3 * 3] : normals;
    this.isSmooth = normals != null;
    this.nax = n[0];
    this.nay = n[1];
    this.naz = n[2];
    this.nbx = n[3];
    this.nby = n[4];
    this.nbz = n[5];
    this.ncx = n[6];
    this.ncy = n[7];
    this.ncz = n[8];
    this.texture = appearance.texture();
    this.texCoords = texCoords;
  }

  /** The hit of the mesh at a distance: that of the triangle, shaded by the corners. */
  Hit shadedHitAt(final Ray ray, final double t) {
    final Weights weights = weights(ray, t);
    final double a = weights.a(), b = weights.b(), c = weights.c();
    final double nx = a * nax + b * nbx + c * ncx, ny = a * nay + b * nby + c * ncy, nz = a * naz + b * nbz + c * ncz;
    final boolean hasDirection = isSmooth && nx * nx + ny * ny + nz * nz > SHORTEST * SHORTEST;
    final boolean isTextured = texCoords != null;
    return hitAt(ray, t, hasDirection ? nx : normalX(), hasDirection ? ny : normalY(), hasDirection ? nz : normalZ(),
        isTextured ? a * texCoords[0] + b * texCoords[2] + c * texCoords[4] : Double.NaN,
        isTextured ? a * texCoords[1] + b * texCoords[3] + c * texCoords[5] : Double.NaN);
  }

  /** The texel of the hit; the mean colour if the triangle was hit by itself, without its mesh. */
  @Override
  public Color getColorAt(final Hit hit) {
    return texture == null || Double.isNaN(hit.textureU()) ? getColor() : texture.getColor(hit.textureU(), hit.textureV());
  }

  @Override
  Texture texture() {
    return texture;
  }

  @Override
  boolean isTextured() {
    return texture != null;
  }
}
