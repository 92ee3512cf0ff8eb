package upnatray;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;

import lights.LightGroup;
import models.Group3D;
import models.Sphere;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import primitives.Point3D;
import primitives.Vector3D;
import rendering.RenderSettings;
import rendering.Shading;
import view.Angular;
import view.Camera;
import view.Orthographic;
import view.Perspective;
import view.Projection;

class ImageTest {

  private static final Color BACKGROUND = new Color(10, 20, 30, 40);
  private static final Color PAINT = new Color(200, 100, 50, 25);

  /** A camera at (0, 0, 5) that looks at the origin. */
  static Camera camera(final Projection projection) {
    final Camera camera = new Camera(new Point3D(0, 0, 5), new Point3D(), new Vector3D(0, 1, 0));
    camera.setProjection(projection);
    return camera;
  }

  static Group3D sphere(final float x, final float y, final float r) {
    final Group3D scene = new Group3D();
    scene.addObject(new Sphere(new Point3D(x, y, 0), r, PAINT));
    return scene;
  }

  static int[] pixels(final Image image) {
    return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
  }

  @Test
  void isABufferedImageWithAlphaFilledWithItsBackground() {
    final Image image = new Image(5, 3, BACKGROUND);
    assertEquals(BufferedImage.TYPE_INT_ARGB, image.getType());
    assertTrue(image.getColorModel().hasAlpha() && image.getColorModel().getColorSpace().isCS_sRGB());
    assertEquals(5, image.getWidth());
    assertEquals(3, image.getHeight());
    for (final int pixel : pixels(image)) {
      assertEquals(BACKGROUND.getRGB(), pixel);
    }
  }

  @ParameterizedTest
  @CsvSource({"0,0", "6,0", "0,4", "6,4", "2,3"})
  void columnsCountFromTheLeftAndRowsFromTheBottom(final int m, final int n) {
    final Image image = new Image(7, 5, BACKGROUND);
    image.synthesis(sphere(m - 3, n - 2, 0.3f), camera(new Orthographic(5, 5f / 7)));
    for (int column = 0; column < 7; column++) {
      for (int row = 0; row < 5; row++) {
        final Color expected = column == m && row == n ? PAINT : BACKGROUND;
        assertEquals(expected.getRGB(), image.getRGB(column, 5 - 1 - row), "pixel " + column + ", " + row);
      }
    }
  }

  @Test
  void alphaOfTheObjectGoesIntoThePixel() {
    final Image image = new Image(1, 1, BACKGROUND);
    image.synthesis(sphere(0, 0, 1), camera(new Perspective(60, 1)));
    assertEquals(PAINT.getRGB(), image.getRGB(0, 0));
    assertEquals(25, new Color(image.getRGB(0, 0), true).getAlpha());
  }

  @Test
  void anEmptySceneShowsTheBackgroundWhateverWasThereBefore() {
    final Image image = new Image(20, 20, BACKGROUND);
    image.synthesis(sphere(0, 0, 4), camera(new Perspective(60, 1)));
    assertEquals(PAINT.getRGB(), image.getRGB(10, 10));
    image.setRGB(3, 4, 77);
    image.synthesis(new Group3D(), camera(new Perspective(60, 1)));
    assertArrayEquals(pixels(new Image(20, 20, BACKGROUND)), pixels(image));
  }

  @Test
  void pixelsWithoutARayShowTheBackground() {
    final Image image = new Image(40, 40, BACKGROUND);
    image.synthesis(sphere(0, 0, 100), camera(new Angular(100)));
    assertEquals(BACKGROUND.getRGB(), image.getRGB(0, 0));
    assertEquals(BACKGROUND.getRGB(), image.getRGB(39, 39));
    assertEquals(BACKGROUND.getRGB(), image.getRGB(2, 3));
    assertEquals(PAINT.getRGB(), image.getRGB(20, 0));
    assertEquals(PAINT.getRGB(), image.getRGB(20, 20));
  }

  @Test
  void theNearerObjectIsSeenAndOfTwoAtOnePlaceTheOneAddedFirst() {
    final Group3D scene = sphere(0, 0, 1);
    scene.addObject(new Sphere(new Point3D(0, 0, 0), 1, Color.RED));
    scene.addObject(new Sphere(new Point3D(0, 0, -5), 4, Color.RED));
    final Image image = new Image(1, 1, BACKGROUND);
    image.synthesis(scene, camera(new Perspective(60, 1)));
    assertEquals(PAINT.getRGB(), image.getRGB(0, 0));
    scene.addObject(new Sphere(new Point3D(0, 0, 1), 1, Color.GREEN));
    image.synthesis(scene, camera(new Perspective(60, 1)));
    assertEquals(Color.GREEN.getRGB(), image.getRGB(0, 0));
  }

  @ParameterizedTest
  @ValueSource(ints = {2, 3, 7, 64, 1000})
  void thePixelsAreTheSameForAnyNumberOfThreads(final int threads) {
    final Random random = new Random(5);
    final RandomScene scene = new RandomScene(random, 1, 40);
    final Camera camera = camera(new Perspective(50, 1.3f));
    final Image one = new Image(203, 157, BACKGROUND), several = new Image(203, 157, BACKGROUND);
    assertTrue(one.synthesis(scene.scene, camera, RenderSettings.STANDARD.withThreads(1).withShading(Shading.FACING)));
    assertTrue(several.synthesis(scene.scene, camera,
        RenderSettings.STANDARD.withThreads(threads).withShading(Shading.FACING)));
    assertArrayEquals(pixels(one), pixels(several));
  }

  @Test
  void severalImagesOfASceneCanBeComputedAtOnce() throws InterruptedException {
    final RandomScene scene = new RandomScene(new Random(6), 1, 60);
    final Camera camera = camera(new Perspective(50, 1));
    final Image[] images = new Image[4];
    final Thread[] threads = new Thread[images.length];
    for (int i = 0; i < images.length; i++) {
      final Image image = new Image(100, 100, BACKGROUND);
      images[i] = image;
      threads[i] = new Thread(() -> image.synthesis(scene.scene, camera));
      threads[i].start();
    }
    for (final Thread thread : threads) {
      thread.join();
    }
    final int[] expected = SingleRays.pixels(scene.linear, camera, 100, 100, BACKGROUND.getRGB(), Shading.PLAIN);
    for (final Image image : images) {
      assertArrayEquals(expected, pixels(image));
    }
  }

  @ParameterizedTest
  @CsvSource({"0,5", "5,0", "-1,5", "5,-1", "65536,65536", "2147483647,2", "1,2147483647"})
  void rejectsSizesThatCannotBeHeld(final int W, final int H) {
    final Exception wrong = assertThrows(IllegalArgumentException.class, () -> new Image(W, H, BACKGROUND));
    assertTrue(wrong.getMessage().contains(String.valueOf(W < H ? W : H)) || wrong.getMessage().contains("65,536")
        || wrong.getMessage().contains("65536"), wrong.getMessage());
  }

  @Test
  void rejectsNull() {
    assertThrows(IllegalArgumentException.class, () -> new Image(5, 5, null));
    final Image image = new Image(5, 5, BACKGROUND);
    final Camera camera = camera(new Perspective(60, 1));
    assertThrows(IllegalArgumentException.class, () -> image.synthesis(null, camera));
    assertThrows(IllegalArgumentException.class, () -> image.synthesis(new Group3D(), null));
    assertThrows(IllegalArgumentException.class, () -> image.synthesis(new Group3D(), camera, (RenderSettings) null));
    assertThrows(IllegalArgumentException.class, () -> image.synthesis(new Group3D(), camera, (LightGroup) null));
  }

  @Test
  void aCameraWithoutAProjectionIsAWrongState() {
    final Camera camera = new Camera(new Point3D(0, 0, 5), new Point3D(), new Vector3D(0, 1, 0));
    assertThrows(IllegalStateException.class, () -> new Image(5, 5, BACKGROUND).synthesis(new Group3D(), camera));
  }

  @Test
  void whatLiesBeyondTheNumbersOfAFloatIsNotSeenAndDoesNoHarm() {
    final Group3D scene = new Group3D();
    scene.addObject(new Sphere(new Point3D(3.3e38f, 0, 0), 3e38f, PAINT));
    final Camera camera = new Camera(new Point3D(3.2e38f, 0, 0), new Point3D(3.4e38f, 0, 0), new Vector3D(0, 1, 0));
    camera.setProjection(new Perspective(120, 1));
    final Image image = new Image(32, 32, BACKGROUND);
    image.synthesis(scene, camera, RenderSettings.STANDARD.withShading(Shading.FACING));
    assertArrayEquals(SingleRays.pixels(scene, camera, 32, 32, BACKGROUND.getRGB(), Shading.FACING), pixels(image));
  }

  /** A system that allows no more threads fails when one is started. */
  @Test
  void theThreadsThatThereAreDoTheWork() {
    final Group3D scene = new Group3D();
    scene.addObject(new Sphere(new Point3D(), 1, Color.RED));
    final Camera camera = new Camera(new Point3D(0, 0, 5), new Point3D(), new Vector3D(0, 1, 0));
    camera.setProjection(new Perspective(60, 1));
    final Image alone = new Image(90, 70, Color.BLUE), few = new Image(90, 70, Color.BLUE);
    alone.synthesis(scene, camera);
    final AtomicInteger threads = new AtomicInteger();
    assertTrue(few.synthesis(scene, camera, RenderSettings.STANDARD.withThreads(9), work -> new Thread(work) {
      @Override
      public synchronized void start() {
        if (threads.incrementAndGet() > 3) {
          throw new OutOfMemoryError("unable to create native thread");
        }
        super.start();
      }
    }));
    assertEquals(4, threads.get());
    assertArrayEquals(alone.getRGB(0, 0, 90, 70, null, 0, 90), few.getRGB(0, 0, 90, 70, null, 0, 90));
  }
}
