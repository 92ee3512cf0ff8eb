package upnatray;

import java.awt.Color;
import java.util.SplittableRandom;

import models.TriangularMesh;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;
import view.Camera;
import view.Perspective;

/** What the benchmarks look at: rays about the origin, meshes of any size, a camera that sees them. */
final class BenchmarkScene {

  private BenchmarkScene() {
  }

  /** Rays from a sphere of radius 5 to points of the unit ball: about as many hits as misses. */
  static Ray[] rays(final int n) {
    final SplittableRandom random = new SplittableRandom(1);
    final Ray[] rays = new Ray[n];
    for (int i = 0; i < n; i++) {
      final double z = random.nextDouble(-1, 1), angle = random.nextDouble(2 * Math.PI), s = Math.sqrt(1 - z * z);
      rays[i] = new Ray(new Point3D((float) (5 * s * Math.cos(angle)), (float) (5 * s * Math.sin(angle)), (float) (5 * z)),
          new Point3D((float) random.nextDouble(-1, 1), (float) random.nextDouble(-1, 1), (float) random.nextDouble(-1, 1)));
    }
    return rays;
  }

  /** A rippled torus of at least so many triangles: a closed mesh without regular order in depth. */
  static float[] coordinates(final int triangles) {
    final int side = side(triangles);
    final float[] coordinates = new float[3 * side * side];
    for (int i = 0, at = 0; i < side; i++) {
      final double a = 2 * Math.PI * i / side;
      for (int j = 0; j < side; j++) {
        final double b = 2 * Math.PI * j / side, r = 0.5 + 0.05 * Math.sin(13 * a) * Math.sin(7 * b);
        coordinates[at++] = (float) ((1.3 + r * Math.cos(b)) * Math.cos(a));
        coordinates[at++] = (float) (r * Math.sin(b));
        coordinates[at++] = (float) ((1.3 + r * Math.cos(b)) * Math.sin(a));
      }
    }
    return coordinates;
  }

  static int[] corners(final int triangles) {
    final int side = side(triangles);
    final int[] corners = new int[6 * side * side];
    for (int i = 0, at = 0; i < side; i++) {
      for (int j = 0; j < side; j++) {
        final int k = (i + 1) % side, l = (j + 1) % side;
        final int from = i * side + j, to = k * side + l;
        for (final int vertex : new int[] {from, i * side + l, to, from, to, k * side + j}) {
          corners[at++] = vertex;
        }
      }
    }
    return corners;
  }

  private static int side(final int triangles) {
    return (int) Math.ceil(Math.sqrt(triangles / 2.0));
  }

  static TriangularMesh mesh(final int triangles) {
    return TriangularMesh.of(coordinates(triangles), corners(triangles), Color.ORANGE);
  }

  static Camera camera() {
    final Camera camera = new Camera(new Point3D(0, 3, 4), new Point3D(0, 0, 0), new Vector3D(0, 1, 0));
    camera.setProjection(new Perspective(45, 1));
    return camera;
  }
}
