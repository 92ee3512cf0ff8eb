package acceleration;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;

import org.junit.jupiter.api.Test;

import tracer.Ray;
import trials.Trials;

/** The rays of a pencil are those of single rays, and no ray strays farther from the derived grid than its margin. */
class PencilTest {

  /** A camera of random position, orientation and angle of view, a resolution, and a tile somewhere in its picture. */
  static final class Shot {

    final double[] start = new double[3];
    final double[][] frame = {new double[3], new double[3], new double[3]};
    final double[] columns;
    final double[] rows;
    final int m;
    final int n;
    final RayTile tile = new RayTile();
    final Pencil pencil;

    Shot(final Random random, final double fov, final int most) {
      final double far = Math.pow(10, 12 * random.nextDouble() - 4);
      for (int k = 0; k < 3; k++) {
        start[k] = far * random.nextGaussian();
      }
      orient(random);
      final int W = 1 + random.nextInt(most), H = 1 + random.nextInt(most);
      final double h = 2 * Math.tan(Math.toRadians(fov / 2)), w = h * Math.pow(10, 2 * random.nextDouble() - 1);
      columns = centres(w, W);
      rows = centres(h, H);
      m = random.nextInt((W + RayTile.SIZE - 1) / RayTile.SIZE) * RayTile.SIZE;
      n = random.nextInt((H + RayTile.SIZE - 1) / RayTile.SIZE) * RayTile.SIZE;
      pencil = new Pencil(start, frame[0], frame[1], frame[2]);
      tile.open(Math.min(RayTile.SIZE, W - m), Math.min(RayTile.SIZE, H - n));
      tile.fill(pencil, columns, m, rows, n);
      tile.close();
    }

    /** An orthonormal frame: arbitrary, or along the axes. */
    private void orient(final Random random) {
      if (random.nextInt(4) == 0) {
        for (int k = 0; k < 3; k++) {
          Arrays.fill(frame[k], random.nextBoolean() ? -0.0 : 0.0);
          frame[k][(k + 1) % 3] = random.nextBoolean() ? -1 : 1;
        }
        return;
      }
      final double[] z = frame[2], x = frame[0];
      for (int k = 0; k < 3; k++) {
        z[k] = random.nextGaussian();
        x[k] = random.nextGaussian();
      }
      normalise(z);
      final double along = z[0] * x[0] + z[1] * x[1] + z[2] * x[2];
      for (int k = 0; k < 3; k++) {
        x[k] -= along * z[k];
      }
      normalise(x);
      for (int k = 0; k < 3; k++) {
        frame[1][k] = x[(k + 1) % 3] * z[(k + 2) % 3] - x[(k + 2) % 3] * z[(k + 1) % 3];
      }
    }

    private static void normalise(final double[] v) {
      final double length = Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
      for (int k = 0; k < 3; k++) {
        v[k] /= length;
      }
    }

    private static double[] centres(final double size, final int pixels) {
      final double[] centres = new double[pixels];
      for (int i = 0; i < pixels; i++) {
        centres[i] = (i + 0.5) * size / pixels - size / 2;
      }
      return centres;
    }

    /** The centres as the tile keeps them, one for each pixel. */
    double[] perPixel(final boolean across) {
      final double[] all = new double[RayTile.SIZE * RayTile.SIZE];
      for (int i = 0; i < RayTile.SIZE * tile.rows(); i++) {
        final int column = Math.min(i % RayTile.SIZE, tile.columns() - 1);
        all[i] = across ? columns[m + column] : rows[n + i / RayTile.SIZE];
      }
      return all;
    }

    boolean derive(final TileGrid grid) {
      return new PencilGrid().derive(pencil, tile, perPixel(true), perPixel(false), grid);
    }

    @Override
    public String toString() {
      return "from " + Arrays.toString(start) + " by " + Arrays.deepToString(frame) + ", tile " + m + ", " + n + " of "
          + columns.length + " x " + rows.length + ", first centres " + columns[0] + ", " + rows[0];
    }
  }

  private static double anyFov(final Random random) {
    return random.nextInt(3) == 0 ? 180 - Math.pow(10, -6 * random.nextDouble()) : 180 * Math.pow(random.nextDouble(), 6);
  }

  private static double form(final double x, final double y, final double z, final RayTile tile, final int i) {
    return x * tile.directionX(i) + y * tile.directionY(i) + z * tile.directionZ(i);
  }

  @Test
  void theRaysAreThoseOfSingleRays() {
    Trials.of(300, random -> {
      final Shot shot = new Shot(random, anyFov(random), 100);
      final double[][] f = shot.frame;
      for (int i = 0; i < RayTile.SIZE * shot.tile.rows(); i++) {
        final int pixel = i;
        if (i % RayTile.SIZE >= shot.tile.columns()) {
          continue;
        }
        final double a = shot.columns[shot.m + i % RayTile.SIZE], b = shot.rows[shot.n + i / RayTile.SIZE];
        final Ray ray = Ray.towards(shot.start[0], shot.start[1], shot.start[2], f[0][0] * a + (f[1][0] * b + f[2][0]),
            f[0][1] * a + (f[1][1] * b + f[2][1]), f[0][2] * a + (f[1][2] * b + f[2][2]));
        assertEquals(ray.startX(), shot.tile.startX(i), () -> shot + ", pixel " + pixel);
        assertEquals(ray.startY(), shot.tile.startY(i), () -> shot + ", pixel " + pixel);
        assertEquals(ray.startZ(), shot.tile.startZ(i), () -> shot + ", pixel " + pixel);
        assertEquals(ray.directionX(), shot.tile.directionX(i), () -> shot + ", pixel " + pixel);
        assertEquals(ray.directionY(), shot.tile.directionY(i), () -> shot + ", pixel " + pixel);
        assertEquals(ray.directionZ(), shot.tile.directionZ(i), () -> shot + ", pixel " + pixel);
      }
    });
  }

  @Test
  void noRayStraysFartherThanTheMargin() {
    final int[] derived = {0};
    final double[] worst = {0};
    Trials.of(3000, random -> {
      final Shot shot = new Shot(random, anyFov(random), (int) Math.pow(10, 1 + 4 * random.nextDouble()));
      final TileGrid g = new TileGrid();
      if (!shot.derive(g)) {
        return;
      }
      derived[0]++;
      for (int i = 0; i < RayTile.SIZE * shot.tile.rows(); i++) {
        if (shot.tile.isPresent(i)) {
          final double depth = form(g.depthX, g.depthY, g.depthZ, shot.tile, i);
          final double column = form(g.columnX, g.columnY, g.columnZ, shot.tile, i) / depth;
          final double row = form(g.rowX, g.rowY, g.rowZ, shot.tile, i) / depth;
          final double strayed = Math.max(Math.abs(column - i % RayTile.SIZE) / g.columnMargin,
              Math.abs(row - i / RayTile.SIZE) / g.rowMargin);
          final int pixel = i;
          assertTrue(depth > 0 && strayed <= 1,
              () -> strayed + " margins, depth " + depth + ", pixel " + pixel + ", " + shot);
          worst[0] = Math.max(worst[0], strayed);
        }
      }
    });
    assertTrue(derived[0] > 1500, () -> derived[0] + " derived");
    assertTrue(worst[0] > 0.4, () -> "the margin is never used by more than " + worst[0]);
  }

  @Test
  void unevenCentresWidenTheMargin() {
    Trials.of(200, random -> {
      final Shot shot = new Shot(random, 60, 16);
      final TileGrid g = new TileGrid();
      if (shot.tile.columns() < 3 || !shot.derive(g)) {
        return;
      }
      final double before = g.columnMargin;
      shot.columns[1] += (shot.columns[1] - shot.columns[0]) / 64;
      assertTrue(!shot.derive(g) || g.columnMargin >= 1.0 / 64, shot::toString);
      assertTrue(before < 1e-3, () -> before + ", " + shot);
    });
  }

  @Test
  void ordinaryPicturesAreDerivedWithSmallMargins() {
    Trials.of(500, random -> {
      final Shot shot = new Shot(random, 20 + 80 * random.nextDouble(), 4000);
      final TileGrid g = new TileGrid();
      if (shot.columns.length < 200) {
        return;
      }
      final boolean wide = shot.tile.columns() > 1 && shot.tile.rows() > 1;
      assertEquals(wide, shot.derive(g), shot::toString);
      assertTrue(!wide || g.columnMargin < 0.03 && g.rowMargin < 0.03,
          () -> g.columnMargin + ", " + g.rowMargin + ", " + shot);
      assertTrue(shot.tile.frustum().isFitted() && shot.tile.frustum().isPyramid(), shot::toString);
    });
  }

  @Test
  void aTileThatSeesNearlyAllOfSpaceIsNotDerived() {
    final RayTile tile = new RayTile();
    final double[] centres = {-1e3, 0, 1e3};
    tile.open(3, 3);
    tile.fill(new Pencil(new double[3], new double[] {1, 0, 0}, new double[] {0, 1, 0}, new double[] {0, 0, -1}), centres, 0,
        centres, 0);
    tile.close();
    assertFalse(tile.frustum().isFitted());
  }

  @Test
  void aTileKnowsWhenAnotherRayFillsItThatItsStartsAreGone() {
    final RayTile tile = new RayTile();
    final Pencil pencil = new Pencil(new double[] {5, 6, 7}, new double[] {1, 0, 0}, new double[] {0, 1, 0},
        new double[] {0, 0, -1});
    final double[] centres = {-0.1, 0.1};
    for (int k = 0; k < 2; k++) {
      tile.open(2, 2);
      tile.fill(pencil, centres, 0, centres, 0);
      tile.close();
      assertEquals(5, tile.startX(RayTile.SIZE + 1));
      tile.open(2, 2);
      tile.put(RayTile.SIZE + 1, 1, 2, 3, 0, 0, 1);
      tile.close();
      assertEquals(1, tile.startX(RayTile.SIZE + 1));
      assertFalse(tile.isPresent(RayTile.SIZE));
    }
  }
}
