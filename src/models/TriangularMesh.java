package models;

import static arguments.Arguments.index;
import static arguments.Arguments.notNull;

import java.awt.Color;
import java.util.AbstractList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.atomic.AtomicReferenceArray;

import javax.vecmath.TexCoord2f;

import acceleration.RayTile;
import materials.Material;
import materials.Texture;
import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/**
 * A surface made of triangles.
 *
 * <p><img src="doc-files/TriangularMesh.png" width="320" height="240" alt="A mesh of eight triangles">
 *
 * <p>A mesh is kept as arrays, three floats for each vertex and three vertex numbers for each triangle, with a tree of the
 * triangles' boxes ({@link acceleration.Bvh}); a {@link Triangle} object is made when one is asked for or hit. A closed
 * mesh has no cracks: no ray passes between two triangles that share an edge or a vertex. Facets without area are left out.
 * Each triangle is hit as
 * {@link Triangle} says.
 */
public class TriangularMesh extends Object3D {

  private final MeshSurface surface;
  private final MeshAppearance appearance;
  private final AtomicReference<AtomicReferenceArray<Triangle>> made = new AtomicReference<>();

  /**
   * A mesh of one colour.
   *
   * @param vertices the vertices, by indices of any value
   * @param facetas the facets: each three vertex indices, counter-clockwise, separated by blanks or commas; what follows a
   *     {@code /} in an index is ignored
   * @param color colour of all triangles
   * @throws IllegalArgumentException if an argument or an element of it is null, if a vertex is not finite, if a facet is
   *     not three indices of the map, or if no facet has an area
   */
  public TriangularMesh(final Map<Integer, Point3D> vertices, final List<String> facetas, final Color color) {
    this(FacetParser.arrays(vertices, facetas), Appearance.of(color));
  }

  /**
   * A mesh in which each triangle gets a random colour, the same in every run.
   *
   * @param vertices the vertices, by indices of any value
   * @param facetas the facets: each three vertex indices, counter-clockwise, separated by blanks or commas; what follows a
   *     {@code /} in an index is ignored
   * @throws IllegalArgumentException if an argument or an element of it is null, if a vertex is not finite, if a facet is
   *     not three indices of the map, or if no facet has an area
   */
  public TriangularMesh(final Map<Integer, Point3D> vertices, final List<String> facetas) {
    this(FacetParser.arrays(vertices, facetas), null);
  }

  /**
   * A flat mesh of a material.
   *
   * @param vertices the vertices, by indices of any value
   * @param facetas the facets, as in {@link #TriangularMesh(Map, List, Color)}
   * @param material material of all triangles
   * @throws IllegalArgumentException as {@link #TriangularMesh(Map, List, Color)} does
   */
  public TriangularMesh(final Map<Integer, Point3D> vertices, final List<String> facetas, final Material material) {
    this(FacetParser.arrays(vertices, facetas), Appearance.of(material));
  }

  /**
   * A smooth mesh of one colour: its normals are interpolated between those of the corners.
   *
   * @param vertices the vertices, by indices of any value
   * @param normals normals, of any length but 0, by indices of any value; perhaps none at all
   * @param facetas the facets: each three corners, counter-clockwise, separated by blanks or commas; a corner is {@code v}
   *     or {@code v//n} or {@code v/t/n}, indices of a vertex and of its normal (t is ignored). Without n it has the average
   * of
   *     the triangles around its vertex, weighted by their areas
   * @param color colour of all triangles
   * @throws IllegalArgumentException if an argument or an element of it is null, if a vertex or a normal is not finite, if a
   *     normal is zero, if a facet is not three corners of indices of the maps, or if no facet has an area
   */
  public TriangularMesh(final Map<Integer, Point3D> vertices, final Map<Integer, Vector3D> normals,
      final List<String> facetas, final Color color) {
    this(FacetParser.smooth(vertices, normals, null, facetas), Appearance.of(color));
  }

  /**
   * A smooth mesh of a material.
   *
   * @param vertices the vertices
   * @param normals normals
   * @param facetas the facets, as in {@link #TriangularMesh(Map, Map, List, Color)}
   * @param material material of all triangles
   * @throws IllegalArgumentException as {@link #TriangularMesh(Map, Map, List, Color)} does
   */
  public TriangularMesh(final Map<Integer, Point3D> vertices, final Map<Integer, Vector3D> normals,
      final List<String> facetas, final Material material) {
    this(FacetParser.smooth(vertices, normals, null, facetas), Appearance.of(material));
  }

  /**
   * A smooth mesh with a texture.
   *
   * @param vertices the vertices
   * @param normals normals, as in {@link #TriangularMesh(Map, Map, List, Color)}
   * @param uv texture coordinates, by indices of any value
   * @param facetas the facets: each three corners {@code v/t} or {@code v/t/n}, where t is the index of texture coordinates
   * @param texture the texture
   * @throws IllegalArgumentException as {@link #TriangularMesh(Map, Map, List, Color)} does, if a texture coordinate is not
   *     finite, or if a corner has none
   */
  public TriangularMesh(final Map<Integer, Point3D> vertices, final Map<Integer, Vector3D> normals,
      final Map<Integer, TexCoord2f> uv, final List<String> facetas, final Texture texture) {
    this(FacetParser.textured(vertices, normals, notNull("uv", uv), facetas), Appearance.of(texture));
  }

  /**
   * A smooth mesh of one colour whose hits have texture coordinates, where all three corners have them: for a pattern of
   * one's own.
   *
   * @param vertices the vertices
   * @param normals normals, as in {@link #TriangularMesh(Map, Map, List, Color)}
   * @param uv texture coordinates, by indices of any value
   * @param facetas the facets: each three corners {@code v}, {@code v/t}, {@code v//n} or {@code v/t/n}
   * @param color colour of all triangles
   * @throws IllegalArgumentException as {@link #TriangularMesh(Map, Map, List, Color)} does, and if a texture coordinate is
   *     not finite
   */
  public TriangularMesh(final Map<Integer, Point3D> vertices, final Map<Integer, Vector3D> normals,
      final Map<Integer, TexCoord2f> uv, final List<String> facetas, final Color color) {
    this(FacetParser.smooth(vertices, normals, notNull("uv", uv), facetas), Appearance.of(color));
  }

  /**
   * A smooth mesh of a material whose hits have texture coordinates, where all three corners have them.
   *
   * @param vertices the vertices
   * @param normals normals, as in {@link #TriangularMesh(Map, Map, List, Color)}
   * @param uv texture coordinates, by indices of any value
   * @param facetas the facets: each three corners {@code v}, {@code v/t}, {@code v//n} or {@code v/t/n}
   * @param material material of all triangles
   * @throws IllegalArgumentException as {@link #TriangularMesh(Map, Map, Map, List, Color)} does
   */
  public TriangularMesh(final Map<Integer, Point3D> vertices, final Map<Integer, Vector3D> normals,
      final Map<Integer, TexCoord2f> uv, final List<String> facetas, final Material material) {
    this(FacetParser.smooth(vertices, normals, notNull("uv", uv), facetas), Appearance.of(material));
  }

  /** A flat mesh; null: random colours. */
  private TriangularMesh(final MeshArrays arrays, final Appearance appearance) {
    this(new MeshSurface(arrays), MeshAppearance.of(appearance));
  }

  private TriangularMesh(final MeshData data, final Appearance appearance) {
    this(new MeshSurface(data, MeshArrays.rounded(data)), MeshAppearance.of(appearance));
  }

  private TriangularMesh(final MeshSurface surface, final MeshAppearance appearance) {
    super();
    this.surface = surface;
    this.appearance = appearance;
  }

  /**
   * A mesh of arrays, which are copied: for whoever has many triangles, such as a reader of files.
   *
   * @param coordinates x, y and z of each vertex
   * @param corners numbers of the three vertices of each triangle, from 0, counter-clockwise
   * @param color colour of all triangles; null for random ones
   * @return the mesh
   * @throws IllegalArgumentException if an array is null or its length no multiple of 3, if a coordinate is not finite, if a
   *     corner names no vertex, or if no triangle has an area
   */
  public static TriangularMesh of(final float[] coordinates, final int[] corners, final Color color) {
    notNull("coordinates", coordinates);
    return new TriangularMesh(MeshArrays.checked(coordinates, "corners", notNull("corners", corners)),
        color == null ? null : Appearance.of(color));
  }

  /**
   * A mesh of arrays in double precision, perhaps with normals that shade it and with texture coordinates.
   *
   * @param data the arrays; what of them rounding to floats leaves without area is left out
   * @param appearance what all triangles look like; one with a corner without texture coordinates has the mean colour of a
   *     texture
   * @return the mesh
   * @throws IllegalArgumentException if an argument is null, if the length of an array is no multiple of 3, if a coordinate
   *     is not finite as a float, if a corner names no vertex, or if no triangle has an area
   */
  public static TriangularMesh of(final MeshData data, final Appearance appearance) {
    return new TriangularMesh(notNull("data", data), notNull("appearance", appearance));
  }

  /**
   * A mesh whose triangles look different from each other.
   *
   * @param data the arrays, as in {@link #of(MeshData, Appearance)}
   * @param appearances what triangles look like
   * @param ofTriangle for each triangle of the arrays the number of its appearance, from 0
   * @return the mesh
   * @throws IllegalArgumentException as {@link #of(MeshData, Appearance)} does, and if a number names no appearance
   */
  public static TriangularMesh of(final MeshData data, final List<Appearance> appearances, final int[] ofTriangle) {
    index("ofTriangle.length", notNull("ofTriangle", ofTriangle).length + 1, notNull("data", data).corners().length / 3);
    for (int i = 0; i < ofTriangle.length; i++) {
      index("ofTriangle[" + i + "]", notNull("appearances", appearances).size(), ofTriangle[i]);
    }
    final MeshArrays arrays = MeshArrays.rounded(data);
    return new TriangularMesh(new MeshSurface(data, arrays), MeshAppearance.of(appearances, ofTriangle, arrays));
  }

  /**
   * The same mesh with another appearance: both share their geometry.
   *
   * @param other what all triangles look like
   * @return the mesh
   * @throws IllegalArgumentException if the appearance is null
   */
  public TriangularMesh with(final Appearance other) {
    return new TriangularMesh(surface, MeshAppearance.of(notNull("other", other)));
  }

  /**
   * Colour of the mesh.
   *
   * @return the colour, of a texture its mean; null if each triangle has one of its own
   */
  @Override
  public Color getColor() {
    return appearance.common() == null ? null : appearance.common().color();
  }

  @Override
  public Material getMaterial() {
    return appearance.common() == null ? null : appearance.common().material();
  }

  /** What is painted is the triangle that was hit. */
  @Override
  public Color getColorAt(final Hit hit) {
    return notNull("hit", hit).getObject() instanceof MeshTriangle triangle ? triangle.getColorAt(hit) : getColor();
  }

  @Override
  boolean isTextured() {
    return appearance.isTextured();
  }

  @Override
  public Hit intersectionWith(final Ray ray) {
    final MeshRay query = new MeshRay(notNull("ray", ray), surface.tree());
    return query.hits() ? hitAt(ray, query.distance(), query.facet()) : Hit.NOHIT;
  }

  /** Computes the distance once more: in a transformed mesh the given one was rounded on its way through the scene. */
  @Override
  Hit hitAt(final Ray ray, final double t, final int part) {
    final Triangle triangle = triangle(part);
    final double distance = triangle.distance(ray.startX(), ray.startY(), ray.startZ(),
        ray.directionX(), ray.directionY(), ray.directionZ());
    return surface.shaded(triangle.hitAt(ray, distance, 0), part, ray, distance);
  }

  @Override
  boolean intersectsBefore(final Ray ray, final double tmax) {
    return MeshRay.hitsBefore(ray, tmax, surface.tree());
  }

  @Override
  void block(final ShadowTile tile) {
    new MeshShadow(tile, surface.tree()).findBlocked();
  }

  @Override
  int cost(final Ray ray) {
    return MeshRay.cost(ray, surface.tree());
  }

  @Override
  boolean answersTiles() {
    return true;
  }

  @Override
  void closestHits(final RayTile rays, final TileHits hits) {
    new MeshTile(rays, hits, this, surface.tree()).findHits();
  }

  @Override
  int argb(final int part) {
    return appearance.argb(part);
  }

  @Override
  public BoundingBox getBoundingBox() {
    return surface.tree().box();
  }

  /**
   * The triangles of the mesh, in the order of its facets, without those that have no area. Each is made when it is first
   * asked for.
   *
   * @return a list that cannot be changed
   */
  public List<Triangle> getTriangles() {
    return new AbstractList<>() {
      @Override
      public Triangle get(final int index) {
        return triangle(Objects.checkIndex(index, size()));
      }

      @Override
      public int size() {
        return surface.tree().size();
      }
    };
  }

  /** The triangle of a facet: always the same object. */
  private Triangle triangle(final int facet) {
    AtomicReferenceArray<Triangle> triangles = made.get();
    if (triangles == null) {
      made.compareAndSet(null, new AtomicReferenceArray<>(surface.tree().size()));
      triangles = made.get();
    }
    final Triangle known = triangles.get(facet);
    if (known != null) {
      return known;
    }
    triangles.compareAndSet(facet, null, surface.tree().triangle(facet, appearanceOf(facet)));
    return triangles.get(facet);
  }

  /** The appearance of a triangle, without the texture if a corner does not lie in it. */
  private Appearance appearanceOf(final int facet) {
    final Appearance its = appearance.of(facet);
    return surface.hasTexCoords(facet) ? its : its.untextured();
  }

  @Override
  public String toString() {
    return "TriangularMesh(" + surface.tree().size() + " triangles)";
  }
}
