package models;

import acceleration.Bvh;
import tracer.Ray;

/** The closest triangle of a mesh on one ray; of two at the same distance, that of the facet of lower number. */
final class MeshRay implements Bvh.Leaves {

  private final Ray ray;
  private final MeshTree mesh;
  private final double error;
  private double t = Double.POSITIVE_INFINITY;
  private int facet = -1;

  MeshRay(final Ray ray, final MeshTree mesh) {
    this(mesh, ray);
    mesh.closest(ray, this);
  }

  /** A query. */
  private MeshRay(final MeshTree mesh, final Ray ray) {
    this.ray = ray;
    this.mesh = mesh;
    this.error = mesh.error(ray.startX(), ray.startY(), ray.startZ());
  }

  /** Number of triangles that are tested. */
  static int cost(final Ray ray, final MeshTree mesh) {
    final MeshRay query = new MeshRay(mesh, ray);
    final int[] cost = new int[1];
    mesh.closest(ray, (first, end) -> {
      cost[0] += end - first;
      return query.visit(first, end);
    });
    return cost[0];
  }

  /** Whether a triangle is hit before a distance. */
  static boolean hitsBefore(final Ray ray, final double tmax, final MeshTree mesh) {
    final double x = ray.startX(), y = ray.startY(), z = ray.startZ();
    final double dx = ray.directionX(), dy = ray.directionY(), dz = ray.directionZ();
    final double error = mesh.error(x, y, z);
    return mesh.any(ray, tmax, (first, end) -> {
      for (int place = first; place < end; place++) {
        if (mesh.blocks(place, x, y, z, dx, dy, dz, error, tmax)) {
          return true;
        }
      }
      return false;
    });
  }

  boolean hits() {
    return facet >= 0;
  }

  double distance() {
    return t;
  }

  int facet() {
    return facet;
  }

  @Override
  public double visit(final int first, final int end) {
    for (int place = first; place < end; place++) {
      test(place);
    }
    return t * ClosestHit.SAME;
  }

  private double distanceTo(final int place) {
    final double x = ray.startX(), y = ray.startY(), z = ray.startZ();
    final int a = mesh.vertex(place, 0), b = mesh.vertex(place, 1), c = mesh.vertex(place, 2);
    return WatertightTest.distance(
        mesh.coordinate(a) - x, mesh.coordinate(a + 1) - y, mesh.coordinate(a + 2) - z,
        mesh.coordinate(b) - x, mesh.coordinate(b + 1) - y, mesh.coordinate(b + 2) - z,
        mesh.coordinate(c) - x, mesh.coordinate(c + 1) - y, mesh.coordinate(c + 2) - z,
        ray.directionX(), ray.directionY(), ray.directionZ(), error);
  }

  private void test(final int place) {
    final double distance = distanceTo(place);
    final float f = (float) distance, best = (float) t;
    if (f > 0 && (f < best || f == best && mesh.facet(place) < facet)) {
      t = distance;
      facet = mesh.facet(place);
    }
  }
}
