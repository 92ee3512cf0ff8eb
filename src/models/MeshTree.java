package models;

import acceleration.Bvh;
import acceleration.SegmentTile;
import acceleration.TileFrustum;
import primitives.BoundingBox;
import primitives.Point3D;
import tracer.Ray;

/**
 * The triangles of a mesh in the order of a tree of their boxes, so that those close together in space lie close together
 * in memory. A triangle is identified by its place in this order, and to others by the number of its facet.
 */
final class MeshTree {

  /** Triangles per leaf: fewer cost memory and node fetches, more cost tests. */
  private static final int LEAF = Bvh.MOST_IN_LEAF;

  /** In double, as used in computations: converting floats would make each triangle depend on the one before. */
  private final double[] coordinates;
  private final int[] corners;
  private final int[] facets;
  private final Bvh tree;
  private final BoundingBox box;

  /** The place of each facet; computed when first needed. */
  private volatile int[] places;

  MeshTree(final MeshArrays arrays) {
    facets = new int[arrays.corners.length / 3];
    final float[] boxes = boxes(arrays);
    box = union(boxes);
    tree = Bvh.over(boxes, LEAF, facets);
    corners = new int[arrays.corners.length];
    coordinates = new double[arrays.coordinates.length];
    arrange(arrays);
  }

  /** Takes triangles in the order of the tree, and vertices in the order in which these triangles use them. */
  private void arrange(final MeshArrays arrays) {
    final int[] moved = new int[arrays.coordinates.length / 3];
    int end = 0;
    for (int i = 0; i < corners.length; i++) {
      final int from = arrays.corners[3 * facets[i / 3] + i % 3];
      if (moved[from / 3] == 0) {
        coordinates[end++] = arrays.coordinates[from];
        coordinates[end++] = arrays.coordinates[from + 1];
        coordinates[end++] = arrays.coordinates[from + 2];
        moved[from / 3] = end;
      }
      corners[i] = moved[from / 3] - 3;
    }
  }

  private static float[] boxes(final MeshArrays arrays) {
    final float[] boxes = new float[2 * arrays.corners.length], v = arrays.coordinates;
    for (int i = 0; i < arrays.corners.length; i += 3) {
      final int a = arrays.corners[i], b = arrays.corners[i + 1], c = arrays.corners[i + 2];
      for (int k = 0; k < 3; k++) {
        boxes[2 * i + k] = Math.min(v[a + k], Math.min(v[b + k], v[c + k]));
        boxes[2 * i + 3 + k] = Math.max(v[a + k], Math.max(v[b + k], v[c + k]));
      }
    }
    return boxes;
  }

  private static BoundingBox union(final float[] boxes) {
    final float[] all = java.util.Arrays.copyOf(boxes, 6);
    for (int i = 6; i < boxes.length; i += 6) {
      for (int k = 0; k < 3; k++) {
        all[k] = Math.min(all[k], boxes[i + k]);
        all[k + 3] = Math.max(all[k + 3], boxes[i + 3 + k]);
      }
    }
    return new BoundingBox(new Point3D(all[0], all[1], all[2]), new Point3D(all[3], all[4], all[5]));
  }

  int size() {
    return facets.length;
  }

  BoundingBox box() {
    return box;
  }

  /** Greatest error that the sign of an edge can have, seen from a point. */
  double error(final double x, final double y, final double z) {
    return WatertightTest.error(box, x, y, z);
  }

  /** Greatest coordinate of a vertex, seen from a point. */
  double greatest(final double x, final double y, final double z) {
    return WatertightTest.greatest(box, x, y, z);
  }

  /** Whether the triangle at a place lies on a ray before a distance; the error is that of the ray's start. */
  boolean blocks(final int place, final double x, final double y, final double z,
      final double dx, final double dy, final double dz, final double error, final double tmax) {
    final int a = vertex(place, 0), b = vertex(place, 1), c = vertex(place, 2);
    final double t = WatertightTest.distance(
        coordinates[a] - x, coordinates[a + 1] - y, coordinates[a + 2] - z,
        coordinates[b] - x, coordinates[b + 1] - y, coordinates[b + 2] - z,
        coordinates[c] - x, coordinates[c + 1] - y, coordinates[c + 2] - z, dx, dy, dz, error);
    return t > 0 && t < tmax;
  }

  /**
   * {@link #blocks(int, double, double, double, double, double, double, double, double) The same}, which asks first whether
   * the triangle's plane lies on the ray: that of the triangle that the ray leaves does not.
   */
  boolean blocks(final int place, final double x, final double y, final double z,
      final double dx, final double dy, final double dz, final double tmax) {
    final int a = vertex(place, 0), b = vertex(place, 1), c = vertex(place, 2);
    final double ax = coordinates[a] - x, ay = coordinates[a + 1] - y, az = coordinates[a + 2] - z;
    final double bx = coordinates[b] - x, by = coordinates[b + 1] - y, bz = coordinates[b + 2] - z;
    final double cx = coordinates[c] - x, cy = coordinates[c + 1] - y, cz = coordinates[c + 2] - z;
    final double t = WatertightTest.planeDistance(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz);
    return t > 0 && t < tmax
        && WatertightTest.distance(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz, error(x, y, z)) == t;
  }

  void closest(final Ray ray, final Bvh.Leaves leaves) {
    tree.closest(ray.startX(), ray.startY(), ray.startZ(), ray.directionX(), ray.directionY(), ray.directionZ(), leaves);
  }

  boolean any(final Ray ray, final double tmax, final Bvh.AnyLeaves leaves) {
    return tree.any(ray.startX(), ray.startY(), ray.startZ(), ray.directionX(), ray.directionY(), ray.directionZ(), tmax,
        leaves);
  }

  void closest(final TileFrustum frustum, final Bvh.Leaves leaves) {
    tree.closest(frustum, leaves);
  }

  void block(final SegmentTile segments, final Bvh.Leaves leaves) {
    tree.block(segments, leaves);
  }

  int facet(final int place) {
    return facets[place];
  }

  /** Where in the coordinates a vertex, 0, 1 or 2, of the triangle at a place begins. */
  int vertex(final int place, final int which) {
    return corners[3 * place + which];
  }

  double coordinate(final int at) {
    return coordinates[at];
  }

  Triangle triangle(final int facet, final Appearance appearance) {
    final int place = places()[facet];
    return new Triangle(coordinates, vertex(place, 0), vertex(place, 1), vertex(place, 2), appearance);
  }

  private int[] places() {
    int[] known = places;
    if (known == null) {
      known = new int[facets.length];
      for (int i = 0; i < facets.length; i++) {
        known[facets[i]] = i;
      }
      places = known;
    }
    return known;
  }
}
