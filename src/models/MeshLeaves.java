package models;

import acceleration.Bvh;
import acceleration.TileFrustum;

/**
 * Visits the leaves of the tree of a mesh, and projects each triangle by a frustum: triangles that some of its rays may
 * hit are tested.
 */
abstract class MeshLeaves implements Bvh.Leaves {

  final MeshTree mesh;
  final TileFrustum frustum;

  /** The origin of the frustum. */
  final double x;
  final double y;
  final double z;

  MeshLeaves(final MeshTree mesh, final TileFrustum frustum) {
    this.mesh = mesh;
    this.frustum = frustum;
    this.x = frustum.originX();
    this.y = frustum.originY();
    this.z = frustum.originZ();
  }

  @Override
  public final double visit(final int first, final int end) {
    for (int place = first; place < end; place++) {
      final int a = mesh.vertex(place, 0), b = mesh.vertex(place, 1), c = mesh.vertex(place, 2);
      final double ax = mesh.coordinate(a) - x, ay = mesh.coordinate(a + 1) - y, az = mesh.coordinate(a + 2) - z;
      final double bx = mesh.coordinate(b) - x, by = mesh.coordinate(b + 1) - y, bz = mesh.coordinate(b + 2) - z;
      final double cx = mesh.coordinate(c) - x, cy = mesh.coordinate(c + 1) - y, cz = mesh.coordinate(c + 2) - z;
      if (frustum.project(ax, ay, az, bx, by, bz, cx, cy, cz)) {
        test(place, ax, ay, az, bx, by, bz, cx, cy, cz);
      }
    }
    return farthest();
  }

  /** Tests the rays in the frustum's window against a triangle, whose vertices are given relative to the origin. */
  abstract void test(int place, double ax, double ay, double az, double bx, double by, double bz,
      double cx, double cy, double cz);

  /** The distance beyond which nothing matters any more. */
  abstract double farthest();
}
