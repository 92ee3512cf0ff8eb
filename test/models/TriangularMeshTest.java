package models;

import static models.HitAssertions.assertMiss;
import static models.HitAssertions.assertSameHit;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

import org.junit.jupiter.api.Test;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

class TriangularMeshTest implements Object3DContract {

  /** A square of side 2 in the plane z = 0, of two triangles, with indices that are not consecutive. */
  private static Map<Integer, Point3D> square() {
    final Map<Integer, Point3D> vertices = new HashMap<>();
    vertices.put(-7, new Point3D(-1, -1, 0));
    vertices.put(0, new Point3D(1, -1, 0));
    vertices.put(12, new Point3D(1, 1, 0));
    vertices.put(Integer.MAX_VALUE, new Point3D(-1, 1, 0));
    return vertices;
  }

  private static final List<String> FACETS = List.of("-7 0 12", "-7 12 2147483647");

  private static final Ray DOWN = new Ray(new Point3D(0.5f, -0.25f, 3), new Vector3D(0, 0, -1));

  /** A closed mesh, the cube from −1 to 1. */
  @Override
  public Object3D shape(final RandomPlacement at) {
    final ClosedMesh cube = ClosedMesh.cube();
    final Map<Integer, Point3D> vertices = new HashMap<>();
    final List<String> facets = new ArrayList<>();
    for (int i = 0; i < cube.triangles(); i++) {
      for (int k = 0; k < 3; k++) {
        final Point3D P = cube.vertex(i, k);
        vertices.put(cube.corners()[3 * i + k], at.point(P.x, P.y, P.z));
      }
      facets.add(cube.corners()[3 * i] + " " + cube.corners()[3 * i + 1] + " " + cube.corners()[3 * i + 2]);
    }
    return new TriangularMesh(vertices, facets);
  }

  @Override
  public double signedDistance(final double x, final double y, final double z) {
    final double a = Math.abs(x) - 1, b = Math.abs(y) - 1, c = Math.abs(z) - 1;
    return Math.min(Math.max(a, Math.max(b, c)), 0) + Math.hypot(Math.max(a, 0), Math.hypot(Math.max(b, 0), Math.max(c, 0)));
  }

  @Override
  public double accuracy() {
    return 1e-12;
  }

  @Test
  void rayHitsTheTriangleItCrosses() {
    final TriangularMesh mesh = new TriangularMesh(square(), FACETS, Color.CYAN);
    final Hit hit = mesh.intersectionWith(DOWN);
    assertEquals(3, hit.getT());
    assertEquals(new Point3D(0.5f, -0.25f, 0), hit.getPoint());
    assertEquals(new Vector3D(0, 0, 1), hit.getNormal());
    assertSame(mesh.getTriangles().get(0), hit.getObject());
    assertEquals(Color.CYAN, hit.getObject().getColor());
    assertMiss(mesh, new Ray(new Point3D(1.01f, 0, 3), new Vector3D(0, 0, -1)));
    assertMiss(mesh, new Ray(new Point3D(0, 0, 3), new Vector3D(0, 0, 1)));
  }

  @Test
  void raysAtTheSharedEdgeHitTheTriangleOfTheFirstFacet() {
    final TriangularMesh mesh = new TriangularMesh(square(), FACETS, Color.CYAN);
    for (int i = -8; i <= 8; i++) {
      final Hit hit = mesh.intersectionWith(new Ray(new Point3D(i / 8f, i / 8f, 3), new Vector3D(0, 0, -1)));
      assertSame(mesh.getTriangles().get(0), hit.getObject());
    }
  }

  @Test
  void facetsMayHaveBlanksCommasAndWhatObjFilesPutAfterASlash() {
    for (final String facet : List.of("-7 0 12", "-7,0,12", " -7\t0 , 12 ", "-7/5/7 0//3 12/1", "-7,\t0,,12",
        "-07 +0 012")) {
      final TriangularMesh mesh = new TriangularMesh(square(), List.of(facet), Color.CYAN);
      assertEquals("[Triangle(A=(-1.0, -1.0, 0.0), B=(1.0, -1.0, 0.0), C=(1.0, 1.0, 0.0))]", mesh.getTriangles().toString());
    }
  }

  @Test
  void facetsWithoutAreaAreLeftOut() {
    final Map<Integer, Point3D> vertices = square();
    vertices.put(5, new Point3D(0, -1, 0));
    final TriangularMesh mesh = new TriangularMesh(vertices, List.of("-7 5 0", "0 0 12", "-7 0 12", "12 12 12"), Color.CYAN);
    assertEquals(1, mesh.getTriangles().size());
    assertTrue(mesh.intersectionWith(DOWN).hits());
    assertEquals("TriangularMesh(1 triangles)", mesh.toString());
  }

  @Test
  void meshOfOneColourHasItAndOneOfManyHasNone() {
    assertEquals(Color.CYAN, new TriangularMesh(square(), FACETS, Color.CYAN).getColor());
    assertNull(new TriangularMesh(square(), FACETS).getColor());
  }

  @Test
  void sameMeshGetsTheSameRandomColoursWhateverIsBuiltBetween() {
    final TriangularMesh mesh = new TriangularMesh(square(), FACETS);
    new TriangularMesh(square(), List.of("0 12 -7"));
    ClosedMesh.cube().mesh();
    final TriangularMesh again = new TriangularMesh(square(), FACETS);
    for (int i = 0; i < 2; i++) {
      assertEquals(mesh.getTriangles().get(i).getColor(), again.getTriangles().get(i).getColor());
      assertEquals(255, mesh.getTriangles().get(i).getColor().getAlpha());
    }
    assertNotEquals(mesh.getTriangles().get(0).getColor(), mesh.getTriangles().get(1).getColor());
    assertEquals(mesh.getTriangles().get(0).getColor(), mesh.intersectionWith(DOWN).getObject().getColor());
  }

  @Test
  void theFirstColoursAreTheSameInEveryRun() {
    final List<Triangle> triangles = new TriangularMesh(square(), FACETS).getTriangles();
    assertEquals(new Color(new java.util.SplittableRandom(0).nextInt(1 << 24)), triangles.get(0).getColor());
    assertEquals(new Color(new java.util.SplittableRandom(1).nextInt(1 << 24)), triangles.get(1).getColor());
  }

  @Test
  void trianglesAreAlwaysTheSameObjectsInTheOrderOfTheFacets() {
    final TriangularMesh mesh = ClosedMesh.icosphere(2).mesh();
    final List<Triangle> triangles = mesh.getTriangles();
    for (int i = 0; i < triangles.size(); i++) {
      assertSame(triangles.get(i), mesh.getTriangles().get(i));
      assertTrue(triangles.get(i).toString().contains("A=" + ClosedMesh.icosphere(2).vertex(i, 0)));
    }
    assertThrows(IndexOutOfBoundsException.class, () -> triangles.get(triangles.size()));
    assertThrows(UnsupportedOperationException.class, () -> triangles.remove(0));
  }

  @Test
  void laterChangesOfTheArgumentsChangeNothing() {
    final Map<Integer, Point3D> vertices = square();
    final List<String> facets = new ArrayList<>(FACETS);
    final float[] coordinates = {-1, -1, 0, 1, -1, 0, 1, 1, 0};
    final int[] corners = {0, 1, 2};
    final TriangularMesh mesh = new TriangularMesh(vertices, facets, Color.CYAN);
    final TriangularMesh ofArrays = TriangularMesh.of(coordinates, corners, Color.CYAN);
    vertices.get(0).set(9, 9, 9);
    vertices.clear();
    facets.clear();
    java.util.Arrays.fill(coordinates, 5);
    java.util.Arrays.fill(corners, 0);
    assertEquals(3, mesh.intersectionWith(DOWN).getT());
    assertEquals(3, ofArrays.intersectionWith(DOWN).getT());
    assertEquals("Triangle(A=(-1.0, -1.0, 0.0), B=(1.0, -1.0, 0.0), C=(1.0, 1.0, 0.0))",
        ofArrays.getTriangles().get(0).toString());
  }

  @Test
  void boxIsThatOfTheTrianglesWithoutUnusedVertices() {
    final Map<Integer, Point3D> vertices = square();
    vertices.put(99, new Point3D(100, 100, 100));
    assertEquals("BoundingBox((-1.0, -1.0, 0.0), (1.0, 1.0, 0.0))",
        new TriangularMesh(vertices, FACETS, Color.CYAN).getBoundingBox().toString());
  }

  @Test
  void agreesWithAskingAllTrianglesBitForBit() {
    final RandomNumbers numbers = new RandomNumbers("mesh by linear scan");
    int hits = 0;
    for (final ClosedMesh closed : List.of(ClosedMesh.cube(), ClosedMesh.icosphere(2), ClosedMesh.torus(12, 7),
        ClosedMesh.torus(20, 9).moved(1, 100, 0, -50), soup(numbers, 1), soup(numbers, 2), soup(numbers, 3),
            soup(numbers, 300))) {
      final TriangularMesh mesh = closed.mesh();
      final ContractRays rays = new ContractRays(numbers, closed.vertex(0, 0), 4);
      for (int i = 0; i < RandomNumbers.times(2000); i++) {
        final Ray ray = i % 2 == 0 ? rays.next() : new Ray(numbers.pointAbout(mesh.getBoundingBox().getMax(), 5),
            closed.vertex(numbers.index(closed.triangles()), numbers.index(3)));
        final Hit expected = Scan.closest(mesh.getTriangles(), ray);
        hits += expected.hits() ? 1 : 0;
        assertSameHit(expected, mesh.intersectionWith(ray), closed + ", " + ray + ", " + numbers);
      }
    }
    assertTrue(hits > RandomNumbers.times(4000), hits + " hits");
  }

  /** Triangles at random, crossing each other, some of them twice. */
  private static ClosedMesh soup(final RandomNumbers numbers, final int triangles) {
    final float[] coordinates = new float[9 * triangles];
    final int[] corners = new int[6 * triangles];
    for (int i = 0; i < coordinates.length; i++) {
      coordinates[i] = (float) numbers.between(-3, 3);
    }
    for (int i = 0; i < corners.length; i++) {
      corners[i] = i % (3 * triangles);
    }
    return new ClosedMesh("soup of " + triangles, coordinates, corners);
  }
}
