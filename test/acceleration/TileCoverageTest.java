package acceleration;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;

import org.junit.jupiter.api.Test;
import trials.Trials;

/** A coverage leaves out no ray on the inner side of three planes, and most of the others. */
class TileCoverageTest {

  private int inside;
  private int outside;
  private int leftOut;

  /** The normal of a plane through the start and two points near the directions of two rays, turned to either side. */
  private static double[] normal(final Random random, final RayTile tile) {
    final double[] p = Tiles.direction(tile, Tiles.anyRay(random, tile));
    final double[] q = Tiles.direction(tile, Tiles.anyRay(random, tile));
    final double near = random.nextInt(3) == 0 ? 0 : Math.pow(10, -9 * random.nextDouble());
    final double size = Math.pow(10, 20 * random.nextDouble() - 10);
    for (int k = 0; k < 3; k++) {
      p[k] += near * random.nextGaussian();
      q[k] += near * random.nextGaussian();
    }
    return new double[] {size * (p[1] * q[2] - p[2] * q[1]), size * (p[2] * q[0] - p[0] * q[2]),
        size * (p[0] * q[1] - p[1] * q[0])};
  }

  private static double product(final double[] n, final RayTile tile, final int i) {
    return n[0] * tile.directionX(i) + n[1] * tile.directionY(i) + n[2] * tile.directionZ(i);
  }

  private void check(final Random random, final RayTile tile) {
    final double[] e = normal(random, tile), f = normal(random, tile), g = normal(random, tile);
    final TileCoverage coverage = tile.frustum().coverage();
    tile.reset();
    if (random.nextBoolean()) {
      final double left = random.nextInt(tile.columns()), low = random.nextInt(tile.rows());
      tile.window().limit(left, left + random.nextInt(tile.columns()), low, low + random.nextInt(tile.rows()));
    }
    final TileWindow window = tile.window();
    final int width = window.lastColumn() - window.firstColumn() + 1, atOnce = 64 / width & ~1;
    coverage.begin(e[0], e[1], e[2], f[0], f[1], f[2], g[0], g[1], g[2], 0);
    for (int row = window.firstRow(); row <= window.lastRow(); row += atOnce) {
      final int rows = Math.min(atOnce, window.lastRow() - row + 1);
      final long mask = coverage.next(rows);
      assertTrue(rows * width == 64 || mask >>> rows * width == 0, "bits beyond the window");
      for (int k = 0; k < rows * width; k++) {
        final int i = (row + k / width) * RayTile.SIZE + window.firstColumn() + k % width;
        if (tile.isPresent(i)) {
          count(tile, i, (mask >> k & 1) != 0,
              Math.min(product(e, tile, i), Math.min(product(f, tile, i), product(g, tile, i))));
        }
      }
    }
  }

  private void count(final RayTile tile, final int i, final boolean covered, final double least) {
    assertTrue(covered || least < 0, () -> "pixel " + i + " of " + tile.columns() + " x " + tile.rows() + ": " + least);
    inside += least >= 0 ? 1 : 0;
    outside += least < 0 ? 1 : 0;
    leftOut += covered ? 0 : 1;
  }

  private void checkKind(final Tiles.Kind kind) {
    Trials.of(3000, random -> {
      final RayTile tile = Tiles.random(random, kind, Math.pow(10, 6 * random.nextDouble() - 3));
      if (tile.frustum().isFitted() && tile.frustum().isPyramid()) {
        check(random, tile);
      }
    });
    assertTrue(inside > 10_000, () -> inside + " inside");
  }

  @Test
  void itLeavesOutNoRayOfARegularTileThatIsInsideAndMostOthers() {
    checkKind(Tiles.Kind.PYRAMID);
    checkKind(Tiles.Kind.WIDE);
    checkKind(Tiles.Kind.SKEWED);
    assertTrue(leftOut > 0.6 * outside, () -> leftOut + " of " + outside);
  }

  @Test
  void itLeavesOutNoRayOfAnIrregularTileThatIsInside() {
    checkKind(Tiles.Kind.FISH_EYE);
    checkKind(Tiles.Kind.BENT);
    checkKind(Tiles.Kind.NARROW);
    checkKind(Tiles.Kind.ALL_THE_SAME);
    assertTrue(leftOut > 0.3 * outside, () -> leftOut + " of " + outside);
  }

  @Test
  void itLeavesOutNoRayOfAPencilThatIsInsideAndMostOthers() {
    Trials.of(3000, random -> {
      final PencilTest.Shot shot = new PencilTest.Shot(random, 180 * Math.pow(random.nextDouble(), 4),
          (int) Math.pow(10, 1 + 4 * random.nextDouble()));
      if (shot.tile.frustum().isFitted()) {
        check(random, shot.tile);
      }
    });
    assertTrue(inside > 10_000 && leftOut > 0.9 * outside, () -> inside + " inside, " + leftOut + " of " + outside);
  }
}
