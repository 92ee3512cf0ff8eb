package window;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;

import javax.swing.SwingUtilities;

import scenes.ReadResult;
import scenes.SceneFile;
import scenes.SceneReader;
import upnatray.RenderJob;

/** Reads and renders scenes in the background. A new request cancels the rendering in progress. */
final class BackgroundRenderer {

  /** Receives the events of the latest request, and of no other, on the event dispatch thread. */
  interface Listener {

    /** A scene file has been read, though it may have errors and yield no scene. */
    void read(ReadResult result);

    /** A rendering has started. */
    void started(RenderJob job, ProgressivePicture picture);

    /** A rendering has completed, and another with more rays for each pixel of the same picture has started. */
    void refining(RenderJob job, ProgressivePicture picture);

    /** The last rendering of a picture has completed or been cancelled. */
    void finished(RenderJob job, boolean completed);

    /** A rendering has failed: a shape threw an exception, or memory ran out. */
    void failed(Throwable failure);
  }

  /**
   * What to render.
   *
   * @param file scene file to read; null if the scene is given
   * @param scene the scene; null if it is to be read from the file
   * @param options how to render it
   * @param camera a camera to be used in place of that of the scene; null for none
   * @param preview picture to be shown at first, of any size; null for the previous one
   */
  record RenderRequest(Path file, SceneFile scene, PictureOptions options, CameraChange camera, BufferedImage preview) {

    boolean showsSameSceneAs(final RenderRequest other) {
      return Objects.equals(file, other.file) && (file != null || scene == other.scene);
    }
  }

  private final Listener listener;
  private final LatestOnlyExecutor background = new LatestOnlyExecutor("renderer");
  private RenderRequest latest;
  private RenderRequest cancelled;
  private RenderJob running;
  private BufferedImage previous;

  BackgroundRenderer(final Listener listener) {
    this.listener = listener;
  }

  synchronized void render(final RenderRequest request) {
    if (latest != null && !request.showsSameSceneAs(latest)) {
      previous = null;
    }
    cancel();
    latest = request;
    background.execute(() -> process(request));
  }

  synchronized void cancel() {
    cancelled = latest;
    if (running != null) {
      running.cancel();
    }
  }

  /** Cancels the current rendering and starts no other. */
  void stop() {
    cancel();
    background.stop();
  }

  private synchronized boolean isLatest(final RenderRequest request) {
    return request == latest;
  }

  /** Notifies the listener, unless another request has been made meanwhile. */
  private void notifyListener(final RenderRequest request, final Runnable event) {
    SwingUtilities.invokeLater(() -> {
      if (isLatest(request)) {
        event.run();
      }
    });
  }

  private void process(final RenderRequest request) {
    try {
      final Optional<SceneFile> scene = request.scene != null ? Optional.of(request.scene) : read(request);
      if (scene.isPresent() && isLatest(request)) {
        render(request, request.camera == null ? scene.get() : request.camera.applyTo(scene.get()));
      }
    } catch (final RuntimeException | Error failure) {
      notifyListener(request, () -> listener.failed(failure));
    }
  }

  private Optional<SceneFile> read(final RenderRequest request) {
    final ReadResult result = SceneReader.read(request.file);
    notifyListener(request, () -> listener.read(result));
    return result.scene();
  }

  private void render(final RenderRequest request, final SceneFile scene) {
    final PictureOptions options = request.options;
    final int W = options.size().widthOf(scene.width(), scene.height());
    final int H = options.size().heightOf(scene.width(), scene.height());
    final RenderJob first = new RenderJob(scene, options.pass(), W, H, options.threads());
    final ProgressivePicture picture = begin(request, first, request.preview);
    notifyListener(request, () -> listener.started(first, picture));
    final boolean completed = run(first, picture);
    if (completed && options.isRefined()) {
      refine(request, first);
    } else {
      notifyListener(request, () -> listener.finished(first, completed));
    }
  }

  /** Renders a picture once more, with more rays for each pixel. */
  private void refine(final RenderRequest request, final RenderJob first) {
    final Samples samples = request.options.samples();
    final RenderJob job = first.refined(samples.K(), samples.atEdges());
    final ProgressivePicture picture = begin(request, job, null);
    notifyListener(request, () -> listener.refining(job, picture));
    final boolean completed = run(job, picture);
    notifyListener(request, () -> listener.finished(job, completed));
  }

  private static boolean run(final RenderJob job, final ProgressivePicture picture) {
    final boolean completed = job.run(picture);
    if (completed) {
      picture.tileDone(0, 0, job.image().getWidth(), job.image().getHeight());
    }
    return completed;
  }

  /** A coarse picture in the size of an image. */
  private static BufferedImage scaled(final BufferedImage preview, final BufferedImage image) {
    final BufferedImage scaled = new BufferedImage(image.getWidth(), image.getHeight(), image.getType());
    final Graphics2D g = scaled.createGraphics();
    g.drawImage(preview, 0, 0, image.getWidth(), image.getHeight(), null);
    g.dispose();
    return scaled;
  }

  /** The picture that the job fills. If the request is no longer wanted, the job is cancelled before it runs. */
  private ProgressivePicture begin(final RenderRequest request, final RenderJob job, final BufferedImage preview) {
    final ProgressivePicture picture = new ProgressivePicture(job.image(),
        preview == null ? previous() : scaled(preview, job.image()));
    synchronized (this) {
      if (isLatest(request) && request != cancelled) {
        running = job;
        previous = picture.image();
      } else {
        job.cancel();
      }
    }
    return picture;
  }

  private synchronized BufferedImage previous() {
    return previous;
  }
}
