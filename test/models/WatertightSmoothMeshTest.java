package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

import javax.vecmath.AxisAngle4d;
import javax.vecmath.Matrix4d;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import primitives.Point3D;
import tracer.Hit;
import tracer.Ray;

/**
 * Closed meshes with normals at their corners, as they are and transformed, have no cracks either: of a million rays at
 * vertices and edges, from inside and outside, none passes. Each hit has a normal that is never turned behind the facet.
 */
class WatertightSmoothMeshTest {

  private static final int RAYS = RandomNumbers.times(62_500);

  /** A smooth mesh, the transformation that it is placed by, and the same as a matrix; null for a mesh as it is. */
  record Placed(ClosedMesh closed, Object3D object, Matrix4d matrix) {

    Point3D inScene(final Point3D P) {
      if (matrix == null) {
        return P;
      }
      final Point3d p = new Point3d(P);
      matrix.transform(p);
      return new Point3D((float) p.x, (float) p.y, (float) p.z);
    }

    @Override
    public String toString() {
      return closed.name() + (matrix == null ? "" : ", transformed");
    }
  }

  static List<Placed> meshes() {
    final List<Placed> meshes = new ArrayList<>();
    for (final ClosedMesh closed : List.of(ClosedMesh.octahedron(), ClosedMesh.cube(), ClosedMesh.icosphere(3),
        ClosedMesh.icosphere(5))) {
      meshes.add(new Placed(closed, smooth(closed), null));
      meshes.add(placed(closed, new Vector3f(-2, 0.3f, 5), new Vector3f(1, 2, 3), 77, new Vector3f(100, -200, 50)));
    }
    return meshes;
  }

  private static Placed placed(final ClosedMesh closed, final Vector3f s, final Vector3f axis, final float theta,
      final Vector3f d) {
    final Matrix4d matrix = new Matrix4d(), scale = new Matrix4d();
    final Vector3d unit = new Vector3d(axis);
    unit.normalize();
    matrix.set(new AxisAngle4d(unit, Math.toRadians(theta)));
    scale.m00 = s.x;
    scale.m11 = s.y;
    scale.m22 = s.z;
    scale.m33 = 1;
    matrix.mul(scale);
    matrix.setTranslation(new Vector3d(d));
    return new Placed(closed, new AffineTransformation(s, axis, theta, d, smooth(closed)), matrix);
  }

  /** The mesh whose corners have the averages of their vertices. */
  private static TriangularMesh smooth(final ClosedMesh closed) {
    final Map<Integer, Point3D> vertices = new HashMap<>();
    final List<String> facets = new ArrayList<>();
    for (int i = 0; i < closed.triangles(); i++) {
      final StringBuilder facet = new StringBuilder();
      for (int k = 0; k < 3; k++) {
        vertices.put(closed.corners()[3 * i + k], closed.vertex(i, k));
        facet.append(closed.corners()[3 * i + k]).append(' ');
      }
      facets.add(facet.toString());
    }
    return new TriangularMesh(vertices, Map.of(), facets, Color.WHITE);
  }

  /** A vertex, the middle of an edge, or another point of it. */
  private static Point3D target(final ClosedMesh mesh, final RandomNumbers numbers) {
    final int triangle = numbers.index(mesh.triangles());
    final double u = numbers.between(0, 1);
    switch (numbers.index(4)) {
      case 0: return mesh.vertex(triangle, numbers.index(3));
      case 1: return mesh.point(triangle, 0.5, 0.5, 0);
      case 2: return mesh.point(triangle, 0, u, 1 - u);
      default: return mesh.point(triangle, u, 0, 1 - u);
    }
  }

  @ParameterizedTest
  @MethodSource("meshes")
  void noRayAtAVertexOrAnEdgePasses(final Placed placed) {
    final RandomNumbers numbers = new RandomNumbers("smooth meshes");
    for (int i = 0; i < RAYS; i++) {
      final Point3D inside = numbers.pointAbout(new Point3D(), 0.1), target = target(placed.closed, numbers);
      final float k = 1 + numbers.magnitude(-3, 6);
      final Point3D outside = new Point3D(inside.x + k * (target.x - inside.x), inside.y + k * (target.y - inside.y),
          inside.z + k * (target.z - inside.z));
      assertHit(placed, new Ray(placed.inScene(inside), placed.inScene(target)), numbers);
      assertHit(placed, new Ray(placed.inScene(outside), placed.inScene(target)), numbers);
    }
  }

  private static void assertHit(final Placed placed, final Ray ray, final RandomNumbers numbers) {
    final Hit hit = placed.object.intersectionWith(ray);
    if (!hit.hits()) {
      throw new AssertionError(placed + " lost " + ray + ", " + numbers);
    }
    final double x = hit.normalX(), y = hit.normalY(), z = hit.normalZ();
    assertEquals(1, x * x + y * y + z * z, 1e-12);
    assertTrue(x * hit.geometricX() + y * hit.geometricY() + z * hit.geometricZ() >= -1e-6);
  }
}
