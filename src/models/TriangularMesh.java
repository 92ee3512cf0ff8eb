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

import acceleration.RayTile;
import materials.Material;
import primitives.BoundingBox;
import primitives.Point3D;
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
 * Each triangle is met as {@link Triangle} says.
 */
public class TriangularMesh extends Object3D {

  /** Interpolated normals shorter than this have no direction left: the triangle's own counts. */
  private static final double SHORTEST = 1e-6;

  private final MeshTree tree;
  /** What shades the corners; null for a flat mesh. */
  private final CornerNormals normals;
  /** Null for a mesh without texture coordinates. */
  private final CornerTexCoords texCoords;
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

  /** A flat mesh; null: random colours. */
  private TriangularMesh(final MeshArrays arrays, final Appearance appearance) {
    super();
    this.tree = new MeshTree(arrays);
    this.normals = null;
    this.texCoords = null;
    this.appearance = MeshAppearance.of(appearance);
  }

  private TriangularMesh(final MeshData data, final MeshArrays arrays, final MeshAppearance appearance) {
    super();
    this.tree = new MeshTree(arrays);
    this.normals = data.normals() == null ? null : new CornerNormals(data, arrays);
    this.texCoords = data.texCoords() == null ? null : new CornerTexCoords(data, arrays);
    this.appearance = appearance;
  }

  private TriangularMesh(final TriangularMesh mesh, final MeshAppearance appearance) {
    super();
    this.tree = mesh.tree;
    this.normals = mesh.normals;
    this.texCoords = mesh.texCoords;
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
    return new TriangularMesh(notNull("data", data), MeshArrays.rounded(data),
        MeshAppearance.of(notNull("appearance", appearance)));
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
    return new TriangularMesh(data, arrays, MeshAppearance.of(appearances, ofTriangle, arrays));
  }

  /**
   * The same mesh with another appearance: both share their geometry.
   *
   * @param other what all triangles look like
   * @return the mesh
   * @throws IllegalArgumentException if the appearance is null
   */
  public TriangularMesh with(final Appearance other) {
    return new TriangularMesh(this, MeshAppearance.of(notNull("other", other)));
  }

  /**
   * Whether triangles have texture coordinates.
   *
   * @return true if at least one may have them
   */
  public boolean hasTexCoords() {
    return texCoords != null;
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
    final MeshRay query = new MeshRay(notNull("ray", ray), tree);
    return query.hits() ? hitAt(ray, query.distance(), query.facet()) : Hit.NOHIT;
  }

  /** Computes the distance once more: in a transformed mesh the given one was rounded on its way through the scene. */
  @Override
  Hit hitAt(final Ray ray, final double t, final int part) {
    final Triangle triangle = triangle(part);
    final double distance = triangle.distance(ray.startX(), ray.startY(), ray.startZ(),
        ray.directionX(), ray.directionY(), ray.directionZ());
    final Hit flat = triangle.hitAt(ray, distance, 0);
    return normals == null && texCoords == null || !flat.hits() ? flat
        : shaded(flat, part, triangle.weights(ray, distance));
  }

  private Hit shaded(final Hit flat, final int facet, final Weights weights) {
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

  @Override
  boolean intersectsBefore(final Ray ray, final double tmax) {
    return MeshRay.hitsBefore(ray, tmax, tree);
  }

  @Override
  int cost(final Ray ray) {
    return MeshRay.cost(ray, tree);
  }

  @Override
  boolean answersTiles() {
    return true;
  }

  @Override
  void closestHits(final RayTile rays, final TileHits hits) {
    new MeshTile(rays, hits, this, tree).findHits();
  }

  @Override
  int argb(final int part) {
    return appearance.argb(part);
  }

  @Override
  public BoundingBox getBoundingBox() {
    return tree.box();
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
        return tree.size();
      }
    };
  }

  /** The triangle of a facet: always the same object. */
  private Triangle triangle(final int facet) {
    AtomicReferenceArray<Triangle> triangles = made.get();
    if (triangles == null) {
      made.compareAndSet(null, new AtomicReferenceArray<>(tree.size()));
      triangles = made.get();
    }
    final Triangle known = triangles.get(facet);
    if (known != null) {
      return known;
    }
    triangles.compareAndSet(facet, null, tree.triangle(facet, appearanceOf(facet)));
    return triangles.get(facet);
  }

  /** The appearance of a triangle, without the texture if a corner does not lie in it. */
  private Appearance appearanceOf(final int facet) {
    final Appearance its = appearance.of(facet);
    return texCoords != null && texCoords.has(facet) ? its : its.untextured();
  }

  @Override
  public String toString() {
    return "TriangularMesh(" + tree.size() + " triangles)";
  }
}
