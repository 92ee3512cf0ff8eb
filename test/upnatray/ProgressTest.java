package upnatray;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicIntegerArray;

import models.Group3D;
import models.Object3D;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rendering.Progress;
import rendering.RenderSettings;
import rendering.Shading;
import tracer.Hit;
import tracer.Ray;
import view.Camera;
import view.Perspective;

/** Watching a synthesis, stopping it, and failures during one. */
class ProgressTest {

  private static final Camera CAMERA = ImageTest.camera(new Perspective(60, 1));

  private static RenderSettings watched(final int threads, final Progress progress) {
    return new RenderSettings(threads, Shading.PLAIN, progress);
  }

  @ParameterizedTest
  @CsvSource({"1,1,1", "1,50,2", "50,1,2", "16,16,1", "17,33,3", "100,70,2", "100,70,7"})
  void everyPixelIsToldOnceAndFinishedByThen(final int W, final int H, final int threads) {
    final Image image = new Image(W, H, Color.BLACK);
    final Group3D scene = ImageTest.sphere(0, 0, 100);
    final int inside = scene.intersectionWith(CAMERA.getRayGenerator(1, 1).getRay(0, 0)).getObject().getColor().getRGB();
    final AtomicIntegerArray reported = new AtomicIntegerArray(W * H);
    final AtomicInteger unfinished = new AtomicInteger();
    assertTrue(image.synthesis(scene, CAMERA, watched(threads, (x, y, width, height) -> {
      for (int i = 0; i < width * height; i++) {
        reported.incrementAndGet((y + i / width) * W + x + i % width);
        unfinished.addAndGet(image.getRGB(x + i % width, y + i / width) == inside ? 0 : 1);
      }
      return true;
    })));
    for (int i = 0; i < W * H; i++) {
      assertEquals(1, reported.get(i), "pixel " + i);
    }
    assertEquals(0, unfinished.get());
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3})
  void falseStops(final int threads) {
    final Image image = new Image(400, 400, Color.BLACK);
    final AtomicInteger tiles = new AtomicInteger();
    assertFalse(image.synthesis(ImageTest.sphere(0, 0, 100), CAMERA,
        watched(threads, (x, y, width, height) -> tiles.incrementAndGet() < 10)));
    assertTrue(tiles.get() >= 10 && tiles.get() < 10 + threads, () -> tiles + " tiles");
    int black = 0;
    for (final int pixel : ImageTest.pixels(image)) {
      black += pixel == Color.BLACK.getRGB() ? 1 : 0;
    }
    assertTrue(black > 600 * 200 && black <= 400 * 400 - 10 * 256, "black pixels: " + black);
  }

  @Test
  void aStoppedSynthesisCanBeRepeated() {
    final Image image = new Image(60, 60, Color.BLACK), whole = new Image(60, 60, Color.BLACK);
    final Group3D scene = ImageTest.sphere(0, 0, 2);
    assertFalse(image.synthesis(scene, CAMERA, watched(2, (x, y, width, height) -> false)));
    assertTrue(image.synthesis(scene, CAMERA, watched(2, Progress.NONE)));
    whole.synthesis(scene, CAMERA);
    assertArrayEquals(ImageTest.pixels(whole), ImageTest.pixels(image));
  }

  /** A student's object that fails at some pixel. */
  private static Group3D failing(final Throwable failure, final int pixel) {
    final AtomicInteger asked = new AtomicInteger();
    final Group3D scene = new Group3D();
    scene.addObject(new Object3D(Color.RED) {
      @Override
      public Hit intersectionWith(final Ray ray) {
        if (asked.incrementAndGet() >= pixel) {
          if (failure instanceof Error) {
            throw (Error) failure;
          }
          throw (RuntimeException) failure;
        }
        return Hit.NOHIT;
      }
    });
    return scene;
  }

  @ParameterizedTest
  @CsvSource({"1,1", "2,1", "2,3000", "3,5000", "7,100"})
  void whatAnObjectThrowsReachesTheCaller(final int threads, final int pixel) {
    final Image image = new Image(100, 100, Color.BLACK);
    final RuntimeException exception = new ArithmeticException("by a student");
    final Exception thrown = assertThrows(IllegalStateException.class,
        () -> image.synthesis(failing(exception, pixel), CAMERA, watched(threads, Progress.NONE)));
    assertSame(exception, thrown.getCause());
    final Error error = new AssertionError("by a student");
    assertSame(error, assertThrows(AssertionError.class,
        () -> image.synthesis(failing(error, pixel), CAMERA, watched(threads, Progress.NONE))));
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 3})
  void whatTheWatcherThrowsReachesTheCaller(final int threads) {
    final Image image = new Image(100, 100, Color.BLACK);
    final RuntimeException exception = new IllegalStateException("by a watcher");
    assertSame(exception, assertThrows(IllegalStateException.class, () -> image.synthesis(new Group3D(), CAMERA,
        watched(threads, (x, y, width, height) -> {
          throw exception;
        }))));
  }

  @Test
  void anObjectThatAnswersNullIsNamed() {
    final class Forgetful extends Object3D {
      Forgetful() {
        super(Color.RED);
      }

      @Override
      public Hit intersectionWith(final Ray ray) {
        return null;
      }
    }

    final Group3D scene = new Group3D();
    scene.addObject(new Forgetful());
    final Image image = new Image(20, 20, Color.BLACK);
    final Exception wrong = assertThrows(IllegalStateException.class, () -> image.synthesis(scene, CAMERA));
    assertTrue(wrong.getMessage().contains("Forgetful"), wrong.getMessage());
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2})
  void anInterruptedThreadFinishesThePictureAndStaysInterrupted(final int threads) throws InterruptedException {
    final Image image = new Image(64, 64, Color.BLACK), whole = new Image(64, 64, Color.BLACK);
    final Group3D scene = ImageTest.sphere(0, 0, 2);
    whole.synthesis(scene, CAMERA);
    final AtomicBoolean finished = new AtomicBoolean(), interrupted = new AtomicBoolean();
    final CountDownLatch mainIsDone = new CountDownLatch(1);
    final Thread caller = new Thread(() -> {
      Thread.currentThread().interrupt();
      finished.set(image.synthesis(scene, CAMERA, watched(threads, (x, y, width, height) -> {
        if (Thread.currentThread().isInterrupted()) {
          mainIsDone.countDown();
        } else {
          Assertions.assertTimeoutPreemptively(Duration.ofSeconds(20), () -> mainIsDone.await());
        }
        return true;
      })));
      interrupted.set(Thread.currentThread().isInterrupted());
    });
    caller.start();
    caller.join();
    assertTrue(interrupted.get());
    assertTrue(finished.get());
    assertArrayEquals(ImageTest.pixels(whole), ImageTest.pixels(image));
  }
}
