package models;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

import primitives.Point3D;
import tracer.Ray;

/**
 * Closed surfaces of triangles for tests: vertices and, counter-clockwise seen from outside, three vertex numbers for each
 * triangle.
 */
record ClosedMesh(String name, float[] coordinates, int[] corners) {

  static ClosedMesh tetrahedron() {
    return new ClosedMesh("tetrahedron", new float[] {1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1},
        new int[] {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
  }

  static ClosedMesh cube() {
    final float[] coordinates = new float[24];
    for (int i = 0; i < 24; i++) {
      coordinates[i] = (i / 3 >> i % 3 & 1) * 2 - 1;
    }
    return new ClosedMesh("cube", coordinates, new int[] {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
        2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5});
  }

  static ClosedMesh octahedron() {
    return new ClosedMesh("octahedron", new float[] {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1},
        new int[] {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5});
  }

  /** A sphere of radius 1: an octahedron whose triangles are divided in four a number of times. */
  static ClosedMesh icosphere(final int times) {
    ClosedMesh mesh = octahedron();
    for (int i = 0; i < times; i++) {
      mesh = mesh.divided();
    }
    return mesh;
  }

  private ClosedMesh divided() {
    final List<Float> points = new ArrayList<>();
    for (final float c : coordinates) {
      points.add(c);
    }
    final Map<Long, Integer> middles = new HashMap<>();
    final int[] finer = new int[4 * corners.length];
    for (int i = 0; i < corners.length; i += 3) {
      final int a = corners[i], b = corners[i + 1], c = corners[i + 2];
      final int ab = middle(a, b, points, middles), bc = middle(b, c, points, middles), ca = middle(c, a, points, middles);
      System.arraycopy(new int[] {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca}, 0, finer, 4 * i, 12);
    }
    final float[] all = new float[points.size()];
    for (int i = 0; i < all.length; i++) {
      all[i] = points.get(i);
    }
    return new ClosedMesh("icosphere of " + finer.length / 3 + " triangles", all, finer);
  }

  private static int middle(final int a, final int b, final List<Float> points, final Map<Long, Integer> middles) {
    return middles.computeIfAbsent((long) Math.min(a, b) << 32 | Math.max(a, b), key -> {
      final double[] m = new double[3];
      for (int k = 0; k < 3; k++) {
        m[k] = (double) points.get(3 * a + k) + points.get(3 * b + k);
      }
      final double length = Math.sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
      for (int k = 0; k < 3; k++) {
        points.add((float) (m[k] / length));
      }
      return points.size() / 3 - 1;
    });
  }

  /** A torus about the z axis, with R = 3 and r = 1. */
  static ClosedMesh torus(final int along, final int around) {
    final float[] coordinates = new float[3 * along * around];
    final int[] corners = new int[6 * along * around];
    for (int i = 0; i < along; i++) {
      for (int j = 0; j < around; j++) {
        final double a = 2 * Math.PI * i / along, b = 2 * Math.PI * j / around, rho = 3 + Math.cos(b);
        final int at = i * around + j, east = (i + 1) % along * around + j, north = i * around + (j + 1) % around,
            both = (i + 1) % along * around + (j + 1) % around;
        coordinates[3 * at] = (float) (rho * Math.cos(a));
        coordinates[3 * at + 1] = (float) (rho * Math.sin(a));
        coordinates[3 * at + 2] = (float) Math.sin(b);
        System.arraycopy(new int[] {at, east, both, at, both, north}, 0, corners, 6 * at, 6);
      }
    }
    return new ClosedMesh("torus of " + corners.length / 3 + " triangles", coordinates, corners);
  }

  /** The same, scaled, then translated. */
  ClosedMesh moved(final float factor, final float x, final float y, final float z) {
    final float[] by = {x, y, z}, to = new float[coordinates.length];
    for (int i = 0; i < to.length; i++) {
      to[i] = coordinates[i] * factor + by[i % 3];
    }
    return new ClosedMesh(name + " times " + factor + " at " + Arrays.toString(by), to, corners);
  }

  /** The same with each vertex displaced at random, by at most a fraction of the size. */
  ClosedMesh shaken(final RandomNumbers numbers, final double part) {
    final float[] to = new float[coordinates.length];
    for (int i = 0; i < to.length; i++) {
      to[i] = (float) (coordinates[i] + part * numbers.between(-1, 1));
    }
    return new ClosedMesh("shaken " + name, to, corners);
  }

  TriangularMesh mesh() {
    return TriangularMesh.of(coordinates, corners, java.awt.Color.WHITE);
  }

  int triangles() {
    return corners.length / 3;
  }

  Point3D vertex(final int triangle, final int corner) {
    final int at = 3 * corners[3 * triangle + corner];
    return new Point3D(coordinates[at], coordinates[at + 1], coordinates[at + 2]);
  }

  /** The point of a triangle with these weights of its vertices, rounded to floats. */
  Point3D point(final int triangle, final double u, final double v, final double w) {
    final Point3D a = vertex(triangle, 0), b = vertex(triangle, 1), c = vertex(triangle, 2);
    return new Point3D((float) (u * a.x + v * b.x + w * c.x), (float) (u * a.y + v * b.y + w * c.y),
        (float) (u * a.z + v * b.z + w * c.z));
  }

  /** Least sine of the angle between a ray and the triangles about a vertex, if it enters through all of them; else 0. */
  double slantAt(final int vertex, final Ray ray) {
    double least = 1;
    for (int i = 0; i < corners.length; i += 3) {
      if (corners[i] == vertex || corners[i + 1] == vertex || corners[i + 2] == vertex) {
        final Normal n = normal(i / 3);
        least = Math.min(least, -(n.x * ray.directionX() + n.y * ray.directionY() + n.z * ray.directionZ()));
      }
    }
    return Math.max(0, least);
  }

  /** Unit normal of a triangle. */
  Normal normal(final int triangle) {
    final Point3D a = vertex(triangle, 0), b = vertex(triangle, 1), c = vertex(triangle, 2);
    final double px = (double) b.x - a.x, py = (double) b.y - a.y, pz = (double) b.z - a.z;
    final double qx = (double) c.x - a.x, qy = (double) c.y - a.y, qz = (double) c.z - a.z;
    final double x = py * qz - pz * qy, y = pz * qx - px * qz, z = px * qy - py * qx, s = Math.sqrt(x * x + y * y + z * z);
    return new Normal(x / s, y / s, z / s);
  }

  @Override
  public String toString() {
    return name;
  }

  /** A unit vector. */
  record Normal(double x, double y, double z) {
  }
}
