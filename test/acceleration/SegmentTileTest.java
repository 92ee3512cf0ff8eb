package acceleration;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;

import org.junit.jupiter.api.Test;

import primitives.BoundingBox;
import primitives.Point3D;
import trials.Trials;

/** What lies on a segment is projected onto it, and what is blocked is found no more. */
class SegmentTileTest {

  private final SegmentTile tile = new SegmentTile();
  private int enclosed;
  private int prisms;

  /** Fills the tile with segments from points about one place to a light, or in one direction. */
  private int fill(final Random random) {
    final int n = 1 + random.nextInt(SegmentTile.MOST);
    final boolean directed = random.nextInt(3) == 0;
    final double unit = random.nextBoolean() ? 1 : Math.pow(10, 8 * random.nextDouble() - 4);
    final double spread = unit * Math.pow(10, -4 * random.nextDouble()), far = random.nextInt(4) == 0 ? 1000 * unit : 0;
    final double[] light = {far + 3 * unit * random.nextGaussian(), 5 * unit, 3 * unit * random.nextGaussian()};
    tile.clear();
    for (int i = 0; i < n; i++) {
      final double x = far + spread * random.nextGaussian(), y = spread * random.nextGaussian();
      final double z = spread * random.nextGaussian(), vx = directed ? 1 : light[0] - x, vy = directed ? 2 : light[1] - y;
      final double vz = directed ? 3 : light[2] - z, length = Math.sqrt(vx * vx + vy * vy + vz * vz);
      tile.add(x, y, z, vx / length, vy / length, vz / length, directed ? 5 * unit * random.nextDouble() : length);
    }
    return n;
  }

  private boolean isCandidate(final int i) {
    return (tile.candidates(i / Long.SIZE) >> i & 1) != 0;
  }

  /** A small box about a point of a segment. */
  private BoundingBox boxOn(final Random random, final int i) {
    final double t = tile.length(i) * random.nextDouble(), r = random.nextBoolean() ? 0 : 0.1 * t * random.nextDouble();
    final float x = (float) (tile.startX(i) + t * tile.directionX(i)), y = (float) (tile.startY(i) + t * tile.directionY(i));
    final float z = (float) (tile.startZ(i) + t * tile.directionZ(i));
    final float dx = Math.ulp(x) + (float) r, dy = Math.ulp(y) + (float) r, dz = Math.ulp(z) + (float) r;
    return new BoundingBox(new Point3D(x - dx, y - dy, z - dz), new Point3D(x + dx, y + dy, z + dz));
  }

  @Test
  void whatLiesOnASegmentIsProjectedOntoIt() {
    Trials.of(2000, random -> {
      final int n = fill(random), from = random.nextInt(n), to = from + 1 + random.nextInt(n - from);
      if (tile.close(from, to)) {
        enclosed++;
        prisms += tile.frustum().isPyramid() ? 0 : 1;
        for (int k = 0; k < 20; k++) {
          final int i = from + random.nextInt(to - from);
          assertTrue(tile.project(boxOn(random, i)) && isCandidate(i), () -> "segment " + i);
        }
      }
    });
    assertTrue(enclosed > 1500 && prisms > 300, () -> enclosed + " tiles, " + prisms + " prisms");
  }

  @Test
  void aBlockedSegmentIsFoundNoMore() {
    Trials.of(500, random -> {
      final int n = fill(random);
      if (tile.close(0, n)) {
        final int i = random.nextInt(n);
        final BoundingBox box = boxOn(random, i);
        tile.block(i);
        assertFalse(tile.project(box) && isCandidate(i));
        assertTrue(tile.selectAll());
        int left = 0;
        for (int k = 0; k < n; k++) {
          left += isCandidate(k) ? 1 : 0;
          tile.block(k);
        }
        assertEquals(n - 1, left);
        tile.project(box);
        assertFalse(tile.project(box));
        assertEquals(Double.NEGATIVE_INFINITY, tile.limit());
      }
    });
  }

  /** Of segments before a light, a box beside them all and one beyond them are on none. */
  @Test
  void whatLiesBesideOrBeyondIsOnNoSegment() {
    for (int i = 0; i < 64; i++) {
      final double x = i % 8, z = i / 8, length = Math.sqrt(x * x + 100 + z * z);
      tile.add(x, 0, z, -x / length, 10 / length, -z / length, length);
    }
    assertTrue(tile.close(0, 64));
    assertFalse(tile.project(new BoundingBox(new Point3D(-8, 1, 0), new Point3D(-7, 1.1f, 1))));
    assertFalse(tile.project(new BoundingBox(new Point3D(0, -30, 0), new Point3D(8, -20, 8))));
    assertTrue(tile.project(new BoundingBox(new Point3D(0, 5, 0), new Point3D(0.4f, 5.01f, 0.4f))));
    assertTrue(isCandidate(0));
    assertFalse(isCandidate(63));
  }
}
