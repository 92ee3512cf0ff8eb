package models;

import javax.vecmath.TexCoord2f;

import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/** What meshes of different appearance share: the tree of the triangles, and what shades and places their corners. */
final class MeshSurface {

  /** Interpolated normals shorter than this have no direction left: the triangle's own counts. */
  private static final double SHORTEST = 1e-6;

  private final MeshTree tree;
  /** What shades the corners; null for a flat mesh. */
  private final CornerNormals normals;
  /** Null for a mesh without texture coordinates. */
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

  /** Whether all corners of a triangle lie in a texture. */
  boolean hasTexCoords(final int facet) {
    return texCoords != null && texCoords.has(facet);
  }

  /**
   * The hit of a triangle by a ray that is known to hit it. The distance is computed once more, as in a transformed mesh it
   * was rounded on its way through the scene.
   */
  Hit hit(final Ray ray, final int facet, final Triangle triangle) {
    final double distance = triangle.distance(ray.startX(), ray.startY(), ray.startZ(),
        ray.directionX(), ray.directionY(), ray.directionZ());
    return shaded(triangle.hitAt(ray, distance, 0), facet, ray, distance);
  }

  /** The normal that shades a corner, 0, 1 or 2, of a triangle; null if it has none of its own. */
  Vector3D normal(final int facet, final int k) {
    return normals == null ? null : normals.normal(facet, k);
  }

  /** The texture coordinates of a corner, 0, 1 or 2, of a triangle; null if it has none. */
  TexCoord2f texCoord(final int facet, final int k) {
    return texCoords == null ? null : texCoords.pair(facet, k);
  }

  /** A hit with what the mesh adds to that of its triangle. */
  private Hit shaded(final Hit flat, final int facet, final Ray ray, final double distance) {
    if (normals == null && texCoords == null || !flat.hits()) {
      return flat;
    }
    final Weights weights = ((Triangle) flat.getObject()).weights(ray, distance);
    final double gx = flat.geometricX(), gy = flat.geometricY(), gz = flat.geometricZ();
    double x = gx, y = gy, z = gz;
    if (normals != null) {
      x = normals.component(facet, 0, weights, gx);
      y = normals.component(facet, 1, weights, gy);
      z = normals.component(facet, 2, weights, gz);
    }
    final boolean hasDirection = x * x + y * y + z * z > SHORTEST * SHORTEST;
    return flat.withShading(hasDirection ? x : gx, hasDirection ? y : gy, hasDirection ? z : gz,
        texCoords == null ? Double.NaN : texCoords.coordinate(facet, 0, weights),
        texCoords == null ? Double.NaN : texCoords.coordinate(facet, 1, weights));
  }
}
