package models;

import static arguments.Arguments.finite;
import static arguments.Arguments.notNull;
import static arguments.Arguments.wrong;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.StringTokenizer;

import primitives.Point3D;

/** Reads the facets of a mesh from strings of three vertex indices, as the assignment gives them. */
final class FacetParser {

  private static final String SEPARATORS = " \t\r\n\f,";

  private final Map<Integer, Integer> numbers = new HashMap<>();

  private FacetParser() {
  }

  static MeshArrays arrays(final Map<Integer, Point3D> vertices, final List<String> facetas) {
    notNull("vertices", vertices);
    notNull("facetas", facetas);
    final FacetParser facets = new FacetParser();
    final float[] coordinates = facets.number(vertices);
    final int[] corners = new int[3 * facetas.size()];
    int at = 0;
    for (final String facet : facetas) {
      facets.read(facet, corners, at);
      at += 3;
    }
    return MeshArrays.checked(coordinates, "facetas", corners);
  }

  private float[] number(final Map<Integer, Point3D> vertices) {
    final float[] coordinates = new float[3 * vertices.size()];
    int n = 0;
    for (final Map.Entry<Integer, Point3D> vertex : vertices.entrySet()) {
      final Point3D P = finite("vertex " + vertex.getKey(), vertex.getValue());
      numbers.put(notNull("vertex index", vertex.getKey()), n);
      coordinates[3 * n] = P.x;
      coordinates[3 * n + 1] = P.y;
      coordinates[3 * n + 2] = P.z;
      n++;
    }
    return coordinates;
  }

  private void read(final String facet, final int[] corners, final int at) {
    final StringTokenizer tokens = new StringTokenizer(notNull("facet " + at / 3, facet), SEPARATORS);
    if (tokens.countTokens() != 3) {
      throw wrong("facet", at / 3, facet);
    }
    for (int k = 0; k < 3; k++) {
      final String token = tokens.nextToken();
      final int slash = token.indexOf('/');
      final Integer number = numbers.get(index(slash < 0 ? token : token.substring(0, slash), facet, at / 3));
      if (number == null) {
        throw wrong("vertex", at / 3, token);
      }
      corners[at + k] = number;
    }
  }

  private static Integer index(final String text, final String facet, final int which) {
    try {
      return Integer.valueOf(text);
    } catch (NumberFormatException e) {
      throw wrong("facet", which, facet);
    }
  }
}
