package models;

import static arguments.Arguments.notNull;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

import javax.vecmath.TexCoord2f;

import primitives.Vector3D;

/**
 * The arguments with which a constructor of {@link TriangularMesh} makes a mesh of one triangle of another mesh, which is
 * intersected and shaded as in that mesh, but has no texture.
 */
public final class FacetArguments {

  private final Map<Integer, Vector3D> normals = new TreeMap<>();
  private final Map<Integer, TexCoord2f> texCoords = new TreeMap<>();

  /** Those of a facet of a surface, whose corners get the numbers 1 to 3. */
  private FacetArguments(final MeshSurface surface, final int facet) {
    for (int k = 0; k < 3; k++) {
      putUnlessNull(normals, k + 1, surface.normal(facet, k));
      putUnlessNull(texCoords, k + 1, surface.texCoord(facet, k));
    }
  }

  /**
   * The arguments for a triangle.
   *
   * @param mesh a mesh
   * @param triangle one of {@link TriangularMesh#getTriangles}
   * @return vertices, normals, texture coordinates if there are any, the facet, and the colour; empty if the triangle has
   *     neither normals nor texture coordinates, or is not of the mesh
   * @throws IllegalArgumentException if the mesh is null
   */
  public static List<Object> of(final TriangularMesh mesh, final Triangle triangle) {
    if (notNull("mesh", mesh).getTriangles() instanceof MeshTriangles triangles && triangles.facetOf(triangle) >= 0) {
      return new FacetArguments(triangles.surface(), triangles.facetOf(triangle)).with(triangle);
    }
    return List.of();
  }

  private static <T> void putUnlessNull(final Map<Integer, T> map, final int key, final T value) {
    if (value != null) {
      map.put(key, value);
    }
  }

  private List<Object> with(final Triangle triangle) {
    if (normals.isEmpty() && texCoords.isEmpty()) {
      return List.of();
    }
    final List<Object> vertices = triangle.constructorArguments();
    final List<Object> arguments = new ArrayList<>();
    arguments.add(Map.of(1, vertices.get(0), 2, vertices.get(1), 3, vertices.get(2)));
    arguments.add(normals);
    if (!texCoords.isEmpty()) {
      arguments.add(texCoords);
    }
    arguments.add(List.of(corner(1) + " " + corner(2) + " " + corner(3)));
    arguments.add(triangle.getColor());
    return List.copyOf(arguments);
  }

  private String corner(final int number) {
    final String texture = texCoords.containsKey(number) ? "/" + number : "";
    final String normal = normals.containsKey(number) ? (texture.isEmpty() ? "//" : "/") + number : "";
    return number + texture + normal;
  }
}
