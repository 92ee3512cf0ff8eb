package models;

import acceleration.RayTile;
import acceleration.TileCoverage;
import acceleration.TileWindow;

/**
 * The closest triangles of a mesh on the rays of a tile. A triangle of a leaf is projected into the tile, and only the rays
 * of the pixels that it may cover are tested. If the rays share a start, what the test needs of a triangle is computed once
 * for all of them. The numbers are those of {@link WatertightTest#distance}, bit for bit.
 */
final class MeshTile extends MeshLeaves {

  /** Pixels of a window up to which it is quicker to look at each ray than at the grid. */
  private static final int FEW = 24;

  private final RayTile rays;
  private final TileWindow window;
  private final TileCoverage coverage;
  private final TileHits hits;
  private final int source;
  private final double error;

  MeshTile(final RayTile rays, final TileHits hits, final TriangularMesh owner, final MeshTree mesh) {
    super(mesh, rays.frustum());
    this.rays = rays;
    this.window = rays.window();
    this.coverage = frustum.coverage();
    this.hits = hits;
    this.source = hits.source(owner, owner);
    this.error = mesh.error(x, y, z);
  }

  void findHits() {
    if (frustum.isFitted()) {
      mesh.closest(frustum, this);
    } else {
      rayByRay();
    }
  }

  private void rayByRay() {
    for (int row = 0; row < rays.rows(); row++) {
      for (int i = row * RayTile.SIZE; i < row * RayTile.SIZE + rays.columns(); i++) {
        if (rays.isPresent(i)) {
          final MeshRay query = new MeshRay(hits.ray(i), mesh);
          if (query.hits() && hits.isCloser(i, query.distance(), query.facet())) {
            hits.take(i, query.distance(), source, query.facet());
          }
        }
      }
    }
  }

  @Override
  double farthest() {
    return hits.farthest();
  }

  @Override
  void test(final int place, final double ax, final double ay, final double az,
      final double bx, final double by, final double bz, final double cx, final double cy, final double cz) {
    if (frustum.isPyramid()) {
      testTogether(place, ax, ay, az, bx, by, bz, cx, cy, cz);
    } else {
      testEach(place);
    }
  }

  /**
   * Rays with one start: the edges' products and the plane are the same for all, and so is the side from which they see the
   * triangle, which is the sign that the three edges must have for a hit. The rays that may have it are found without a
   * branch that the processor could guess wrong; then the few hits are looked at one by one.
   */
  private void testTogether(final int place, final double ax, final double ay, final double az,
      final double bx, final double by, final double bz, final double cx, final double cy, final double cz) {
    final double px = bx - ax, py = by - ay, pz = bz - az, qx = cx - ax, qy = cy - ay, qz = cz - az;
    final double nx = py * qz - pz * qy, ny = pz * qx - px * qz, nz = px * qy - py * qx;
    final double plane = ax * nx + ay * ny + az * nz, s = Math.copySign(1, plane);
    final double ex = s * (by * cz - bz * cy), ey = s * (bz * cx - bx * cz), ez = s * (bx * cy - by * cx);
    final double fx = s * (cy * az - cz * ay), fy = s * (cz * ax - cx * az), fz = s * (cx * ay - cy * ax);
    final double gx = s * (ay * bz - az * by), gy = s * (az * bx - ax * bz), gz = s * (ax * by - ay * bx);
    final int firstColumn = window.firstColumn(), lastRow = window.lastRow(), facet = mesh.facet(place);
    final int width = window.lastColumn() - firstColumn + 1, atOnce = 64 / width & ~1;
    final boolean many = width * (lastRow - window.firstRow() + 1) > FEW;
    if (many) {
      coverage.begin(ex, ey, ez, fx, fy, fz, gx, gy, gz, error);
    }
    for (int row = window.firstRow(); row <= lastRow; row += atOnce) {
      final int first = row * RayTile.SIZE + firstColumn, n = Math.min(atOnce, lastRow - row + 1);
      long mask = many ? coverage.next(n) : few(first, width, n * width, ex, ey, ez, fx, fy, fz, gx, gy, gz), doubtful = 0;
      for (; mask != 0; mask &= mask - 1) {
        final int k = Long.numberOfTrailingZeros(mask), i = first + k / width * RayTile.SIZE + k % width;
        final double dx = rays.directionX(i), dy = rays.directionY(i), dz = rays.directionZ(i);
        final double e = dx * ex + dy * ey + dz * ez, f = dx * fx + dy * fy + dz * fz, g = dx * gx + dy * gy + dz * gz;
        if (e > error && f > error && g > error) {
          offer(i, facet, plane / (dx * nx + dy * ny + dz * nz));
        } else if (e >= -error && f >= -error && g >= -error) {
          doubtful |= mask & -mask;
        }
      }
      for (; doubtful != 0; doubtful &= doubtful - 1) {
        final int k = Long.numberOfTrailingZeros(doubtful);
        testExactly(first + k / width * RayTile.SIZE + k % width, place);
      }
    }
  }

  /** Looks at each ray of some rows of few pixels; returns those that may have the three signs, as bits. */
  private long few(final int first, final int width, final int pixels, final double ex, final double ey, final double ez,
      final double fx, final double fy, final double fz, final double gx, final double gy, final double gz) {
    long mask = 0;
    for (int k = 0, i = first, column = 1; k < pixels; k++) {
      final double dx = rays.directionX(i), dy = rays.directionY(i), dz = rays.directionZ(i);
      final long signs = Double.doubleToRawLongBits(dx * ex + dy * ey + dz * ez + error)
          | Double.doubleToRawLongBits(dx * fx + dy * fy + dz * fz + error)
          | Double.doubleToRawLongBits(dx * gx + dy * gy + dz * gz + error);
      mask |= (~signs >>> 63) << k;
      final int endOfRow = width - 1 - column >> 31;
      i += 1 + (endOfRow & RayTile.SIZE - width);
      column = (column & ~endOfRow) + 1;
    }
    return mask;
  }

  /** A ray so close to an edge that rounding could have changed a sign. */
  private void testExactly(final int i, final int place) {
    final int a = mesh.vertex(place, 0), b = mesh.vertex(place, 1), c = mesh.vertex(place, 2);
    offer(i, mesh.facet(place), WatertightTest.distance(
        mesh.coordinate(a) - x, mesh.coordinate(a + 1) - y, mesh.coordinate(a + 2) - z,
        mesh.coordinate(b) - x, mesh.coordinate(b + 1) - y, mesh.coordinate(b + 2) - z,
        mesh.coordinate(c) - x, mesh.coordinate(c + 1) - y, mesh.coordinate(c + 2) - z,
        rays.directionX(i), rays.directionY(i), rays.directionZ(i), error));
  }

  /** Rays with one direction. */
  private void testEach(final int place) {
    final int a = mesh.vertex(place, 0), b = mesh.vertex(place, 1), c = mesh.vertex(place, 2);
    for (int row = window.firstRow(); row <= window.lastRow(); row++) {
      for (int i = row * RayTile.SIZE + window.firstColumn(); i <= row * RayTile.SIZE + window.lastColumn(); i++) {
        final double sx = rays.startX(i), sy = rays.startY(i), sz = rays.startZ(i);
        offer(i, mesh.facet(place), WatertightTest.distance(
            mesh.coordinate(a) - sx, mesh.coordinate(a + 1) - sy, mesh.coordinate(a + 2) - sz,
            mesh.coordinate(b) - sx, mesh.coordinate(b + 1) - sy, mesh.coordinate(b + 2) - sz,
            mesh.coordinate(c) - sx, mesh.coordinate(c + 1) - sy, mesh.coordinate(c + 2) - sz,
            rays.directionX(i), rays.directionY(i), rays.directionZ(i), mesh.error(sx, sy, sz)));
      }
    }
  }

  private void offer(final int i, final int facet, final double distance) {
    if (hits.isCloser(i, distance, facet)) {
      hits.take(i, distance, source, facet);
    }
  }
}
