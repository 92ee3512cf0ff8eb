package window;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

import inspection.SampleScenes;
import models.Sphere;
import primitives.Point3D;
import rendering.Progress;
import rendering.RenderPass;
import scenes.ReadResult;
import scenes.SceneFile;
import tracer.Hit;
import tracer.Ray;
import upnatray.RenderJob;
import view.Orthographic;

class BackgroundRendererTest {

  /** Records the events and the last picture. */
  private static final class Log implements BackgroundRenderer.Listener {

    private final BlockingQueue<String> events = new LinkedBlockingQueue<>();
    private volatile RenderJob last;

    @Override
    public void read(final ReadResult result) {
      events.add("read");
    }

    @Override
    public void started(final RenderJob job, final ProgressivePicture picture) {
      events.add("started " + job.samples());
    }

    @Override
    public void refining(final RenderJob job, final ProgressivePicture picture) {
      events.add("refining " + job.samples());
    }

    @Override
    public void finished(final RenderJob job, final boolean completed) {
      last = job;
      events.add((completed ? "finished " : "cancelled ") + job.samples());
    }

    @Override
    public void failed(final Throwable failure) {
      events.add(failure.toString());
    }

    void assertNext(final String... expected) throws InterruptedException {
      for (final String event : expected) {
        assertEquals(event, events.poll(20, TimeUnit.SECONDS));
      }
    }
  }

  private final Log log = new Log();
  private final BackgroundRenderer renderer = new BackgroundRenderer(log);

  @AfterEach
  void stop() {
    renderer.stop();
  }

  private static SceneFile scene(final Sphere ball) {
    return SampleScenes.of(new Orthographic(3, 0.75f), false, ball);
  }

  private static BackgroundRenderer.RenderRequest request(final SceneFile scene, final RenderPass pass, final int samples) {
    final PictureOptions options = new PictureOptions(pass, PictureSize.OWN, new Samples(samples, false), 1);
    return new BackgroundRenderer.RenderRequest(null, scene, options, null, null);
  }

  private static int[] pixels(final BufferedImage image) {
    return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
  }

  @Test
  void onePictureIsRenderedByOneSampleFirstAndThenRefined() throws InterruptedException {
    final SceneFile scene = scene(new Sphere(new Point3D(), 1, Color.RED));
    renderer.render(request(scene, RenderPass.COLOUR, 3));
    log.assertNext("started 1", "refining 3", "finished 3");
    final RenderJob expected = new RenderJob(scene, RenderPass.COLOUR, scene.width(), scene.height(), 2)
        .refined(3, false);
    expected.run(Progress.NONE);
    assertArrayEquals(pixels(expected.image()), pixels(log.last.image()));
  }

  @Test
  void numbersAreNotRefined() throws InterruptedException {
    for (final RenderPass pass : List.of(RenderPass.DEPTH, RenderPass.COST)) {
      renderer.render(request(scene(new Sphere(new Point3D(), 1, Color.RED)), pass, 4));
      log.assertNext("started 1", "finished 1");
    }
  }

  /** A ball whose first ray waits until it is released. */
  private static final class Waiting extends Sphere {

    private final CountDownLatch begun = new CountDownLatch(1);
    private final CountDownLatch released = new CountDownLatch(1);

    Waiting() {
      super(new Point3D(), 1, Color.RED);
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      begun.countDown();
      try {
        released.await();
      } catch (final InterruptedException stopped) {
        throw new IllegalStateException(stopped);
      }
      return super.intersectionWith(ray);
    }
  }

  @Test
  void aCancelledPictureIsNotRefined() throws InterruptedException {
    final Waiting ball = new Waiting();
    renderer.render(request(scene(ball), RenderPass.COLOUR, 2));
    ball.begun.await();
    renderer.cancel();
    ball.released.countDown();
    log.assertNext("started 1", "cancelled 1");
    assertNull(log.events.poll(200, TimeUnit.MILLISECONDS));
  }

  @Test
  void onlyTheLatestRequestIsReported() throws InterruptedException {
    final Waiting ball = new Waiting();
    renderer.render(request(scene(ball), RenderPass.COLOUR, 2));
    ball.begun.await();
    log.assertNext("started 1");
    renderer.render(request(scene(new Sphere(new Point3D(), 1, Color.GREEN)), RenderPass.COLOUR, 2));
    ball.released.countDown();
    log.assertNext("started 1", "refining 2", "finished 2");
  }
}
