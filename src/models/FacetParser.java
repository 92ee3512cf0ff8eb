package models;

import static arguments.Arguments.direction;
import static arguments.Arguments.finite;
import static arguments.Arguments.notNull;
import static arguments.Arguments.wrong;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.StringTokenizer;

import javax.vecmath.TexCoord2f;

import primitives.Point3D;
import primitives.Vector3D;

/**
 * Reads the facets of a mesh from strings of three corners. Each begins with the index of a vertex; what follows after
 * {@code /} are those of texture coordinates and of a normal, which only smooth or textured meshes use.
 */
final class FacetParser {

  private static final String SEPARATORS = " \t\r\n\f,";

  private final Map<Integer, Integer> vertexNumbers = new HashMap<>();
  private final Map<Integer, Integer> normalNumbers = new HashMap<>();
  private final Map<Integer, Integer> pairNumbers = new HashMap<>();
  private final int[] corners;
  /** Numbers of normals and texture coordinates, −1 where a corner has none; null if they are ignored. */
  private int[] normals;
  private int[] pairs;

  private FacetParser(final int facets) {
    corners = new int[3 * facets];
  }

  /** A mesh of which only vertices count. */
  static MeshArrays arrays(final Map<Integer, Point3D> vertices, final List<String> facetas) {
    notNull("vertices", vertices);
    notNull("facetas", facetas);
    final FacetParser facets = new FacetParser(facetas.size());
    final float[] coordinates = facets.coordinates(vertices);
    facets.read(facetas);
    return MeshArrays.checked(coordinates, "facetas", facets.corners);
  }

  /**
   * A smooth mesh. A corner without normal has the average of its vertex.
   *
   * @param uv the texture coordinates; null if there are none, then those of the facets are ignored
   */
  static MeshData smooth(final Map<Integer, Point3D> vertices, final Map<Integer, Vector3D> normals,
      final Map<Integer, TexCoord2f> uv, final List<String> facetas) {
    notNull("vertices", vertices);
    notNull("normals", normals);
    notNull("facetas", facetas);
    final FacetParser facets = new FacetParser(facetas.size());
    final double[] coordinates = doubles(facets.coordinates(vertices));
    final float[] given = facets.normals(normals);
    final double[] pairs = uv == null ? null : facets.pairs(uv);
    facets.read(facetas);
    final float[] values = facets.withAverages(coordinates, given);
    return new MeshData(coordinates, facets.corners, new MeshData.Normals(values, facets.normals),
        uv == null ? null : new MeshData.TexCoords(pairs, facets.pairs));
  }

  /** A smooth mesh whose corners all have texture coordinates. */
  static MeshData textured(final Map<Integer, Point3D> vertices, final Map<Integer, Vector3D> normals,
      final Map<Integer, TexCoord2f> uv, final List<String> facetas) {
    final MeshData data = smooth(vertices, normals, uv, facetas);
    for (int i = 0; i < data.corners().length; i++) {
      if (data.texCoords().pair(i) < 0) {
        throw wrong("noTexCoord", i / 3, facetas.get(i / 3));
      }
    }
    return data;
  }

  private float[] coordinates(final Map<Integer, Point3D> vertices) {
    final float[] coordinates = new float[3 * vertices.size()];
    for (final Map.Entry<Integer, Point3D> vertex : vertices.entrySet()) {
      final Point3D P = finite("vertex " + vertex.getKey(), vertex.getValue());
      final int n = number(vertexNumbers, "vertex index", vertex.getKey());
      coordinates[3 * n] = P.x;
      coordinates[3 * n + 1] = P.y;
      coordinates[3 * n + 2] = P.z;
    }
    return coordinates;
  }

  private static double[] doubles(final float[] floats) {
    final double[] doubles = new double[floats.length];
    for (int i = 0; i < floats.length; i++) {
      doubles[i] = floats[i];
    }
    return doubles;
  }

  private static int number(final Map<Integer, Integer> numbers, final String name, final Integer key) {
    final int number = numbers.size();
    numbers.put(notNull(name, key), number);
    return number;
  }

  private float[] normals(final Map<Integer, Vector3D> given) {
    final float[] values = new float[3 * given.size()];
    for (final Map.Entry<Integer, Vector3D> normal : given.entrySet()) {
      final Vector3D n = direction("normal " + normal.getKey(), normal.getValue());
      final double length = Math.sqrt((double) n.x * n.x + (double) n.y * n.y + (double) n.z * n.z);
      final int number = number(normalNumbers, "normal index", normal.getKey());
      values[3 * number] = (float) (n.x / length);
      values[3 * number + 1] = (float) (n.y / length);
      values[3 * number + 2] = (float) (n.z / length);
    }
    normals = new int[corners.length];
    return values;
  }

  private double[] pairs(final Map<Integer, TexCoord2f> given) {
    final double[] values = new double[2 * given.size()];
    for (final Map.Entry<Integer, TexCoord2f> pair : given.entrySet()) {
      final TexCoord2f uv = notNull("uv " + pair.getKey(), pair.getValue());
      final int number = number(pairNumbers, "uv index", pair.getKey());
      values[2 * number] = finite("uv " + pair.getKey() + ".x", uv.x);
      values[2 * number + 1] = finite("uv " + pair.getKey() + ".y", uv.y);
    }
    pairs = new int[corners.length];
    return values;
  }

  private void read(final List<String> facetas) {
    int which = 0;
    for (final String facet : facetas) {
      final StringTokenizer tokens = new StringTokenizer(notNull("facet " + which, facet), SEPARATORS);
      if (tokens.countTokens() != 3) {
        throw wrong("facet", which, facet);
      }
      for (int k = 0; k < 3; k++) {
        corner(tokens.nextToken(), facet, 3 * which + k);
      }
      which++;
    }
  }

  private void corner(final String token, final String facet, final int at) {
    final String[] indices = token.split("/", -1);
    if (normals != null && indices.length > 3) {
      throw wrong("facet", at / 3, facet);
    }
    final Corner corner = new Corner(token, facet, at / 3);
    corners[at] = number(vertexNumbers, indices[0], "vertex", corner);
    if (pairs != null) {
      pairs[at] = suffix(pairNumbers, indices, 1, "texCoord", corner);
    }
    if (normals != null) {
      normals[at] = suffix(normalNumbers, indices, 2, "normal", corner);
    }
  }

  /** How messages identify a corner: by its text, and the text and number of its facet. */
  private record Corner(String token, String facet, int number) {
  }

  private static int suffix(final Map<Integer, Integer> numbers, final String[] indices, final int place, final String key,
      final Corner corner) {
    return indices.length <= place || indices[place].isEmpty() ? -1 : number(numbers, indices[place], key, corner);
  }

  /** The number of the element that an index names; if there is none, the exception has the message of the key. */
  private static int number(final Map<Integer, Integer> numbers, final String index, final String key,
      final Corner corner) {
    try {
      final Integer number = numbers.get(Integer.valueOf(index));
      if (number == null) {
        throw wrong(key, corner.number(), corner.token());
      }
      return number;
    } catch (final NumberFormatException notNumber) {
      throw wrong("facet", corner.number(), corner.facet());
    }
  }

  /** The given normals, and after them the averages of the vertices, which corners without a normal get. */
  private float[] withAverages(final double[] p, final float[] given) {
    final AveragedNormals averages = new AveragedNormals();
    for (int i = 0; i < corners.length; i += 3) {
      final int a = 3 * corners[i], b = 3 * corners[i + 1], c = 3 * corners[i + 2];
      final double ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
      final double vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
      averages.add((uy * vz - uz * vy) / 2, (uz * vx - ux * vz) / 2, (ux * vy - uy * vx) / 2,
          Arrays.copyOfRange(corners, i, i + 3), 3);
    }
    final float[] values = Arrays.copyOf(given, given.length + p.length);
    System.arraycopy(averages.of(p.length / 3), 0, values, given.length, p.length);
    for (int i = 0; i < corners.length; i++) {
      normals[i] = normals[i] < 0 ? given.length / 3 + corners[i] : normals[i];
    }
    return values;
  }
}
