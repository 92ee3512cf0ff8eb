package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;

import javax.vecmath.TexCoord2f;
import javax.vecmath.Vector3f;

import org.junit.jupiter.api.Test;

import materials.Lambertian;
import materials.Texture;
import primitives.Point3D;
import primitives.Vector3D;
import radiometry.ReflectanceRGB;
import tracer.Hit;
import tracer.Ray;
import trials.Trials;

/**
 * Meshes whose corners have normals or texture coordinates. The barycentric coordinates of the tests are chosen, not
 * computed.
 */
class SmoothMeshTest {

  private static final Map<Integer, Point3D> TRIANGLE =
      Map.of(1, new Point3D(0, 0, 0), 2, new Point3D(1, 0, 0), 3, new Point3D(0, 1, 0));

  private static Ray down(final double x, final double y) {
    return new Ray(new Point3D((float) x, (float) y, 3), new Vector3D(0, 0, -1));
  }

  private static void assertNormal(final double x, final double y, final double z, final Hit hit) {
    final double length = Math.sqrt(x * x + y * y + z * z);
    assertEquals(x / length, hit.normalX(), 1e-6, hit::toString);
    assertEquals(y / length, hit.normalY(), 1e-6, hit::toString);
    assertEquals(z / length, hit.normalZ(), 1e-6, hit::toString);
  }

  private static double dot(final Hit hit) {
    return hit.normalX() * hit.geometricX() + hit.normalY() * hit.geometricY() + hit.normalZ() * hit.geometricZ();
  }

  private static Vector3D anyVector(final Random random) {
    return new Vector3D((float) random.nextGaussian(), (float) random.nextGaussian(), (float) random.nextGaussian());
  }

  @Test
  void normalsAreInterpolatedByTheWeightsOfTheCorners() {
    Trials.of(2000, random -> {
      final Map<Integer, Vector3D> normals = new HashMap<>();
      final double[][] n = new double[3][];
      double z = 0;
      for (int k = 0; k < 3; k++) {
        final Vector3D any = anyVector(random);
        normals.put(k + 1, any);
        final double length = Math.sqrt((double) any.x * any.x + (double) any.y * any.y + (double) any.z * any.z);
        n[k] = new double[] {any.x / length, any.y / length, any.z / length};
        z += n[k][2];
      }
      final float b = random.nextFloat(), c = random.nextFloat() * (1 - b), sign = z < 0 ? -1 : 1;
      final double a = 1 - (double) b - c;
      final double[] m = new double[3];
      for (int i = 0; i < 3; i++) {
        m[i] = sign * (a * n[0][i] + b * n[1][i] + c * n[2][i]);
      }
      final Hit hit = new TriangularMesh(TRIANGLE, normals, List.of("1//1 2//2 3//3"), Color.RED)
          .intersectionWith(down(b, c));
      assertTrue(!hit.hits() || dot(hit) >= 0, hit::toString);
      if (hit.hits() && m[2] > 1e-3 * Math.hypot(m[0], m[1])) {
        assertNormal(m[0], m[1], m[2], hit);
      } else if (hit.hits() && m[2] < 0) {
        assertNormal(m[0], m[1], 0, hit);
      }
      assertEquals(new Vector3D(0, 0, 1), hit.hits() ? hit.getGeometricNormal() : new Vector3D(0, 0, 1));
    });
  }

  @Test
  void normalsThatTogetherPointBehindAreReversed() {
    final Map<Integer, Vector3D> normals = Map.of(7, new Vector3D(3, 0, -4));
    final Hit hit = new TriangularMesh(TRIANGLE, normals, List.of("1//7 2//7 3//7"), Color.RED)
        .intersectionWith(down(0.2, 0.2));
    assertNormal(-0.6, 0, 0.8, hit);
  }

  @Test
  void aSteepNormalAmongOthersIsNotReversedAndIsCutToTheFront() {
    final Map<Integer, Vector3D> normals = Map.of(1, new Vector3D(0, 0, 1), 2, new Vector3D(4, 0, -3));
    final TriangularMesh mesh = new TriangularMesh(TRIANGLE, normals, List.of("1//1 2//2 3//1"), Color.RED);
    assertNormal(1, 0, 0, mesh.intersectionWith(down(0.99, 0.001)));
    assertNormal(0.3 * 0.8, 0, 0.7 - 0.3 * 0.6, mesh.intersectionWith(down(0.3, 0.1)));
  }

  /** A roof of two squares: its ridge has the average of both, weighted by area, its eaves that of their own square. */
  @Test
  void cornersWithoutNormalHaveTheAverageOfTheirVertex() {
    final Map<Integer, Point3D> vertices = new HashMap<>();
    final float[][] p = {{-2, 0, -2}, {-2, 1, -2}, {0, 0, 0}, {0, 1, 0}, {1, 0, -1}, {1, 1, -1}};
    for (int i = 0; i < p.length; i++) {
      vertices.put(i + 1, new Point3D(p[i][0], p[i][1], p[i][2]));
    }
    final List<String> facets = List.of("1 3 2", "3 4 2", "3 5 4", "5 6 4");
    final TriangularMesh mesh = new TriangularMesh(vertices, Map.of(), facets, Color.RED);
    final double root = Math.sqrt(0.5);
    assertNormal(-root, 0, root, mesh.intersectionWith(down(-2 + 1e-6, 0.5)));
    final Hit ridge = mesh.intersectionWith(down(1e-6, 0.5));
    assertTrue(ridge.normalX() < -0.2 && ridge.normalZ() > 0.9, ridge::toString);
    assertEquals(root, ridge.geometricX(), 1e-6);
  }

  @Test
  void theTwoSidesOfASheetCancelAndLeaveTheTriangleItsOwnNormal() {
    final TriangularMesh mesh = new TriangularMesh(TRIANGLE, Map.of(), List.of("1 2 3", "3 2 1"), Color.RED);
    final Hit hit = mesh.intersectionWith(down(0.25, 0.25));
    assertEquals(Math.abs(hit.geometricZ()), 1);
    assertEquals(hit.geometricZ(), hit.normalZ());
  }

  @Test
  void aFineSphereIsShadedAsTheSphere() {
    final Map<Integer, Point3D> vertices = new HashMap<>();
    final Map<Integer, Vector3D> normals = new HashMap<>();
    final List<String> facets = new ArrayList<>();
    final int rings = 40;
    for (int i = 0; i <= rings; i++) {
      for (int k = 0; k < 2 * rings; k++) {
        final double a = Math.PI * i / rings, b = Math.PI * k / rings;
        final Point3D p = new Point3D((float) (Math.sin(a) * Math.cos(b)), (float) (Math.sin(a) * Math.sin(b)),
            (float) Math.cos(a));
        vertices.put(2 * rings * i + k, p);
        normals.put(2 * rings * i + k, new Vector3D(2 * p.x, 2 * p.y, 2 * p.z));
        if (i < rings) {
          final int q = 2 * rings * i, right = q + (k + 1) % (2 * rings), down = q + k + 2 * rings;
          facets.add(corner(q + k) + corner(down) + corner(right));
          facets.add(corner(right) + corner(down) + corner(right + 2 * rings));
        }
      }
    }
    final TriangularMesh mesh = new TriangularMesh(vertices, normals, facets, Color.RED);
    Trials.of(500, random -> {
      final double x = 0.9 * (random.nextDouble() - 0.5), y = 0.9 * (random.nextDouble() - 0.5);
      final Hit hit = mesh.intersectionWith(down(x, y));
      assertEquals(x, hit.normalX(), 5e-3);
      assertEquals(y, hit.normalY(), 5e-3);
    });
  }

  private static String corner(final int index) {
    return index + "//" + index + " ";
  }

  /**
   * A stretched mesh: normals are interpolated in its own frame and transformed by the inverse transpose; mirroring keeps
   * the outside.
   */
  @Test
  void bothNormalsAreTransformedByTheInverseTranspose() {
    final Map<Integer, Vector3D> normals = Map.of(1, new Vector3D(0.6f, 0, 0.8f), 2, new Vector3D(0, 0.6f, 0.8f));
    final TriangularMesh mesh = new TriangularMesh(TRIANGLE, normals, List.of("1//1 2//2 3//2"), Color.RED);
    final AffineTransformation stretched = new AffineTransformation(new Vector3f(2, 4, -0.5f), mesh);
    final Hit hit = stretched.intersectionWith(down(2 * 0.25, 4 * 0.25));
    assertNormal(0.5 * 0.6 / 2, 0.5 * 0.6 / 4, -0.8 / 0.5, hit);
    assertEquals(new Vector3D(0, 0, -1), hit.getGeometricNormal());
  }

  @Test
  void flatMeshesHaveOneNormalBitForBit() {
    Trials.of(300, random -> {
      final Map<Integer, Point3D> vertices = new HashMap<>();
      for (int i = 1; i <= 3; i++) {
        vertices.put(i, new Point3D(random.nextFloat() - 0.5f, random.nextFloat() - 0.5f, random.nextFloat()));
      }
      final TriangularMesh flat = new TriangularMesh(vertices, List.of("1/1/1 2/2/2 3/3/3"), Color.RED);
      final TriangularMesh smooth = new TriangularMesh(vertices, Map.of(), List.of("1 2 3"), Color.RED);
      for (int i = 0; i < 20; i++) {
        final Ray ray = down(random.nextDouble() - 0.5, random.nextDouble() - 0.5);
        final Hit hit = flat.intersectionWith(ray), other = smooth.intersectionWith(ray);
        assertEquals(hit.hits(), other.hits());
        assertEquals(hit.getT(), other.getT());
        assertEquals(hit.getPoint(), other.getPoint());
        assertEquals(hit.getGeometricNormal(), other.getGeometricNormal());
        assertEquals(hit.getGeometricNormal(), hit.getNormal());
      }
    });
  }

  private static Texture chequered() {
    final BufferedImage image = new BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB);
    for (int i = 0; i < 64; i++) {
      image.setRGB(i % 8, i / 8, 0x10101 * (i + 1));
    }
    return new Texture(image);
  }

  @Test
  void eachTexelIsWhereGeometryPutsIt() {
    final Map<Integer, Point3D> square = Map.of(1, new Point3D(), 2, new Point3D(8, 0, 0), 3, new Point3D(8, 8, 0),
        4, new Point3D(0, 8, 0));
    for (final int[] shift : new int[][] {{0, 0}, {1, -2}, {-5, 7}}) {
      final float u = shift[0], v = shift[1];
      final Map<Integer, TexCoord2f> uv = Map.of(1, new TexCoord2f(u, v), 2, new TexCoord2f(u + 1, v),
          3, new TexCoord2f(u + 1, v + 1), 4, new TexCoord2f(u, v + 1));
      final TriangularMesh mesh = new TriangularMesh(square, Map.of(), uv, List.of("1/1 2/2 3/3", "1/1 3/3 4/4"),
          chequered());
      for (int column = 0; column < 8; column++) {
        for (int row = 0; row < 8; row++) {
          final Hit hit = mesh.intersectionWith(down(column + 0.3, row + 0.6));
          assertEquals(new Color(0x10101 * (8 * (7 - row) + column + 1)), hit.getObject().getColorAt(hit));
          assertEquals(u + (column + 0.3) / 8, hit.getTexCoord().x, 1e-5);
          assertEquals(v + (row + 0.6) / 8, hit.getTexCoord().y, 1e-5);
        }
      }
    }
  }

  @Test
  void aCornerWithoutTextureCoordinatesLeavesItsTriangleWithoutAny() {
    final Map<Integer, TexCoord2f> uv = Map.of(1, new TexCoord2f(0.5f, 0.5f));
    final TriangularMesh mesh = new TriangularMesh(TRIANGLE, Map.of(), uv, List.of("1/1 2/1 3"), Color.RED);
    assertNull(mesh.intersectionWith(down(0.2, 0.2)).getTexCoord());
    final TriangularMesh whole = new TriangularMesh(TRIANGLE, Map.of(), uv, List.of("1/1 2/1 3/1"),
        new Lambertian(new ReflectanceRGB(1, 0, 0)));
    assertEquals(new TexCoord2f(0.5f, 0.5f), whole.intersectionWith(down(0.2, 0.2)).getTexCoord());
  }

  @Test
  void wrongArgumentsAreNamedWithTheirValue() {
    final Map<Integer, TexCoord2f> uv = Map.of(1, new TexCoord2f());
    assertWrong("1//9", () -> new TriangularMesh(TRIANGLE, Map.of(), List.of("1//9 2 3"), Color.RED));
    assertWrong("2/5", () -> new TriangularMesh(TRIANGLE, Map.of(), uv, List.of("1 2/5 3"), Color.RED));
    assertWrong("1/1 2/1 3", () -> new TriangularMesh(TRIANGLE, Map.of(), uv, List.of("1/1 2/1 3"), chequered()));
    assertWrong("normal 4", () -> new TriangularMesh(TRIANGLE, Map.of(4, new Vector3D()), List.of("1 2 3"), Color.RED));
    assertWrong("normal 4", () -> new TriangularMesh(TRIANGLE, Map.of(4, new Vector3D(0, Float.NaN, 1)), List.of("1 2 3"),
        Color.RED));
    assertWrong("uv 6", () -> new TriangularMesh(TRIANGLE, Map.of(), Map.of(6, new TexCoord2f(Float.NaN, 0)),
        List.of("1 2 3"), Color.RED));
    assertWrong("normals", () -> new TriangularMesh(TRIANGLE, null, List.of("1 2 3"), Color.RED));
    assertWrong("uv", () -> new TriangularMesh(TRIANGLE, Map.of(), null, List.of("1 2 3"), Color.RED));
    assertWrong("texture", () -> new TriangularMesh(TRIANGLE, Map.of(), uv, List.of("1/1 2/1 3/1"), (Texture) null));
  }

  private static void assertWrong(final String part, final Runnable constructor) {
    final String message = assertThrows(IllegalArgumentException.class, constructor::run).getMessage();
    assertTrue(message.contains(part), message);
  }
}
