package models;

import acceleration.SegmentTile;

/**
 * The shadow rays of a tile that a mesh blocks. A triangle is projected from the light, and tested for those rays only that
 * have their place there. If the rays share their end, the products of its edges are computed once, seen from the light,
 * and rays that pass the triangle by beyond doubt are left out by their signs, as in {@link MeshTile}; the others are
 * decided by {@link MeshTree#blocks}, as a ray alone is.
 *
 * <p>Doubt: the sign of an edge is that of a triple product of the ray's line, which does not change along the line. Seen
 * from the light, at most the displacement s beside the line, it differs by no more than s (|B| + |C|);
 * {@link MeshTree#error} bounds the rounding, here and at the start of each ray, whose greatest coordinate differs from the
 * light's by no more than the length of the ray.
 */
final class MeshShadow extends MeshLeaves {

  /** Bound of what rounding and the displacement can do to the distance of the light from a triangle's plane. */
  private static final double EDGE_ON = 0x1p-40;

  /** Bound of the rounding of a depth, relative to the greatest coordinate. */
  private static final double DEPTH = 0x1p-45;

  private final ShadowTile tile;
  private final SegmentTile segments;
  private final double doubt;
  private final double edgeOn;
  private final double depthError;

  MeshShadow(final ShadowTile tile, final MeshTree mesh) {
    super(mesh, tile.segments().frustum());
    this.tile = tile;
    this.segments = tile.segments();
    final double extent = mesh.greatest(x, y, z), length = segments.longest();
    this.doubt = mesh.error(x, y, z) + 2 * WatertightTest.error(extent + length) + 4 * segments.displacement() * extent;
    this.depthError = DEPTH * extent;
    this.edgeOn = segments.displacement() + EDGE_ON * (extent + length);
  }

  void findBlocked() {
    mesh.block(segments, this);
  }

  @Override
  double farthest() {
    return segments.limit();
  }

  @Override
  void test(final int place, final double ax, final double ay, final double az,
      final double bx, final double by, final double bz, final double cx, final double cy, final double cz) {
    if (!segments.select(depthError)) {
      return;
    }
    final double px = bx - ax, py = by - ay, pz = bz - az, qx = cx - ax, qy = cy - ay, qz = cz - az;
    final double nx = py * qz - pz * qy, ny = pz * qx - px * qz, nz = px * qy - py * qx;
    final double plane = ax * nx + ay * ny + az * nz, s = -Math.copySign(1, plane);
    final boolean doubtful = !frustum.isPyramid()
        || !(Math.abs(plane) > edgeOn * (Math.abs(nx) + Math.abs(ny) + Math.abs(nz)));
    final double ex = s * (by * cz - bz * cy), ey = s * (bz * cx - bx * cz), ez = s * (bx * cy - by * cx);
    final double fx = s * (cy * az - cz * ay), fy = s * (cz * ax - cx * az), fz = s * (cx * ay - cy * ax);
    final double gx = s * (ay * bz - az * by), gy = s * (az * bx - ax * bz), gz = s * (ax * by - ay * bx);
    for (int word = 0; word < SegmentTile.WORDS; word++) {
      for (long bits = segments.candidates(word); bits != 0; bits &= bits - 1) {
        final int i = word * Long.SIZE + Long.numberOfTrailingZeros(bits);
        final double dx = segments.directionX(i), dy = segments.directionY(i), dz = segments.directionZ(i);
        final long signs = Double.doubleToRawLongBits(dx * ex + dy * ey + dz * ez + doubt)
            | Double.doubleToRawLongBits(dx * fx + dy * fy + dz * fz + doubt)
            | Double.doubleToRawLongBits(dx * gx + dy * gy + dz * gz + doubt);
        if ((signs >= 0 || doubtful) && mesh.blocks(place, segments.startX(i), segments.startY(i), segments.startZ(i),
            dx, dy, dz, tile.limit(i))) {
          tile.block(i);
        }
      }
    }
  }
}
