package models;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Color;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

import org.junit.jupiter.api.Test;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;
import trials.Trials;

/** Averages of the facets around a vertex, by the formula and in every order. */
class AveragedNormalsTest {

  private static final int[] ONE = {0};

  private static Hit down(final TriangularMesh mesh, final double x, final double y) {
    return mesh.intersectionWith(new Ray(new Point3D((float) x, (float) y, 3), new Vector3D(0, 0, -1)));
  }

  /** The same whatever the order of the facets and of their corners, and steady across edges. */
  @Test
  void averagesDoNotDependOnTheOrder() {
    Trials.of(30, random -> {
      final Map<Integer, Point3D> vertices = new HashMap<>();
      for (int i = 0; i < 36; i++) {
        vertices.put(i, new Point3D(i % 6, i / 6, random.nextFloat()));
      }
      final List<String> facets = new ArrayList<>(), shuffled = new ArrayList<>();
      for (int i = 0; i < 30; i++) {
        if (i % 6 < 5) {
          facets.add(i + " " + (i + 1) + " " + (i + 6));
          facets.add((i + 1) + " " + (i + 7) + " " + (i + 6));
        }
      }
      for (final String facet : facets) {
        final List<String> corners = new ArrayList<>(List.of(facet.split(" ")));
        Collections.rotate(corners, random.nextInt(3));
        shuffled.add(String.join(" ", corners));
      }
      Collections.shuffle(shuffled, random);
      final TriangularMesh mesh = new TriangularMesh(vertices, Map.of(), facets, Color.RED);
      final TriangularMesh other = new TriangularMesh(vertices, Map.of(), shuffled, Color.RED);
      for (int i = 0; i < 100; i++) {
        final double x = 5 * random.nextDouble(), y = 5 * random.nextDouble();
        final Hit hit = down(mesh, x, y), same = down(other, x, y);
        assertEquals(hit.normalX(), same.normalX(), 1e-12);
        assertEquals(hit.normalY(), same.normalY(), 1e-12);
        assertEquals(hit.normalZ(), same.normalZ(), 1e-12);
        assertEquals(hit.getT(), same.getT());
      }
      final double y = 5 * random.nextDouble();
      assertEquals(down(mesh, 2 - 1e-6, y).normalX(), down(mesh, 2 + 1e-6, y).normalX(), 1e-4);
    });
  }

  /** unit(Σ F), where F is the vector area of a facet: so larger facets weigh more. */
  @Test
  void averageIsTheUnitVectorOfTheSumOfVectorAreas() {
    Trials.of(200, random -> {
      final AveragedNormals normals = new AveragedNormals();
      final double[] sum = new double[3];
      for (int i = 0; i < 5; i++) {
        final double[] area = {random.nextGaussian(), random.nextGaussian(), 3 + random.nextGaussian()};
        normals.add(area[0], area[1], area[2], new int[] {7, 2, 4}, 3);
        for (int k = 0; k < 3; k++) {
          sum[k] += area[k];
        }
      }
      final double length = Math.sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
      final float x = (float) (sum[0] / length), y = (float) (sum[1] / length), z = (float) (sum[2] / length);
      assertArrayEquals(new float[] {0, 0, 0, 0, 0, 0, x, y, z, 0, 0, 0, x, y, z, 0, 0, 0, 0, 0, 0, x, y, z},
          normals.of(8), 1e-6f);
    });
  }

  /** A bridge to a hole names its two ends twice; they are corners of one facet all the same. */
  @Test
  void aVertexThatAFacetNamesTwiceCountsOnce() {
    for (final int number : new int[] {4, 15, 16, 17, 30}) {
      final int[] vertices = new int[number];
      for (int i = 0; i < number; i++) {
        vertices[i] = (7 * i + 3) % number;
      }
      vertices[number - 1] = vertices[1];
      final AveragedNormals normals = new AveragedNormals();
      normals.add(2, 0, 0, vertices, number);
      normals.add(0, 2, 0, new int[] {vertices[1], vertices[0]}, 2);
      final float root = (float) Math.sqrt(0.5);
      final float[] averages = normals.of(number);
      for (final int corner : new int[] {vertices[0], vertices[1]}) {
        assertArrayEquals(new float[] {root, root, 0},
            new float[] {averages[3 * corner], averages[3 * corner + 1], averages[3 * corner + 2]}, 1e-6f);
      }
      assertEquals(1, averages[3 * vertices[2]]);
    }
  }

  /** What is left of two facets that cancel is a direction if it is more than a millionth of their areas. */
  @Test
  void facetsThatCancelHaveNoAverage() {
    for (int axis = 0; axis < 3; axis++) {
      for (final boolean cancels : new boolean[] {true, false}) {
        final double left = cancels ? 1e-6 : 3e-6;
        final AveragedNormals normals = new AveragedNormals();
        for (final double area : new double[] {5, -5 * (1 - left)}) {
          normals.add(axis == 0 ? area : 0, axis == 1 ? area : 0, axis == 2 ? area : 0, ONE, 1);
        }
        final float[] expected = new float[3];
        expected[axis] = cancels ? 0 : 1;
        assertArrayEquals(expected, normals.of(1));
      }
    }
    final AveragedNormals huge = new AveragedNormals();
    huge.add(1e300, 1e300, 0, ONE, 1);
    assertArrayEquals(new float[3], huge.of(1), "a length that no double holds is no direction");
  }

  @Test
  void thereIsRoomForAnyNumberOfVertices() {
    final AveragedNormals normals = new AveragedNormals();
    for (final int vertex : new int[] {0, 1023, 1024, 1151, 1152, 1153, 200_000}) {
      normals.add(0, 0, 4, new int[] {vertex}, 1);
    }
    final float[] averages = normals.of(400_000);
    assertEquals(7, Collections.frequency(asList(averages), 1f));
    assertEquals(1, averages[3 * 200_000 + 2]);
    assertEquals(1, averages[3 * 1024 + 2]);
  }

  private static List<Float> asList(final float[] numbers) {
    final List<Float> list = new ArrayList<>();
    for (final float number : numbers) {
      list.add(number);
    }
    return list;
  }
}
