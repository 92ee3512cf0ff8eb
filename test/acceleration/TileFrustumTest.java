package acceleration;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.BitSet;
import java.util.EnumMap;
import java.util.Map;
import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import primitives.BoundingBox;
import primitives.Point3D;
import trials.Trials;

/** What a ray of a tile hits is never reported to lie outside the tile's frustum. */
class TileFrustumTest {

  /** The order of magnitude of lengths: mostly 1, sometimes far from it. */
  private static double size(final Random random) {
    return random.nextInt(4) > 0 ? 1 : random.nextBoolean() ? 1e-25 : 1e25;
  }

  /** A box about a point at a random distance on a ray, much smaller to much larger; the point may lie on its border. */
  private static float[] boxOnRay(final Random random, final double unit, final double[] start, final double[] direction) {
    final double t = unit * Math.pow(10, 8 * random.nextDouble() - 4), size = t * Math.pow(10, 8 * random.nextDouble() - 5);
    final float[] box = new float[6];
    for (int k = 0; k < 3; k++) {
      final double at = start[k] + t * direction[k];
      box[k] = down(at - size * extent(random));
      box[k + 3] = up(at + size * extent(random));
    }
    return box;
  }

  private static double extent(final Random random) {
    final int kind = random.nextInt(4);
    return kind == 0 ? 0 : kind == 1 ? Math.pow(10, -4 * random.nextDouble()) : random.nextDouble();
  }

  private static float down(final double number) {
    final float f = (float) number;
    return f > number ? Math.nextDown(f) : f;
  }

  private static float up(final double number) {
    final float f = (float) number;
    return f < number ? Math.nextUp(f) : f;
  }

  private static BoundingBox boundingBox(final float[] b) {
    return new BoundingBox(new Point3D(b[0], b[1], b[2]), new Point3D(b[3], b[4], b[5]));
  }

  private static String describe(final RayTile tile, final int i, final float[] box) {
    return "pixel " + i + " of " + tile.columns() + " x " + tile.rows() + ", ray from "
        + Arrays.toString(Tiles.start(tile, i)) + " along " + Arrays.toString(Tiles.direction(tile, i))
        + ", box " + Arrays.toString(box);
  }

  @ParameterizedTest
  @EnumSource
  void theWindowOfABoxHoldsEveryRayThatMeetsIt(final Tiles.Kind kind) {
    final int[] limited = {0};
    Trials.of(1000, random -> {
      final double size = size(random);
      final RayTile tile = Tiles.random(random, kind, size);
      for (int k = 0; k < 10; k++) {
        final int i = Tiles.anyRay(random, tile), column = i % RayTile.SIZE, row = i / RayTile.SIZE;
        final float[] box = boxOnRay(random, size, Tiles.start(tile, i), Tiles.direction(tile, i));
        assertTrue(tile.narrowTo(boundingBox(box)), () -> describe(tile, i, box));
        assertTrue(tile.window().firstColumn() <= column && column <= tile.window().lastColumn()
            && tile.window().firstRow() <= row && row <= tile.window().lastRow(), () -> describe(tile, i, box));
        limited[0] += tile.window().lastColumn() - tile.window().firstColumn() + 1 < tile.columns() ? 1 : 0;
      }
    });
    assertTrue(limited[0] > 200 || kind == Tiles.Kind.ANY || kind == Tiles.Kind.ALL_THE_SAME, () -> limited[0] + " windows");
  }

  @ParameterizedTest
  @EnumSource
  void theTreeVisitsEveryBoxThatARayMeets(final Tiles.Kind kind) {
    final int[] hit = {0}, passed = {0};
    Trials.of(400, random -> {
      final double size = size(random);
      final RayTile tile = Tiles.random(random, kind, size);
      if (!tile.frustum().isFitted()) {
        return;
      }
      final int count = 1 + random.nextInt(30);
      final float[] numbers = new float[6 * count];
      for (int b = 0; b < count; b++) {
        final int i = Tiles.anyRay(random, tile);
        final double side = random.nextInt(3) - 1, k = side == 0 ? 1 : 0.3 * side;
        final double[] direction = Tiles.direction(tile, i);
        final double[] turned = {k * direction[0], k * direction[1] + (1 - k * side), k * direction[2]};
        System.arraycopy(boxOnRay(random, size, Tiles.start(tile, i), turned), 0, numbers, 6 * b, 6);
      }
      final Boxes boxes = new Boxes(numbers);
      final int[] order = new int[count];
      final Bvh tree = Bvh.over(numbers.clone(), 2, order);
      final BitSet visited = new BitSet();
      tree.closest(tile.frustum(), (first, end) -> {
        for (int place = first; place < end; place++) {
          visited.set(order[place]);
        }
        return Double.POSITIVE_INFINITY;
      });
      passed[0] += count - visited.cardinality();
      for (int i = 0; i < RayTile.SIZE * tile.rows(); i++) {
        for (int b = 0; tile.isPresent(i) && b < count; b++) {
          if (boxes.enter(b, Tiles.start(tile, i), Tiles.direction(tile, i)) < Double.POSITIVE_INFINITY) {
            hit[0]++;
            final int pixel = i, at = 6 * b;
            assertTrue(visited.get(b), () -> describe(tile, pixel, Arrays.copyOfRange(numbers, at, at + 6)));
          }
        }
      }
    });
    assertTrue(hit[0] > 2000 && passed[0] > 200 || kind == Tiles.Kind.ANY,
        () -> hit[0] + " boxes hit, " + passed[0] + " missed");
  }

  @ParameterizedTest
  @EnumSource
  void theNearestBoxOfEachRayIsFoundThoughOthersAreLeftOut(final Tiles.Kind kind) {
    final int[] hit = {0};
    Trials.of(150, random -> {
      final double size = size(random);
      final RayTile tile = Tiles.random(random, kind, size);
      if (!tile.frustum().isFitted()) {
        return;
      }
      final int count = 1 + random.nextInt(60);
      final float[] numbers = new float[6 * count];
      for (int b = 0; b < count; b++) {
        final int i = Tiles.anyRay(random, tile);
        System.arraycopy(boxOnRay(random, size, Tiles.start(tile, i), Tiles.direction(tile, i)), 0, numbers, 6 * b, 6);
      }
      final Boxes boxes = new Boxes(numbers);
      final int[] order = new int[count];
      final Bvh tree = Bvh.over(numbers.clone(), 2, order);
      final double[] nearest = new double[RayTile.SIZE * RayTile.SIZE];
      Arrays.fill(nearest, Double.POSITIVE_INFINITY);
      tree.closest(tile.frustum(), (first, end) -> {
        double farthest = 0;
        for (int i = 0; i < RayTile.SIZE * tile.rows(); i++) {
          for (int place = first; tile.isPresent(i) && place < end; place++) {
            nearest[i] = Math.min(nearest[i], boxes.enter(order[place], Tiles.start(tile, i), Tiles.direction(tile, i)));
          }
          farthest = tile.isPresent(i) ? Math.max(farthest, nearest[i]) : farthest;
        }
        return farthest * (1 + 0x1p-22);
      });
      for (int i = 0; i < RayTile.SIZE * tile.rows(); i++) {
        double expected = Double.POSITIVE_INFINITY;
        for (int b = 0; tile.isPresent(i) && b < count; b++) {
          expected = Math.min(expected, boxes.enter(b, Tiles.start(tile, i), Tiles.direction(tile, i)));
        }
        hit[0] += expected < Double.POSITIVE_INFINITY ? 1 : 0;
        assertEquals(expected, nearest[i], "pixel " + i);
      }
    });
    assertTrue(hit[0] > 2000 || kind == Tiles.Kind.ANY, () -> hit[0] + " boxes hit");
  }

  @ParameterizedTest
  @EnumSource(names = "ANY", mode = EnumSource.Mode.EXCLUDE)
  void theWindowOfATriangleHoldsEveryRayThatMeetsIt(final Tiles.Kind kind) {
    final int[] hit = {0}, limited = {0};
    Trials.of(1000, random -> {
      final double size = size(random);
      final RayTile tile = Tiles.random(random, kind, size);
      final TileFrustum f = tile.frustum();
      if (!f.isFitted()) {
        return;
      }
      for (int k = 0; k < 10; k++) {
        final int i = Tiles.anyRay(random, tile);
        final double[] start = Tiles.start(tile, i), direction = Tiles.direction(tile, i);
        final float[] v = triangleOnRay(random, size, start, direction);
        if (certainlyHits(start, direction, v)) {
          hit[0]++;
          final boolean inside = f.project(v[0] - f.originX(), v[1] - f.originY(), v[2] - f.originZ(), v[3] - f.originX(),
              v[4] - f.originY(), v[5] - f.originZ(), v[6] - f.originX(), v[7] - f.originY(), v[8] - f.originZ());
          final int column = i % RayTile.SIZE, row = i / RayTile.SIZE;
          assertTrue(inside && f.window().firstColumn() <= column && column <= f.window().lastColumn()
              && f.window().firstRow() <= row && row <= f.window().lastRow(), () -> describe(tile, i, v));
          limited[0] += f.window().lastColumn() - f.window().firstColumn() + 1 < tile.columns() ? 1 : 0;
        }
      }
    });
    assertTrue(hit[0] > 1500 && (limited[0] > 150 || kind == Tiles.Kind.ALL_THE_SAME || kind == Tiles.Kind.NARROW),
        () -> hit[0] + " triangles, " + limited[0] + " windows");
  }

  /** A triangle about a point of a ray, of any size and shape, possibly extending behind the start. */
  private static float[] triangleOnRay(final Random random, final double unit, final double[] start,
      final double[] direction) {
    final double t = unit * Math.pow(10, 6 * random.nextDouble() - 3), size = t * Math.pow(10, 6 * random.nextDouble() - 3);
    final double a = random.nextDouble(), b = random.nextDouble() * (1 - a), c = Math.max(1 - a - b, 1e-3);
    final double sliver = Math.pow(10, -3 * random.nextDouble());
    final float[] v = new float[9];
    for (int k = 0; k < 3; k++) {
      final double at = start[k] + t * direction[k];
      final double e = size * random.nextGaussian(), f = sliver * size * random.nextGaussian();
      v[k] = (float) (at + e);
      v[3 + k] = (float) (at + f);
      v[6 + k] = (float) (at - (a * e + b * f) / c);
    }
    return v;
  }

  /** Whether a ray certainly hits a triangle. */
  private static boolean certainlyHits(final double[] start, final double[] direction, final float[] v) {
    final double[] a = minus(v, 0, start), b = minus(v, 3, start), c = minus(v, 6, start);
    final double e = volume(direction, b, c), f = volume(direction, c, a), g = volume(direction, a, b);
    final double most = Math.max(Math.abs(e), Math.max(Math.abs(f), Math.abs(g))), doubt = 1e-6 * most;
    final boolean inside = e > doubt && f > doubt && g > doubt || e < -doubt && f < -doubt && g < -doubt;
    final double t = (e * dot(a, direction) + f * dot(b, direction) + g * dot(c, direction)) / (e + f + g);
    return inside && t > 0;
  }

  private static double[] minus(final float[] v, final int at, final double[] start) {
    return new double[] {v[at] - start[0], v[at + 1] - start[1], v[at + 2] - start[2]};
  }

  private static double dot(final double[] a, final double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  private static double volume(final double[] d, final double[] b, final double[] c) {
    return d[0] * (b[1] * c[2] - b[2] * c[1]) + d[1] * (b[2] * c[0] - b[0] * c[2]) + d[2] * (b[0] * c[1] - b[1] * c[0]);
  }

  @Test
  void raysWithACommonStartOrDirectionAreFitted() {
    final Map<Tiles.Kind, Integer> fitted = new EnumMap<>(Tiles.Kind.class), pyramids = new EnumMap<>(Tiles.Kind.class);
    final int[] all = {0};
    Trials.of(200, random -> {
      all[0]++;
      for (final Tiles.Kind kind : Tiles.Kind.values()) {
        final RayTile tile = Tiles.random(random, kind, size(random));
        final boolean fits = tile.frustum().isFitted();
        fitted.merge(kind, fits ? 1 : 0, Integer::sum);
        pyramids.merge(kind, fits && tile.frustum().isPyramid() ? 1 : 0, Integer::sum);
      }
    });
    for (final Tiles.Kind kind : new Tiles.Kind[] {Tiles.Kind.PYRAMID, Tiles.Kind.PRISM, Tiles.Kind.SLANTED_PRISM,
        Tiles.Kind.ALL_THE_SAME}) {
      assertEquals(all[0], fitted.get(kind), kind::name);
    }
    assertEquals(all[0], pyramids.get(Tiles.Kind.PYRAMID));
    assertTrue(5 * pyramids.get(Tiles.Kind.PRISM) < all[0], pyramids::toString);
    assertTrue(5 * fitted.get(Tiles.Kind.ANY) < all[0], fitted::toString);
  }

  @Test
  void raysSpreadTooFarOrNoneAtAllAreNotFitted() {
    final RayTile tile = new RayTile();
    tile.open(16, 16);
    tile.close();
    assertFalse(tile.frustum().isFitted());
    tile.open(2, 1);
    tile.put(0, 0, 0, 0, 1, 0, 0);
    tile.put(1, 0, 0, 0, -1, 0, 0);
    tile.close();
    assertFalse(tile.frustum().isFitted());
    assertTrue(tile.narrowTo(boundingBox(new float[] {3, 3, 3, 4, 4, 4})));
  }

  @ParameterizedTest
  @EnumSource
  void aPointOnARayIsNotOutsideHoweverFloatsRound(final Tiles.Kind kind) {
    final int[] asked = {0};
    Trials.of(4000, random -> {
      final double size = size(random);
      final RayTile tile = Tiles.random(random, kind, size);
      final TileFrustum frustum = tile.frustum();
      final int corner = (tile.rows() - 1) * random.nextInt(2) * RayTile.SIZE + (tile.columns() - 1) * random.nextInt(2);
      if (!frustum.isFitted() || !tile.isPresent(corner)) {
        return;
      }
      final double t = size * Math.pow(10, 8 * random.nextDouble() - 4);
      final float[] box = new float[6];
      for (int k = 0; k < 3; k++) {
        final double at = Tiles.start(tile, corner)[k] + t * Tiles.direction(tile, corner)[k];
        box[k] = down(at);
        box[k + 3] = up(at);
      }
      if (frustum.prepare(box)) {
        asked[0]++;
        assertFalse(frustum.sides().isOutside(box, 0), () -> describe(tile, corner, box));
        assertTrue(frustum.sides().nearest(box, 0) <= t * (1 + 1e-12), () -> describe(tile, corner, box));
      }
    });
    assertTrue(asked[0] > 500 || kind == Tiles.Kind.ANY, () -> asked[0] + " points");
  }

  @Test
  void aTreeInALeafLeavesTheOuterOneItsAllowanceForRounding() {
    Trials.of(100, random -> {
      final RayTile tile = Tiles.random(random, Tiles.Kind.PYRAMID, 1);
      final float[] near = {-1, -1, -1, 1, 1, 1}, wide = {-1e6f, -1e6f, -1e6f, 1e6f, 1e6f, 1e6f, -1, -1, -1, 1, 1, 1};
      final TileFrustum frustum = tile.frustum();
      final Bvh inner = Bvh.over(near.clone(), 1, new int[1]);
      Bvh.over(wide.clone(), 1, new int[2]).closest(frustum, (first, end) -> {
        final float before = frustum.sides().nearest(near, 0);
        inner.closest(frustum, (from, to) -> Double.POSITIVE_INFINITY);
        assertEquals(before, frustum.sides().nearest(near, 0));
        return Double.POSITIVE_INFINITY;
      });
    });
  }

  @Test
  void aBoxBesideTheRaysIsNotLookedAtThoughTheOneBeforeWas() {
    final RayTile tile = new RayTile();
    tile.open(2, 1);
    tile.put(0, 0, 0, 0, -0.01, 0, -1);
    tile.put(1, 0, 0, 0, 0.01, 0, -1);
    tile.close();
    assertTrue(tile.narrowTo(new BoundingBox(new Point3D(-1, -1, -3), new Point3D(1, 1, -2))));
    assertFalse(tile.narrowTo(new BoundingBox(new Point3D(5, -1, -3), new Point3D(6, 1, -2))));
    assertFalse(tile.narrowTo(new BoundingBox(new Point3D(-1, -1, 2), new Point3D(1, 1, 3))));
  }

  @Test
  void aBoxWithoutEndIsSeenByTheWholeTile() {
    final RayTile tile = Tiles.random(new Random(3), Tiles.Kind.PYRAMID, 1);
    assertTrue(tile.narrowTo(BoundingBox.UNBOUNDED));
    assertEquals(tile.columns() - 1, tile.window().lastColumn() - tile.window().firstColumn());
    assertEquals(tile.rows() - 1, tile.window().lastRow() - tile.window().firstRow());
  }
}
