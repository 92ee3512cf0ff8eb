package tracer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import acceleration.RayTile;
import primitives.Point3D;
import primitives.Vector3D;
import view.Camera;

class RayGeneratorTest {

  private static final Camera CAMERA = new Camera(new Point3D(), new Point3D(0, 0, -1), new Vector3D(0, 1, 0));

  /** A ray from (m, n, 0) for each pixel but those of the diagonal. */
  private static class Slanting extends RayGenerator {

    Slanting(final Camera camera, final int W, final int H) {
      super(camera, W, H);
    }

    @Override
    public Ray getRay(final int m, final int n) {
      checkPixel(m, n);
      return m == n ? Ray.NORAY : new Ray(new Point3D(m, n, 0), new Vector3D(m, n, -1));
    }
  }

  private static String message(final Class<? extends Exception> type,
      final org.junit.jupiter.api.function.Executable call) {
    return assertThrows(type, call).getMessage();
  }

  @Test
  void keepsCameraAndSize() {
    final RayGenerator generator = new Slanting(CAMERA, 40, 30);
    assertSame(CAMERA, generator.getCamera());
    assertEquals(40, generator.getWidth());
    assertEquals(30, generator.getHeight());
  }

  @Test
  void wrongArgumentsAreNamed() {
    assertEquals("camera must not be null", message(IllegalArgumentException.class, () -> new Slanting(null, 1, 1)));
    assertEquals("W must be at least 1, but it is 0", message(IllegalArgumentException.class, () ->
        new Slanting(CAMERA, 0, 1)));
    assertEquals("H must be at least 1, but it is -3", message(IllegalArgumentException.class, () ->
        new Slanting(CAMERA, 1, -3)));
    final RayGenerator generator = new Slanting(CAMERA, 40, 30);
    assertEquals("m must be between 0 and 39, but it is 40", message(IllegalArgumentException.class, () ->
        generator.getRay(40, 0)));
    assertEquals("n must be between 0 and 29, but it is -1", message(IllegalArgumentException.class, () ->
        generator.getRay(0, -1)));
    assertEquals("tile must not be null", message(IllegalArgumentException.class, () -> generator.fill(null, 0, 0)));
    final RayTile tile = new RayTile();
    tile.open(16, 8);
    assertThrows(IllegalArgumentException.class, () -> generator.fill(tile, 25, 0));
    assertThrows(IllegalArgumentException.class, () -> generator.fill(tile, 0, 23));
    assertThrows(IllegalArgumentException.class, () -> generator.fill(tile, -1, 0));
  }

  @Test
  void tilesHoldTheRaysOfTheirPixels() {
    final RayGenerator generator = new Slanting(CAMERA, 40, 30);
    final RayTile tile = new RayTile();
    tile.open(16, 14);
    generator.fill(tile, 10, 16);
    tile.close();
    for (int row = 0; row < 14; row++) {
      for (int column = 0; column < 16; column++) {
        final int i = row * RayTile.SIZE + column;
        final Ray ray = generator.getRay(10 + column, 16 + row);
        assertEquals(ray != Ray.NORAY, tile.isPresent(i));
        if (tile.isPresent(i)) {
          assertEquals(ray.startX() + " " + ray.startY() + " " + ray.startZ() + " " + ray.directionX() + " "
              + ray.directionY() + " "
              + ray.directionZ(), tile.startX(i) + " " + tile.startY(i) + " " + tile.startZ(i) + " " + tile.directionX(i)
                  + " "
              + tile.directionY(i) + " " + tile.directionZ(i));
        }
      }
    }
    assertFalse(tile.isPresent(6 * RayTile.SIZE + 12));
    assertTrue(tile.isPresent(6 * RayTile.SIZE + 13));
  }

  /** A generator whose getRay does not check its pixels: its tiles are checked all the same. */
  @Test
  void tileThatReachesOutOfTheImageIsWrongForEveryGenerator() {
    final RayGenerator careless = new RayGenerator(CAMERA, 40, 30) {
      @Override
      public Ray getRay(final int m, final int n) {
        return Ray.NORAY;
      }
    };
    final RayTile tile = new RayTile();
    tile.open(16, 8);
    for (final int[] pixel : new int[][] {{25, 0}, {0, 23}, {-1, 0}, {0, -1}}) {
      assertThrows(IllegalArgumentException.class, () -> careless.fill(tile, pixel[0], pixel[1]));
    }
    careless.fill(tile, 24, 22);
    careless.fill(tile, 0, 0);
  }

  /** A tile in the last corner of the image requests no pixel beyond it. */
  @Test
  void onlyPixelsOfTheTileAreAsked() {
    final RayGenerator generator = new Slanting(CAMERA, 40, 30);
    final RayTile tile = new RayTile();
    tile.open(3, 2);
    generator.fill(tile, 37, 28);
    tile.close();
    assertEquals(38, tile.startX(1));
    assertFalse(tile.isPresent(3));
    assertFalse(tile.isPresent(2 * RayTile.SIZE));
  }

  @Test
  void nullInsteadOfARayIsAnsweredByAWordToTheStudent() {
    final RayGenerator forgetful = new Slanting(CAMERA, 40, 30) {
      @Override
      public Ray getRay(final int m, final int n) {
        return m == 3 && n == 2 ? null : super.getRay(m, n);
      }
    };
    final RayTile tile = new RayTile();
    tile.open(16, 16);
    final String message = message(IllegalStateException.class, () -> forgetful.fill(tile, 0, 0));
    assertTrue(message.contains("(3, 2)") && message.contains(forgetful.getClass().getName()), message);
  }
}
