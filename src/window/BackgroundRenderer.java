package window;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;

import javax.swing.SwingUtilities;

import scenes.ReadResult;
import scenes.SceneFile;
import scenes.SceneReader;
import upnatray.RenderJob;
import rendering.RenderPass;

/** Reads and renders scenes in the background, the latest wish first: a rendering that is no longer wanted is cancelled. */
final class BackgroundRenderer {

  /** Is told by the event thread what becomes of the latest wish, and of no other. */
  interface Listener {

    /** A scene was read, perhaps with errors only. */
    void read(ReadResult reading);

    /** A rendering begins. */
    void started(RenderJob job, ProgressivePicture canvas);

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
  record RenderRequest(Path file, SceneFile scene, RenderPass view, PictureSize size, int threads) {

    boolean isOfSame(final RenderRequest other) {
      return Objects.equals(file, other.file) && scene == other.scene;
    }
  }

  private final Listener listener;
  private final LatestOnlyExecutor background = new LatestOnlyExecutor("renderer");
  private RenderRequest latest;
  private RenderJob running;
  private BufferedImage before;

  BackgroundRenderer(final Listener listener) {
    this.listener = listener;
  }

  synchronized void render(final RenderRequest wish) {
    if (latest != null && !wish.isOfSame(latest)) {
      before = null;
    }
    latest = wish;
    cancel();
    background.execute(() -> fulfil(wish));
  }

  synchronized void cancel() {
    if (running != null) {
      running.cancel();
    }
  }

  /** Renders no more. */
  void stop() {
    cancel();
    background.stop();
  }

  private synchronized boolean isLatest(final RenderRequest wish) {
    return wish == latest;
  }

  /** Tells the listener, unless there is another wish by now. */
  private void tell(final RenderRequest wish, final Runnable what) {
    SwingUtilities.invokeLater(() -> {
      if (isLatest(wish)) {
        what.run();
      }
    });
  }

  private void fulfil(final RenderRequest wish) {
    try {
      final Optional<SceneFile> scene = wish.scene != null ? Optional.of(wish.scene) : read(wish);
      if (scene.isPresent() && isLatest(wish)) {
        render(wish, scene.get());
      }
    } catch (final RuntimeException | Error failure) {
      tell(wish, () -> listener.failed(failure));
    }
  }

  private Optional<SceneFile> read(final RenderRequest wish) {
    final ReadResult reading = SceneReader.read(wish.file);
    tell(wish, () -> listener.read(reading));
    return reading.scene();
  }

  private void render(final RenderRequest wish, final SceneFile scene) {
    final int W = wish.size.widthOf(scene.width(), scene.height()), H = wish.size.heightOf(scene.width(), scene.height());
    final RenderJob job = new RenderJob(scene, wish.view, W, H, wish.threads);
    final ProgressivePicture canvas = begin(wish, job);
    tell(wish, () -> listener.started(job, canvas));
    final boolean completed = job.run(canvas);
    if (completed) {
      canvas.tileDone(0, 0, W, H);
    }
    tell(wish, () -> listener.finished(job, completed));
  }

  /** What a rendering paints on. Before it begins it may be unwanted already. */
  private synchronized ProgressivePicture begin(final RenderRequest wish, final RenderJob job) {
    final ProgressivePicture canvas = new ProgressivePicture(job.image(), before);
    if (isLatest(wish)) {
      running = job;
      before = canvas.picture();
    } else {
      job.cancel();
    }
    return canvas;
  }
}
