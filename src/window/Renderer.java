package window;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

import javax.swing.SwingUtilities;

import scenes.Reading;
import scenes.Scene;
import scenes.SceneReader;
import upnatray.RenderJob;
import upnatray.View;

/** Reads and renders scenes in the background, the latest wish first: a rendering that is no longer wanted is cancelled. */
final class Renderer {

  /** Is told by the event thread what becomes of a wish. */
  interface Listener {

    /** A scene was read, perhaps with errors only. */
    void read(Reading reading);

    /** A rendering begins. */
    void started(RenderJob job, Canvas canvas);

    /** A rendering came to its end, or was cancelled. */
    void finished(RenderJob job, boolean completed);

    /** A rendering failed: a shape threw an exception, or memory is full. */
    void failed(Throwable failure);
  }

  /**
   * What to render.
   *
   * @param file scene file to read; null for a scene that is known
   * @param scene the scene; null for a file
   */
  record Wish(Path file, Scene scene, View view, PictureSize size, int threads) {
  }

  private final Listener listener;
  private final ExecutorService thread = Executors.newSingleThreadExecutor(work -> {
    final Thread renderer = new Thread(work, "renderer");
    renderer.setDaemon(true);
    return renderer;
  });
  private Wish latest;
  private RenderJob running;
  private BufferedImage before;

  Renderer(final Listener listener) {
    this.listener = listener;
  }

  synchronized void render(final Wish wish) {
    latest = wish;
    cancel();
    thread.execute(() -> fulfil(wish));
  }

  synchronized void cancel() {
    if (running != null) {
      running.cancel();
    }
  }

  /** Renders no more. */
  void stop() {
    cancel();
    thread.shutdownNow();
  }

  private synchronized boolean isLatest(final Wish wish) {
    return wish == latest;
  }

  private synchronized void setRunning(final Wish wish, final RenderJob job) {
    running = job;
    if (job != null && wish != latest) {
      job.cancel();
    }
  }

  private void fulfil(final Wish wish) {
    if (!isLatest(wish)) {
      return;
    }
    try {
      final Optional<Scene> scene = wish.scene != null ? Optional.of(wish.scene) : read(wish.file);
      if (scene.isPresent()) {
        render(wish, scene.get());
      }
    } catch (final RuntimeException | Error failure) {
      SwingUtilities.invokeLater(() -> listener.failed(failure));
    } finally {
      setRunning(wish, null);
    }
  }

  private Optional<Scene> read(final Path file) {
    final Reading reading = SceneReader.read(file);
    SwingUtilities.invokeLater(() -> listener.read(reading));
    return reading.scene();
  }

  private void render(final Wish wish, final Scene scene) {
    final int W = wish.size.widthOf(scene.width(), scene.height()), H = wish.size.heightOf(scene.width(), scene.height());
    final RenderJob job = new RenderJob(scene, wish.view, W, H, wish.threads);
    final Canvas canvas = new Canvas(job.image(), before);
    setRunning(wish, job);
    SwingUtilities.invokeLater(() -> listener.started(job, canvas));
    final boolean completed = job.run(canvas);
    if (completed) {
      canvas.tileDone(0, 0, W, H);
    }
    before = canvas.picture();
    SwingUtilities.invokeLater(() -> listener.finished(job, completed));
  }}
