package models;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

import javax.vecmath.TexCoord2f;

import org.junit.jupiter.api.Test;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/** What the corners of a triangle have is interpolated by chosen weights, for triangles in any position. */
class InterpolationTest {

  private static final RandomNumbers NUMBERS = new RandomNumbers("interpolation");

  private static double[] unit(final double... v) {
    final double length = Math.sqrt(dot(v, v));
    return new double[] {v[0] / length, v[1] / length, v[2] / length};
  }

  private static double dot(final double[] a, final double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  private static double[] sum(final double[] weights, final double[][] of) {
    final double[] sum = new double[of[0].length];
    for (int i = 0; i < 3; i++) {
      for (int k = 0; k < sum.length; k++) {
        sum[k] += weights[i] * of[i][k];
      }
    }
    return sum;
  }

  /** Unit vector of (B − A) × (C − A). */
  private static double[] normal(final double[][] p) {
    final double[] u = {p[1][0] - p[0][0], p[1][1] - p[0][1], p[1][2] - p[0][2]};
    final double[] v = {p[2][0] - p[0][0], p[2][1] - p[0][1], p[2][2] - p[0][2]};
    return unit(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
  }

  /** The interpolated normal by the page: on the side of the winding as a whole, then cut to the front. */
  private static double[] shading(final double[] weights, final double[][] normals, final double[] g) {
    final double sign = dot(sum(new double[] {1, 1, 1}, normals), g) < 0 ? -1 : 1;
    final double[] m = sum(new double[] {sign * weights[0], sign * weights[1], sign * weights[2]}, normals), n = unit(m);
    final double behind = Math.min(0, dot(n, g));
    return unit(n[0] - behind * g[0], n[1] - behind * g[1], n[2] - behind * g[2]);
  }

  @Test
  void normalsAndTextureCoordinatesAreThoseOfTheWeights() {
    int reversed = 0, cut = 0;
    for (int i = 0; i < RandomNumbers.times(4000); i++) {
      final Map<Integer, Point3D> vertices = new HashMap<>();
      final Map<Integer, Vector3D> normals = new HashMap<>();
      final Map<Integer, TexCoord2f> uv = new HashMap<>();
      final double[][] p = new double[3][], n = new double[3][], t = new double[3][];
      for (int k = 0; k < 3; k++) {
        final Point3D P = NUMBERS.pointAbout(new Point3D(1, -2, 3), 2);
        final Vector3D v = NUMBERS.direction();
        v.scale(NUMBERS.magnitude(-5, 5));
        vertices.put(10 * k, P);
        normals.put(7 - k, v);
        uv.put(k * k, new TexCoord2f(P.y, P.z + P.x));
        p[k] = new double[] {P.x, P.y, P.z};
        n[k] = unit(v.x, v.y, v.z);
        t[k] = new double[] {P.y, P.z + P.x};
      }
      final double b = NUMBERS.between(0, 1), c = NUMBERS.between(0, 1 - b);
      final double[] weights = {1 - b - c, b, c}, g = normal(p), target = sum(weights, p), m = sum(weights, n);
      final Point3D Q = new Point3D((float) target[0], (float) target[1], (float) target[2]);
      final Hit hit = new TriangularMesh(vertices, normals, uv, List.of("0/0/7 10/1/6 20/4/5"), Color.RED)
          .intersectionWith(new Ray(NUMBERS.pointAbout(Q, 9), Q));
      final double[] expected = shading(weights, n, g);
      if (hit.hits() && Q.distance(hit.getPoint()) < 1e-5 && Math.sqrt(dot(m, m)) > 0.1 && isFat(p)) {
        reversed += dot(n[0], g) + dot(n[1], g) + dot(n[2], g) < 0 ? 1 : 0;
        cut += dot(expected, g) < 1e-9 ? 1 : 0;
        assertArrayEquals(expected, new double[] {hit.normalX(), hit.normalY(), hit.normalZ()}, 1e-3,
            () -> Arrays.deepToString(p) + hit + ", " + NUMBERS);
        assertArrayEquals(g, new double[] {hit.geometricX(), hit.geometricY(), hit.geometricZ()}, 1e-6);
        assertArrayEquals(sum(weights, t), new double[] {hit.textureU(), hit.textureV()}, 1e-4);
      }
    }
    assertTrue(reversed > 500 && cut > 100, reversed + " reversed, " + cut + " cut");
  }

  /** Facets without area among others: they are left out, and the others keep their normals, texture and colours. */
  @Test
  void facetsWithoutAreaTakeNothingFromTheOthers() {
    final double[] p = {-1, -1, 0, 1, -1, 0.5, 1, 1, 0, -1, 1, 0.25};
    final float[] n = {0, 0.6f, 0.8f, 0.6f, 0, 0.8f, 0, 0, 1};
    final double[] t = {0, 0, 1, 0, 1, 1, 0, 1};
    final List<Appearance> colours = Stream.of(Color.RED, Color.GREEN, Color.BLUE).map(Appearance::of).toList();
    final TriangularMesh whole = TriangularMesh.of(new MeshData(p, new int[] {0, 1, 2, 0, 2, 3},
        new MeshData.Normals(n, new int[] {0, 1, 2, 0, 2, 1}), new MeshData.TexCoords(t, new int[] {0, 1, 2, 0, 2, 3})),
        colours, new int[] {0, 2});
    final TriangularMesh gaps = TriangularMesh.of(new MeshData(p, new int[] {3, 3, 1, 0, 1, 2, 2, 2, 2, 0, 0, 1, 0, 2, 3},
        new MeshData.Normals(n, new int[] {2, 2, 2, 0, 1, 2, 1, 1, 1, 0, 0, 0, 0, 2, 1}),
        new MeshData.TexCoords(t, new int[] {3, 3, 3, 0, 1, 2, 1, 1, 1, 2, 2, 2, 0, 2, 3})),
        colours, new int[] {1, 0, 1, 1, 2});
    assertEquals(2, gaps.getTriangles().size());
    for (int i = 0; i < 1000; i++) {
      final Ray ray = new Ray(NUMBERS.pointAbout(new Point3D(0, 0, 5), 3), NUMBERS.pointAbout(new Point3D(), 1.2));
      final Hit expected = whole.intersectionWith(ray), hit = gaps.intersectionWith(ray);
      assertEquals(expected.hits(), hit.hits());
      if (hit.hits()) {
        assertEquals(expected.getNormal(), hit.getNormal());
        assertEquals(expected.getTexCoord(), hit.getTexCoord());
        assertEquals(expected.getObject().getColor(), hit.getObject().getColor());
      }
    }
  }

  /** A triangle has an area as soon as it has one in the projection along any axis; on a line it has none. */
  @Test
  void trianglesAcrossEachAxisHaveAnArea() {
    for (int axis = 0; axis < 3; axis++) {
      final float[] p = new float[12];
      p[3 + (axis + 1) % 3] = 1;
      p[6 + (axis + 2) % 3] = 1;
      p[9 + (axis + 1) % 3] = 3;
      assertEquals(1, TriangularMesh.of(p, new int[] {0, 1, 2, 0, 1, 3}, Color.RED).getTriangles().size());
    }
    final float[] line = {0, 0, 0, 1, 2, 3, 2, 4, 6};
    assertThrows(IllegalArgumentException.class, () -> TriangularMesh.of(line, new int[] {0, 1, 2}, Color.RED));
  }

  /** Neither small nor slender, so that weights do not depend on rounding. */
  private static boolean isFat(final double[][] p) {
    double longest = 0, shortest = 1e9;
    for (int k = 0; k < 3; k++) {
      final double[] a = p[k], b = p[(k + 1) % 3], side = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
      longest = Math.max(longest, Math.sqrt(dot(side, side)));
      shortest = Math.min(shortest, Math.sqrt(dot(side, side)));
    }
    return shortest > 0.3 * longest && longest > 0.5;
  }
}
