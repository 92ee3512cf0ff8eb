package acceleration;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import primitives.BoundingBox;
import trials.Trials;

/** A tile's frustum is not only large enough for its rays: what lies beside them by a tenth of a pixel is left out. */
class TileTightnessTest {

  /** How a tile gets its rays. */
  enum Source { PYRAMID, PRISM, PENCIL }

  /**
   * Rays at even steps about a random frame, and the points of space by column, row, and depth along the view. A pyramid is
   * seen straight, as the steps are even only in the plane across the middle of its rays.
   */
  private static final class Raster {

    private final Source source;
    private final RayTile tile = new RayTile();
    private final double[] origin;
    private final double[] right;
    private final double[] up;
    private final double[] look;
    private final double step;
    private final double firstX;
    private final double firstY;

    Raster(final Random random, final Source source) {
      this.source = source;
      origin = new double[] {(float) random.nextGaussian(), (float) random.nextGaussian(), (float) random.nextGaussian()};
      look = unit(gauss(random));
      right = unit(cross(look, gauss(random)));
      up = cross(right, look);
      step = Math.pow(10, -1 - 2 * random.nextDouble()) / 3;
      final int columns = 2 + random.nextInt(RayTile.SIZE - 1), rows = 2 + random.nextInt(RayTile.SIZE - 1);
      final double aside = source == Source.PYRAMID ? 0 : 5;
      firstX = step * (aside * random.nextDouble() - 0.5 * (columns - 1));
      firstY = step * (aside * random.nextDouble() - 0.5 * (rows - 1));
      tile.open(columns, rows);
      if (source == Source.PENCIL) {
        tile.fill(new Pencil(origin, right, up, look), centres(firstX, columns), 0, centres(firstY, rows), 0);
      } else {
        put(columns, rows);
      }
      tile.close();
    }

    private void put(final int columns, final int rows) {
      for (int row = 0; row < rows; row++) {
        for (int column = 0; column < columns; column++) {
          final double[] from = source == Source.PRISM ? point(column, row, 0) : origin, at = point(column, row, 1);
          final double[] d = minus(at, from);
          tile.put(row * RayTile.SIZE + column, from[0], from[1], from[2], d[0], d[1], d[2]);
        }
      }
    }

    private double[] centres(final double first, final int count) {
      final double[] centres = new double[count];
      for (int i = 0; i < count; i++) {
        centres[i] = first + i * step;
      }
      return centres;
    }

    /** The point of the ray of a column and row, also between pixels, at a depth. */
    double[] point(final double column, final double row, final double depth) {
      final double k = source == Source.PRISM ? 1 : depth, x = k * (firstX + column * step), y = k * (firstY + row * step);
      return new double[] {origin[0] + x * right[0] + y * up[0] + depth * look[0],
          origin[1] + x * right[1] + y * up[1] + depth * look[1], origin[2] + x * right[2] + y * up[2] + depth * look[2]};
    }

    /** A small box, a thousandth of a pixel wide. */
    BoundingBox boxAt(final double column, final double row, final double depth) {
      final double[] p = point(column, row, depth);
      final double half = 5e-4 * step;
      return BoundingBox.around(p[0], p[1], p[2], half, half, half);
    }

    boolean isBeside(final double column, final double row, final double slack) {
      return column < -slack || column > tile.columns() - 1 + slack || row < -slack || row > tile.rows() - 1 + slack;
    }
  }

  private static double[] gauss(final Random random) {
    return new double[] {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
  }

  private static double[] cross(final double[] a, final double[] b) {
    return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  private static double[] unit(final double[] a) {
    final double length = Math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    return new double[] {a[0] / length, a[1] / length, a[2] / length};
  }

  private static float[] numbers(final BoundingBox box) {
    return new float[] {box.minX(), box.minY(), box.minZ(), box.maxX(), box.maxY(), box.maxZ()};
  }

  /** A number up to three pixels beyond either end, often a whole one. */
  private static double place(final Random random, final int pixels) {
    final double place = (pixels + 5) * random.nextDouble() - 3;
    return random.nextInt(3) == 0 ? place : Math.rint(place);
  }

  @ParameterizedTest
  @EnumSource
  void theWindowOfATriangleIsThatOfItsVertices(final Source source) {
    final int[] seen = {0, 0};
    Trials.of(2000, random -> {
      final Raster raster = new Raster(random, source);
      final TileFrustum f = raster.tile.frustum();
      final double[] c = new double[3], r = new double[3];
      final double[][] p = new double[3][];
      for (int k = 0; k < 3; k++) {
        c[k] = place(random, raster.tile.columns());
        r[k] = place(random, raster.tile.rows());
        p[k] = raster.point(c[k], r[k], 1 + random.nextDouble());
      }
      final boolean inside = f.project(p[0][0] - f.originX(), p[0][1] - f.originY(), p[0][2] - f.originZ(),
          p[1][0] - f.originX(), p[1][1] - f.originY(), p[1][2] - f.originZ(),
          p[2][0] - f.originX(), p[2][1] - f.originY(), p[2][2] - f.originZ());
      final double leastC = Math.min(c[0], Math.min(c[1], c[2])), mostC = Math.max(c[0], Math.max(c[1], c[2]));
      final double leastR = Math.min(r[0], Math.min(r[1], r[2])), mostR = Math.max(r[0], Math.max(r[1], r[2]));
      seen[inside ? 0 : 1]++;
      if (inside) {
        assertEnd(leastC, f.window().firstColumn(), 0);
        assertEnd(-mostC, -f.window().lastColumn(), 1 - raster.tile.columns());
        assertEnd(leastR, f.window().firstRow(), 0);
        assertEnd(-mostR, -f.window().lastRow(), 1 - raster.tile.rows());
      } else {
        final double off = 1e-3, endC = raster.tile.columns() - 1 - off, endR = raster.tile.rows() - 1 - off;
        assertTrue(Math.ceil(leastC + off) > Math.floor(mostC - off) || Math.ceil(leastR + off) > Math.floor(mostR - off)
            || mostC < off || mostR < off || leastC > endC || leastR > endR);
      }
    });
    assertTrue(seen[0] > 500 && seen[1] > 20, () -> seen[0] + " inside, " + seen[1] + " outside");
  }

  /** That the first pixel of a window is the one after a place, or, within some hundredths of a pixel, the one before. */
  private static void assertEnd(final double place, final int first, final int least) {
    assertTrue(first >= Math.max(least, (int) Math.ceil(place - 0.05)), () -> "window from " + first + " for " + place);
    assertTrue(first <= Math.max(least, (int) Math.ceil(place + 1e-3)), () -> "window from " + first + " for " + place);
  }

  @ParameterizedTest
  @EnumSource
  void smallBoxesBesideTheRaysAreLeftOutAndOthersSeenByTheNearestPixels(final Source source) {
    final int[] seen = {0, 0};
    Trials.of(2000, random -> {
      final Raster raster = new Raster(random, source);
      final double c = place(random, raster.tile.columns()), r = place(random, raster.tile.rows());
      final BoundingBox box = raster.boxAt(c, r, 0.5 + 2 * random.nextDouble());
      final TileFrustum f = raster.tile.frustum();
      final boolean crossed = raster.tile.narrowTo(box);
      if (crossed) {
        seen[0]++;
        assertEquals(c, Math.max(raster.tile.window().firstColumn(), Math.min(raster.tile.window().lastColumn(), c)), 0.05);
        assertEquals(r, Math.max(raster.tile.window().firstRow(), Math.min(raster.tile.window().lastRow(), r)), 0.05);
        assertTrue(raster.tile.window().lastColumn() - raster.tile.window().firstColumn() <= 1);
        assertTrue(raster.tile.window().lastRow() - raster.tile.window().firstRow() <= 1);
      }
      assertTrue(f.prepare(numbers(box)));
      if (raster.isBeside(c, r, 0.1)) {
        seen[1]++;
        assertFalse(crossed);
        assertTrue(f.sides().isOutside(numbers(box), 0), () -> "column " + c + ", row " + r);
      } else if (!raster.isBeside(c, r, 0)) {
        assertFalse(f.sides().isOutside(numbers(box), 0), () -> "column " + c + ", row " + r);
      }
    });
    assertTrue(seen[0] > 100 && seen[1] > 500, () -> seen[0] + " crossed, " + seen[1] + " beside");
  }

  /** The least distance of a box, along the middle of the rays, is known to a thousandth; what lies behind is outside. */
  @ParameterizedTest
  @EnumSource
  void boxesAreAsFarAsTheyLieAlongTheView(final Source source) {
    Trials.of(1000, random -> {
      final Raster raster = new Raster(random, source);
      final TileFrustum f = raster.tile.frustum();
      final int columns = raster.tile.columns(), rows = raster.tile.rows();
      final double depth = 0.5 + 2 * random.nextDouble();
      final double c = (columns - 1) * random.nextDouble(), r = (rows - 1) * random.nextDouble();
      final float[] box = numbers(raster.boxAt(c, r, depth));
      final double[] p = raster.point(c, r, depth), first = raster.point(0, 0, 0);
      final double[] middle = raster.point((columns - 1) / 2.0, (rows - 1) / 2.0, 1);
      final double[] axis = source == Source.PRISM ? raster.look : unit(minus(middle, raster.origin));
      final double[] way = minus(p, source == Source.PRISM ? first : raster.origin);
      final double distance = way[0] * axis[0] + way[1] * axis[1] + way[2] * axis[2];
      assertTrue(f.prepare(box));
      assertEquals(distance, f.sides().nearest(box, 0), 0.02 * distance);
      final float[] behind = numbers(raster.boxAt(c, r, -depth));
      assertTrue(f.prepare(behind));
      assertTrue(f.sides().isOutside(behind, 0));
    });
  }

  private static double[] minus(final double[] a, final double[] b) {
    return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
}
