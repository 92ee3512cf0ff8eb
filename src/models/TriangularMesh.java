package models;

import static arguments.Arguments.notNull;

import java.awt.Color;
import java.util.AbstractList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.atomic.AtomicReferenceArray;

import acceleration.RayTile;
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

  private final Color color;
  private final MeshTree tree;
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
    this(FacetParser.arrays(vertices, facetas), notNull("color", color));
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

  private TriangularMesh(final MeshArrays arrays, final Color color) {
    super();
    this.color = color;
    this.tree = new MeshTree(arrays);
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
    return new TriangularMesh(MeshArrays.checked(coordinates, "corners", notNull("corners", corners)), color);
  }

  /**
   * Colour of the mesh.
   *
   * @return the colour; null if each triangle has one of its own
   */
  @Override
  public Color getColor() {
    return color;
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
    return triangle.hitAt(ray, triangle.distance(ray.startX(), ray.startY(), ray.startZ(),
        ray.directionX(), ray.directionY(), ray.directionZ()), 0);
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
    return colorOf(part).getRGB();
  }

  /** A colour that depends on the number of the triangle only; the mixing is that of SplittableRandom's seed. */
  private Color colorOf(final int facet) {
    return color != null ? color : new Color(new SplittableRandom(facet).nextInt(1 << 24));
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
    triangles.compareAndSet(facet, null, tree.triangle(facet, colorOf(facet)));
    return triangles.get(facet);
  }

  @Override
  public String toString() {
    return "TriangularMesh(" + tree.size() + " triangles)";
  }
}
