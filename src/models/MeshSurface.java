package models;

import javax.vecmath.TexCoord2f;

import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/**
 * The geometry that meshes of different appearance share: the tree of the triangles, and their normals and texture
 * coordinates.
 */
final class MeshSurface {

  private final MeshTree tree;
  /** The shading normals; null for a flat mesh. */
  private final CornerNormals normals;
  /** The texture coordinates; null if there are none. */
  private final CornerTexCoords texCoords;

  /** A flat surface. */
  MeshSurface(final MeshArrays arrays) {
    this.tree = new MeshTree(arrays);
    this.normals = null;
    this.texCoords = null;
  }

  /** The surface of data, which are rounded to floats. */
  MeshSurface(final MeshData data) {
    this(data, MeshArrays.rounded(data));
  }

  /** The surface of arrays that were rounded from data. */
  MeshSurface(final MeshData data, final MeshArrays arrays) {
    this.tree = new MeshTree(arrays);
    this.normals = data.normals() == null ? null : new CornerNormals(data, arrays);
    this.texCoords = data.texCoords() == null ? null : new CornerTexCoords(data, arrays);
  }

  MeshTree tree() {
    return tree;
  }

  /** The triangle of a facet; its appearance is without the texture if a corner does not lie in it. */
  Triangle triangle(final int facet, final Appearance appearance) {
    final double[] uv = texCoords == null ? null : texCoords.of(facet);
    final Appearance its = uv == null ? appearance.untextured() : appearance;
    final Triangle triangle = tree.triangle(facet, its.untextured());
    final float[] shading = normals == null ? null : normals.of(facet, triangle);
    return shading == null && uv == null ? triangle : new MeshTriangle(triangle, its, shading, uv);
  }

  /**
   * The hit of a triangle by a ray that is known to hit it. The distance is computed once more, as in a transformed mesh it
   * was rounded on its way through the scene.
   */
  static Hit hit(final Ray ray, final Triangle triangle) {
    final double distance = triangle.distance(ray.startX(), ray.startY(), ray.startZ(),
        ray.directionX(), ray.directionY(), ray.directionZ());
    return triangle instanceof MeshTriangle shaded ? shaded.shadedHitAt(ray, distance) : triangle.hitAt(ray, distance, 0);
  }

  /** The normal that shades a corner, 0, 1 or 2, of a triangle; null if it has none of its own. */
  Vector3D normal(final int facet, final int k) {
    return normals == null ? null : normals.normal(facet, k);
  }

  /** The texture coordinates of a corner, 0, 1 or 2, of a triangle; null if it has none. */
  TexCoord2f texCoord(final int facet, final int k) {
    return texCoords == null ? null : texCoords.pair(facet, k);
  }
}
