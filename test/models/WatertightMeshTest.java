package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/**
 * A closed mesh has no cracks: of more than a million rays at vertices, edges and faces, from outside and inside, none is
 * lost.
 */
class WatertightMeshTest {

  private static final int RAYS = RandomNumbers.times(28_000);

  /** Meshes about a middle that is inside them, some with integer coordinates, some far from the origin. */
  static List<ClosedMesh> convexMeshes() {
    final RandomNumbers numbers = new RandomNumbers("shaken meshes");
    final List<ClosedMesh> meshes = new ArrayList<>();
    for (final ClosedMesh mesh : List.of(ClosedMesh.tetrahedron(), ClosedMesh.cube(), ClosedMesh.octahedron(),
        ClosedMesh.icosphere(4))) {
      meshes.add(mesh);
      meshes.add(mesh.moved(1, 1000, -2000, 4000));
    }
    meshes.add(ClosedMesh.cube().shaken(numbers, 0.1));
    meshes.add(ClosedMesh.icosphere(2).shaken(numbers, 1e-3));
    meshes.add(ClosedMesh.icosphere(3).moved(1e-4f, 3, 2, 1));
    meshes.add(ClosedMesh.icosphere(3).moved(1e6f, 3e6f, -1e6f, 2e6f));
    return meshes;
  }

  private static Point3D middle(final ClosedMesh mesh) {
    final Point3D middle = new Point3D();
    middle.interpolate(mesh.mesh().getBoundingBox().getMin(), mesh.mesh().getBoundingBox().getMax(), 0.5f);
    return middle;
  }

  private static double size(final ClosedMesh mesh) {
    return mesh.mesh().getBoundingBox().maxX() - mesh.mesh().getBoundingBox().minX();
  }

  /** A vertex, a point of an edge or one of a face, of a random triangle. */
  private static Point3D target(final ClosedMesh mesh, final RandomNumbers numbers) {
    final int triangle = numbers.index(mesh.triangles());
    final double u = numbers.between(0, 1), v = numbers.between(0, 1 - u);
    switch (numbers.index(5)) {
      case 0: return mesh.vertex(triangle, numbers.index(3));
      case 1: return mesh.point(triangle, 0.5, 0.5, 0);
      case 2: return mesh.point(triangle, u, 1 - u, 0);
      case 3: return mesh.point(triangle, 0, u, 1 - u);
      default: return mesh.point(triangle, u, v, 1 - u - v);
    }
  }

  private static void assertNoneIsLost(final ClosedMesh closed, final Supplier<Ray> rays, final RandomNumbers numbers) {
    final TriangularMesh mesh = closed.mesh();
    for (int i = 0; i < RAYS; i++) {
      final Ray ray = rays.get();
      assertTrue(mesh.intersectionWith(ray).hits(), () -> closed.name() + " lost " + ray + ", " + numbers);
    }
  }

  @ParameterizedTest
  @MethodSource("convexMeshes")
  void noRayFromInsideIsLost(final ClosedMesh mesh) {
    final RandomNumbers numbers = new RandomNumbers("from inside");
    final Point3D middle = middle(mesh);
    final double within = 0.1 * size(mesh);
    assertNoneIsLost(mesh, () -> new Ray(numbers.pointAbout(middle, within), target(mesh, numbers)), numbers);
    assertNoneIsLost(mesh, () -> new Ray(middle, target(mesh, numbers)), numbers);
  }

  @ParameterizedTest
  @MethodSource("convexMeshes")
  void noRayFromOutsideThroughAVertexAnEdgeOrAFaceIsLost(final ClosedMesh mesh) {
    final RandomNumbers numbers = new RandomNumbers("from outside");
    final Point3D middle = middle(mesh);
    final double size = size(mesh);
    assertNoneIsLost(mesh, () -> {
      final Point3D target = target(mesh, numbers), inside = numbers.pointAbout(middle, 0.1 * size);
      final Vector3D v = new Vector3D(target.x - inside.x, target.y - inside.y, target.z - inside.z);
      v.scale(numbers.magnitude(-3, 6));
      return new Ray(new Point3D(target.x + v.x, target.y + v.y, target.z + v.z), target);
    }, numbers);
  }

  @Test
  void noRayWithinATorusIsLost() {
    final RandomNumbers numbers = new RandomNumbers("within the torus");
    final ClosedMesh torus = ClosedMesh.torus(96, 48);
    assertNoneIsLost(torus, () -> {
      final double a = numbers.between(0, 2 * Math.PI);
      final Point3D ring = new Point3D((float) (3 * Math.cos(a)), (float) (3 * Math.sin(a)), 0);
      return new Ray(numbers.pointAbout(ring, 0.4), target(torus, numbers));
    }, numbers);
  }

  @Test
  void raysExactlyThroughVerticesAndAlongDiagonalsHit() {
    for (final ClosedMesh mesh : List.of(ClosedMesh.cube(), ClosedMesh.octahedron(), ClosedMesh.tetrahedron(),
        ClosedMesh.icosphere(1), ClosedMesh.icosphere(5))) {
      final TriangularMesh triangles = mesh.mesh();
      for (int i = 0; i < 27; i++) {
        if (i != 13) {
          final Vector3D v = new Vector3D(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
          final Hit out = triangles.intersectionWith(new Ray(new Point3D(), v));
          final Hit in = triangles.intersectionWith(new Ray(new Point3D(-5 * v.x, -5 * v.y, -5 * v.z), v));
          assertTrue(out.hits() && in.hits(), mesh.name() + " along " + v);
          final Hit back = triangles.intersectionWith(new Ray(new Point3D(), new Vector3D(-v.x, -v.y, -v.z)));
          assertEquals(5 * v.length() - back.getT(), in.getT(), 1e-5, mesh.name() + " along " + v);
        }
      }
    }
    assertEquals(4, ClosedMesh.octahedron().mesh().intersectionWith(
        new Ray(new Point3D(0, 0, 5), new Vector3D(0, 0, -1))).getT());
  }

  /** A ray within the plane of a face hits the faces at both of its ends. */
  @Test
  void raysThatSlideAlongAFaceOrAnEdgeOfACubeHit() {
    final TriangularMesh cube = ClosedMesh.cube().mesh();
    for (int i = -4; i <= 4; i++) {
      final float at = i / 4f;
      for (final Ray ray : List.of(new Ray(new Point3D(-5, 1, at), new Vector3D(1, 0, 0)),
          new Ray(new Point3D(at, -5, -1), new Vector3D(-0f, 1, -0f)),
              new Ray(new Point3D(1, at, 5), new Vector3D(0, 0, -1)),
          new Ray(new Point3D(-1, 1, 9), new Vector3D(0, -0f, -1)))) {
        assertTrue(cube.intersectionWith(ray).hits(), ray::toString);
      }
    }
  }

  /** Some of them through the vertices, many through the edges and the diagonals of the faces. */
  @Test
  void gridOfParallelRaysThroughVerticesHits() {
    final TriangularMesh cube = ClosedMesh.cube().mesh();
    for (int i = -64; i <= 64; i++) {
      for (int j = -64; j <= 64; j++) {
        final Hit hit = cube.intersectionWith(new Ray(new Point3D(i / 64f, j / 64f, 3), new Vector3D(0, 0, -1)));
        assertEquals(2, hit.getT(), () -> hit.toString());
      }
    }
  }

  /**
   * A start outside, a vertex whose triangles all face it well: the ray at the vertex hits one of them, not what is behind.
   */
  @Test
  void raysAtVerticesSeenFromOutsideHitThemThere() {
    final RandomNumbers numbers = new RandomNumbers("vertices from outside");
    final ClosedMesh torus = ClosedMesh.torus(24, 12);
    final TriangularMesh mesh = torus.mesh();
    int seen = 0;
    for (int i = 0; i < RAYS; i++) {
      final int vertex = numbers.index(torus.coordinates().length / 3);
      final Point3D target = new Point3D(torus.coordinates()[3 * vertex], torus.coordinates()[3 * vertex + 1],
          torus.coordinates()[3 * vertex + 2]);
      final Ray ray = new Ray(numbers.pointAbout(new Point3D(), 10), target);
      if (torus.slantAt(vertex, ray) > 0.05) {
        seen++;
        final double distance = ray.getStartingPoint().distance(target);
        assertTrue(mesh.intersectionWith(ray).getT() <= distance * (1 + 1e-5), () -> "lost " + ray + ", " + numbers);
      }
    }
    assertTrue(seen > RAYS / 10, seen + " of " + RAYS);
  }
}
