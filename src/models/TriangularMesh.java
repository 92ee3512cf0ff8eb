package models;

import static arguments.Arguments.index;
import static arguments.Arguments.notNull;

import java.awt.Color;
import java.util.List;
import java.util.Map;

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
 * <p>A mesh is kept as arrays, three floats for each vertex and three vertex numbers for each triangle, with a tree of
 * the triangles' boxes ({@link acceleration.Bvh}); a {@link Triangle} object is created when it is requested or hit. A
 * closed mesh has no cracks: no ray passes between two triangles that share an edge or a vertex. Each triangle is hit as
 * {@link Triangle} describes.
 *
 * <p>Constructors take a facet as a string of three corners, counter-clockwise, separated by blanks or commas. A corner is
 * {@code v}, {@code v/t}, {@code v//n} or {@code v/t/n}: indices of a vertex, of texture coordinates and of a normal, which
 * are keys, of any value, of the maps beside. Flat meshes ignore t and n. On smooth ones a corner without n has the average
 * of the triangles around its vertex, weighted by their areas. Facets without area are left out.
 */
public class TriangularMesh extends Object3D {

  private final MeshSurface surface;
  private final MeshAppearance appearance;
  private final MeshTriangles triangles;

  /**
   * A flat mesh of one colour.
   *
   * @param vertices the vertices
   * @param facetas the facets
   * @param color colour of all triangles
   * @throws IllegalArgumentException if an argument or an element of it is null, if a vertex is not finite, if a facet is
   *     not three indices of the map, or if no facet has an area
   */
  public TriangularMesh(final Map<Integer, Point3D> vertices, final List<String> facetas, final Color color) {
    this(new MeshSurface(FacetParser.arrays(vertices, facetas)), Appearance.of(color));
  }

  /**
   * A flat mesh in which each triangle gets a random colour, the same in every run.
   *
   * @param vertices the vertices
   * @param facetas the facets
   * @throws IllegalArgumentException as {@link #TriangularMesh(Map, List, Color)} does
   */
  public TriangularMesh(final Map<Integer, Point3D> vertices, final List<String> facetas) {
    this(new MeshSurface(FacetParser.arrays(vertices, facetas)), (Appearance) null);
  }

  /**
   * A flat mesh of a material.
   *
   * @param vertices the vertices
   * @param facetas the facets
   * @param material material of all triangles
   * @throws IllegalArgumentException as {@link #TriangularMesh(Map, List, Color)} does
   */
  public TriangularMesh(final Map<Integer, Point3D> vertices, final List<String> facetas, final Material material) {
    this(new MeshSurface(FacetParser.arrays(vertices, facetas)), Appearance.of(material));
  }

  /**
   * A smooth mesh of one colour: its normals are interpolated between those of the corners.
   *
   * @param vertices the vertices
   * @param normals normals, of any length but 0; perhaps none at all
   * @param facetas the facets, of which t is ignored
   * @param color colour of all triangles
   * @throws IllegalArgumentException if an argument or an element of it is null, if a vertex or a normal is not finite, if a
   *     normal is zero, if a facet is not three corners of indices of the maps, or if no facet has an area
   */
  public TriangularMesh(final Map<Integer, Point3D> vertices, final Map<Integer, Vector3D> normals,
      final List<String> facetas, final Color color) {
    this(new MeshSurface(FacetParser.smooth(vertices, normals, null, facetas)), Appearance.of(color));
  }

  /**
   * A smooth mesh of a material.
   *
   * @param vertices the vertices
   * @param normals normals
   * @param facetas the facets, of which t is ignored
   * @param material material of all triangles
   * @throws IllegalArgumentException as {@link #TriangularMesh(Map, Map, List, Color)} does
   */
  public TriangularMesh(final Map<Integer, Point3D> vertices, final Map<Integer, Vector3D> normals,
      final List<String> facetas, final Material material) {
    this(new MeshSurface(FacetParser.smooth(vertices, normals, null, facetas)), Appearance.of(material));
  }

  /**
   * A smooth mesh with a texture.
   *
   * @param vertices the vertices
   * @param normals normals
   * @param uv texture coordinates
   * @param facetas the facets, each corner with t
   * @param texture the texture
   * @throws IllegalArgumentException as {@link #TriangularMesh(Map, Map, Map, List, Color)} does, and if a corner has no t
   */
  public TriangularMesh(final Map<Integer, Point3D> vertices, final Map<Integer, Vector3D> normals,
      final Map<Integer, TexCoord2f> uv, final List<String> facetas, final Texture texture) {
    this(new MeshSurface(FacetParser.textured(vertices, normals, notNull("uv", uv), facetas)), Appearance.of(texture));
  }

  /**
   * A smooth mesh of one colour whose hits have texture coordinates, where all three corners have them.
   *
   * @param vertices the vertices
   * @param normals normals
   * @param uv texture coordinates
   * @param facetas the facets
   * @param color colour of all triangles
   * @throws IllegalArgumentException as {@link #TriangularMesh(Map, Map, List, Color)} does, for texture coordinates too
   */
  public TriangularMesh(final Map<Integer, Point3D> vertices, final Map<Integer, Vector3D> normals,
      final Map<Integer, TexCoord2f> uv, final List<String> facetas, final Color color) {
    this(new MeshSurface(FacetParser.smooth(vertices, normals, notNull("uv", uv), facetas)), Appearance.of(color));
  }

  /**
   * A smooth mesh of a material whose hits have texture coordinates, where all three corners have them.
   *
   * @param vertices the vertices
   * @param normals normals
   * @param uv texture coordinates
   * @param facetas the facets
   * @param material material of all triangles
   * @throws IllegalArgumentException as {@link #TriangularMesh(Map, Map, Map, List, Color)} does
   */
  public TriangularMesh(final Map<Integer, Point3D> vertices, final Map<Integer, Vector3D> normals,
      final Map<Integer, TexCoord2f> uv, final List<String> facetas, final Material material) {
    this(new MeshSurface(FacetParser.smooth(vertices, normals, notNull("uv", uv), facetas)), Appearance.of(material));
  }

  /** A mesh of one appearance; null: random colours. */
  private TriangularMesh(final MeshSurface surface, final Appearance appearance) {
    this(surface, MeshAppearance.of(appearance));
  }

  private TriangularMesh(final MeshSurface surface, final MeshAppearance appearance) {
    super();
    this.surface = surface;
    this.appearance = appearance;
    this.triangles = new MeshTriangles(surface, appearance);
  }

  /**
   * A mesh of arrays, which are copied: for sources of many triangles, such as readers of files.
   *
   * @param coordinates x, y and z of each vertex
   * @param corners numbers of the three vertices of each triangle, from 0, counter-clockwise
   * @param color colour of all triangles; null for random ones
   * @return the mesh
   * @throws IllegalArgumentException as {@link #of(MeshData, Appearance)} does
   */
  public static TriangularMesh of(final float[] coordinates, final int[] corners, final Color color) {
    notNull("coordinates", coordinates);
    return new TriangularMesh(new MeshSurface(MeshArrays.checked(coordinates, "corners", notNull("corners", corners))),
        color == null ? null : Appearance.of(color));
  }

  /**
   * A mesh of arrays in double precision, perhaps with normals that shade it and with texture coordinates.
   *
   * @param data the arrays; triangles that have no area in floats are left out
   * @param appearance what all triangles look like; those with a corner outside of a texture have its mean colour
   * @return the mesh
   * @throws IllegalArgumentException if an argument is null, if the length of an array is no multiple of 3, if a coordinate
   *     is not finite as a float, if a corner names no vertex, or if no triangle has an area
   */
  public static TriangularMesh of(final MeshData data, final Appearance appearance) {
    return new TriangularMesh(new MeshSurface(notNull("data", data)), notNull("appearance", appearance));
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
    final MeshArrays arrays = MeshArrays.rounded(data);
    return new TriangularMesh(new MeshSurface(data, arrays),
        MeshAppearance.of(notNull("appearances", appearances), ofTriangle, arrays));
  }

  /**
   * The same mesh with another appearance, sharing the geometry.
   *
   * @param other what all triangles look like
   * @return the mesh
   * @throws IllegalArgumentException if the appearance is null
   */
  public TriangularMesh with(final Appearance other) {
    return new TriangularMesh(surface, notNull("other", other));
  }

  /** The colour of all triangles, of a texture its mean; null if each has one of its own. */
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

  @Override
  Hit hitAt(final Ray ray, final double t, final int part) {
    return MeshSurface.hit(ray, triangles.of(part));
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
  boolean hasPartColors() {
    return appearance.common() == null;
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
   * The triangles of the mesh, in the order of its facets, without those that have no area.
   *
   * @return a list that cannot be changed
   */
  public List<Triangle> getTriangles() {
    return triangles;
  }

  @Override
  public String toString() {
    return "TriangularMesh(" + surface.tree().size() + " triangles)";
  }
}
