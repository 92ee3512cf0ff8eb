package view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;

import org.junit.jupiter.api.Test;

import acceleration.RayTile;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;
import tracer.RayGenerator;
import trials.Trials;

/** A generator that implements getRay only. */
class StudentsGeneratorTest {

  private static final Camera CAMERA = new Camera(new Point3D(0, 0, 1), new Point3D(), new Vector3D(0, 1, 0));

  /** Rays of any start and direction, and in one pixel of five none. */
  private static final class Anything extends RayGenerator {

    private final Ray[] rays;

    Anything(final Random random, final int W, final int H) {
      super(CAMERA, W, H);
      rays = new Ray[W * H];
      for (int i = 0; i < rays.length; i++) {
        final Point3D R = new Point3D((float) random.nextGaussian(), (float) random.nextGaussian(), random.nextFloat());
        rays[i] = random.nextInt(5) == 0 ? Ray.NORAY
            : new Ray(R, new Vector3D((float) random.nextGaussian(), random.nextInt(3) - 1, 0.5f));
      }
    }

    @Override
    public Ray getRay(final int m, final int n) {
      checkPixel(m, n);
      return rays[n * getWidth() + m];
    }
  }

  @Test
  void tilesHoldItsRaysBitForBit() {
    final int W = RayTile.SIZE + 24, H = RayTile.SIZE + 14;
    final int[] rays = {0};
    Trials.of(100, random -> {
      final RayGenerator generator = new Anything(random, W, H);
      final RayTile tile = new RayTile();
      final int columns = 1 + random.nextInt(RayTile.SIZE), rows = 1 + random.nextInt(RayTile.SIZE);
      final int m = random.nextInt(W - columns + 1), n = random.nextInt(H - rows + 1);
      tile.open(columns, rows);
      generator.fill(tile, m, n);
      tile.close();
      for (int row = 0; row < rows; row++) {
        for (int column = 0; column < columns; column++) {
          final Ray ray = generator.getRay(m + column, n + row);
          rays[0] += ProjectionContract.assertSameRay(ray, tile, row * RayTile.SIZE + column);
        }
      }
    });
    assertTrue(rays[0] > 3000, () -> "only " + rays[0] + " rays");
  }

  @Test
  void aTileForgetsTheRaysItHeldBefore() {
    final RayTile tile = new RayTile();
    tile.open(16, 16);
    new Anything(new Random(1), 16, 16).fill(tile, 0, 0);
    tile.close();
    tile.open(16, 16);
    tile.close();
    for (int i = 0; i < 256; i++) {
      assertEquals(false, tile.isPresent(i));
    }
  }

  @Test
  void nullIsNoAnswer() {
    final RayGenerator generator = new RayGenerator(CAMERA, 4, 4) {
      @Override
      public Ray getRay(final int m, final int n) {
        return m == 2 && n == 1 ? null : Ray.NORAY;
      }
    };
    final RayTile tile = new RayTile();
    tile.open(4, 4);
    final Exception wrong = assertThrows(IllegalStateException.class, () -> generator.fill(tile, 0, 0));
    assertTrue(wrong.getMessage().contains("getRay(2, 1)"), wrong.getMessage());
  }
}
