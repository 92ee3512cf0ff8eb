package view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
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

/**
 * The laws that every {@link Projection} must obey, as tests. The test of a projection implements this interface and so
 * inherits them; it has to write one method, which gives a random projection with its {@link Optics}: the size of the window
 * and the formula of the rays, written down independently.
 *
 * <p>The laws: each ray starts and goes as the formula says, at the corners of the picture too; its direction is a unit
 * vector; that of the middle goes along the view; tiles hold the same rays, bit for bit, whatever their size and place; the
 * generator checks its arguments and keeps to the camera as it was.
 */
public interface ProjectionContract {

  /** Half an ulp of a component of a unit vector of floats, and what rounding in double adds to it. */
  double UNIT = 0x1p-25 * 1.001;

  /**
   * A projection, and what is expected of it.
   *
   * @param projection the projection
   * @param w width of its window
   * @param h height of its window
   * @param formula its rays, written down independently
   */
  record Optics(Projection projection, double w, double h, Formula formula) {
  }

  /** The ray through a point of the window, in the camera's frame: coordinates of its start, then of its direction. */
  interface Formula {
    /**
     * The ray of a point of the window.
     *
     * @param x from −w/2 to w/2
     * @param y from −h/2 to h/2
     * @return start, then direction of any length; null if there is no ray, an empty array where rounding decides
     */
    double[] ray(double x, double y);
  }

  /**
   * A projection to be tested.
   *
   * @param random source of its parameters
   * @return the projection with its formula
   */
  Optics random(Random random);

  @Test
  default void raysFollowTheFormula() {
    final int[] rays = {0};
    Trials.of(300, random -> {
      final Optics optics = random(random);
      final CameraFrame frame = CameraFrame.random(random);
      final int W = 1 + random.nextInt(300), H = 1 + random.nextInt(300);
      final RayGenerator generator = frame.camera(optics.projection).getRayGenerator(W, H);
      for (int i = 0; i < 50; i++) {
        rays[0] += check(optics, frame, generator, random.nextInt(W), random.nextInt(H));
      }
      for (int corner = 0; corner < 4; corner++) {
        rays[0] += check(optics, frame, generator, corner % 2 * (W - 1), corner / 2 * (H - 1));
      }
    });
    assertTrue(rays[0] > 10000, () -> "only " + rays[0] + " rays");
  }

  /** Compares one ray with the formula; returns how many rays that were, 0 or 1. */
  private static int check(final Optics optics, final CameraFrame frame, final RayGenerator generator,
      final int m, final int n) {
    final double x = (m + 0.5) * optics.w / generator.getWidth() - optics.w / 2;
    final double y = (n + 0.5) * optics.h / generator.getHeight() - optics.h / 2;
    final double[] expected = optics.formula.ray(x, y);
    final Ray ray = generator.getRay(m, n);
    if (expected == null) {
      assertSame(Ray.NORAY, ray);
    } else if (expected.length > 0) {
      final double[] start = frame.point(expected[0], expected[1], expected[2]);
      final double[] direction = frame.direction(expected[3], expected[4], expected[5]);
      final double ulp = 0x1p-24 * (frame.size() + optics.w + optics.h);
      assertNear(start, ulp, ray.startX(), ray.startY(), ray.startZ());
      assertNear(direction, UNIT, ray.getDirection().x, ray.getDirection().y, ray.getDirection().z);
      assertNear(direction, 2 * UNIT, ray.directionX(), ray.directionY(), ray.directionZ());
      final Point3D R = ray.getStartingPoint();
      assertNear(start, ulp, R.x, R.y, R.z);
      return 1;
    }
    return 0;
  }

  private static void assertNear(final double[] expected, final double tolerance, final double x, final double y,
      final double z) {
    assertEquals(expected[0], x, tolerance);
    assertEquals(expected[1], y, tolerance);
    assertEquals(expected[2], z, tolerance);
  }

  @Test
  default void directionsAreUnitVectors() {
    Trials.of(300, random -> {
      final int W = 1 + random.nextInt(100), H = 1 + random.nextInt(100);
      final RayGenerator generator = CameraFrame.random(random).camera(random(random).projection).getRayGenerator(W, H);
      final Ray ray = generator.getRay(random.nextInt(W), random.nextInt(H));
      if (ray != Ray.NORAY) {
        final double x = ray.directionX(), y = ray.directionY(), z = ray.directionZ();
        assertEquals(1, Math.sqrt(x * x + y * y + z * z), 2 * UNIT);
      }
    });
  }

  @Test
  default void rayThroughTheMiddleGoesAlongTheView() {
    Trials.of(200, random -> {
      final CameraFrame frame = CameraFrame.random(random);
      final Camera camera = frame.camera(random(random).projection);
      final int W = 2 * random.nextInt(50) + 1, H = 2 * random.nextInt(50) + 1;
      final Ray ray = camera.getRayGenerator(W, H).getRay(W / 2, H / 2);
      final Vector3D look = camera.getLook();
      assertNear(new double[] {look.x, look.y, look.z}, 2 * UNIT, ray.directionX(), ray.directionY(), ray.directionZ());
      assertEquals(camera.getPosition(), ray.getStartingPoint());
    });
  }

  @Test
  default void windowHasTheSizeOfTheFormula() {
    Trials.of(100, random -> {
      final Optics optics = random(random);
      assertEquals((float) optics.w, optics.projection.getWidth(), 2 * Math.ulp((float) optics.w));
      assertEquals((float) optics.h, optics.projection.getHeight(), 2 * Math.ulp((float) optics.h));
    });
  }

  @Test
  default void tilesHoldTheRaysBitForBit() {
    final int[] rays = {0};
    Trials.of(300, random -> {
      final RayTile tile = new RayTile();
      final int W = 1 + random.nextInt(100), H = 1 + random.nextInt(100);
      final RayGenerator generator = CameraFrame.random(random).camera(random(random).projection).getRayGenerator(W, H);
      final int columns = 1 + random.nextInt(Math.min(W, RayTile.SIZE));
      final int rows = 1 + random.nextInt(Math.min(H, RayTile.SIZE));
      final int m = random.nextInt(W - columns + 1), n = random.nextInt(H - rows + 1);
      tile.open(columns, rows);
      generator.fill(tile, m, n);
      tile.close();
      for (int row = 0; row < rows; row++) {
        for (int column = 0; column < columns; column++) {
          rays[0] += assertSameRay(generator.getRay(m + column, n + row), tile, row * RayTile.SIZE + column);
        }
      }
    });
    assertTrue(rays[0] > 1000, () -> "only " + rays[0] + " rays");
  }

  /** Compares a ray, bit for bit, with that of a pixel of a tile; returns how many rays that were, 0 or 1. */
  static int assertSameRay(final Ray ray, final RayTile tile, final int i) {
    if (ray == Ray.NORAY) {
      assertFalse(tile.isPresent(i));
      return 0;
    }
    assertTrue(tile.isPresent(i));
    final double[] expected = {ray.startX(), ray.startY(), ray.startZ(),
        ray.directionX(), ray.directionY(), ray.directionZ(),
        ray.getDirection().x, ray.getDirection().y, ray.getDirection().z};
    final double[] found = {tile.startX(i), tile.startY(i), tile.startZ(i), tile.directionX(i), tile.directionY(i),
        tile.directionZ(i), tile.vx(i), tile.vy(i), tile.vz(i)};
    for (int k = 0; k < expected.length; k++) {
      assertEquals(Double.doubleToRawLongBits(expected[k]), Double.doubleToRawLongBits(found[k]),
          () -> "pixel " + i + ", " + ray);
    }
    return 1;
  }

  @Test
  default void rejectsPixelsOutsideTheImage() {
    final RayGenerator generator = anyCamera(random(new Random(1)).projection).getRayGenerator(7, 5);
    final int least = Integer.MIN_VALUE, most = Integer.MAX_VALUE;
    for (final int[] pixel : new int[][] {{-1, 0}, {7, 0}, {0, -1}, {0, 5}, {least, 0}, {0, most}}) {
      final Exception wrong = assertThrows(IllegalArgumentException.class, () -> generator.getRay(pixel[0], pixel[1]));
      final boolean isColumn = pixel[0] != 0;
      assertTrue(wrong.getMessage().startsWith(isColumn ? "m " : "n "), wrong.getMessage());
    }
  }

  @Test
  default void rejectsTilesThatReachOutOfTheImage() {
    final RayGenerator generator = anyCamera(random(new Random(1)).projection).getRayGenerator(7, 5);
    final RayTile tile = new RayTile();
    tile.open(4, 3);
    for (final int[] pixel : new int[][] {{-1, 0}, {4, 0}, {0, -1}, {0, 3}, {Integer.MAX_VALUE, 0}}) {
      assertThrows(IllegalArgumentException.class, () -> generator.fill(tile, pixel[0], pixel[1]));
    }
    generator.fill(tile, 3, 2);
    assertThrows(IllegalArgumentException.class, () -> generator.fill(null, 0, 0));
  }

  @Test
  default void rejectsImagesWithoutPixels() {
    final Camera camera = anyCamera(random(new Random(1)).projection);
    assertThrows(IllegalArgumentException.class, () -> camera.getRayGenerator(0, 5));
    assertThrows(IllegalArgumentException.class, () -> camera.getRayGenerator(5, -1));
  }

  @Test
  default void serveOnlyTheCameraThatHoldsThem() {
    final Projection projection = random(new Random(1)).projection, another = random(new Random(1)).projection;
    assertThrows(IllegalArgumentException.class, () -> projection.getRayGenerator(null, 4, 4));
    assertThrows(IllegalStateException.class, () -> projection.getRayGenerator(anyCamera(another), 4, 4));
    final Camera without = new Camera(new Point3D(0, 0, 1), new Point3D(), new Vector3D(0, 1, 0));
    assertThrows(IllegalStateException.class, () -> projection.getRayGenerator(without, 4, 4));
  }

  @Test
  default void aGeneratorKnowsItsCameraAndSize() {
    final Camera camera = anyCamera(random(new Random(1)).projection);
    final RayGenerator generator = camera.getRayGenerator(7, 5);
    assertSame(camera, generator.getCamera());
    assertEquals(7, generator.getWidth());
    assertEquals(5, generator.getHeight());
  }

  @Test
  default void aGeneratorStaysWhenTheCameraGetsAnotherProjection() {
    final Camera camera = anyCamera(random(new Random(1)).projection);
    final RayGenerator generator = camera.getRayGenerator(9, 9);
    final String before = generator.getRay(3, 4).toString();
    camera.setProjection(new Perspective(11, 3));
    camera.setProjection(new Orthographic(123, 7));
    assertEquals(before, generator.getRay(3, 4).toString());
  }

  private static Camera anyCamera(final Projection projection) {
    final Camera camera = new Camera(new Point3D(1, 2, 3), new Point3D(-1, 0, 1), new Vector3D(0, 1, 0));
    camera.setProjection(projection);
    return camera;
  }
}
