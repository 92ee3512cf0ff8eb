package window;

import java.util.List;

import javax.swing.Timer;

import arguments.Messages;
import scenes.ReadResult;
import upnatray.RenderJob;

/** Presents a rendering in a window: pixels and progress, legend and problems. */
final class RenderPresenter implements BackgroundRenderer.Listener {

  /** Interval between updates of the picture in ms: short enough to look continuous, long enough to be cheap. */
  private static final int DELAY_MS = 80;

  /** Painting takes at most 1/80 of the time of one core, whatever the size of the picture ... */
  private static final int PAINTING_RATIO = 80;

  /** ... but the picture is updated at least this often. */
  private static final int MAX_DELAY_MS = 500;

  private final RenderWindow window;
  private final Timer updates = new Timer(DELAY_MS, event -> showProgress());
  private RenderJob job;
  private ProgressivePicture picture;
  private StallDetector stall = new StallDetector();
  private boolean running;

  RenderPresenter(final RenderWindow window) {
    this.window = window;
  }

  /** The rendering that is shown; null if none. */
  RenderJob job() {
    return job;
  }

  boolean isRunning() {
    return running;
  }

  /** Whether the window shows the picture of a job, perhaps refined. */
  boolean shows(final RenderJob other) {
    return job != null && job.scene() == other.scene() && job.view() == other.view()
        && job.image().getWidth() == other.image().getWidth() && job.image().getHeight() == other.image().getHeight();
  }

  /** Drops the rendering: another scene is being opened. */
  void reset() {
    job = null;
    picture = null;
  }

  @Override
  public void read(final ReadResult result) {
    window.problems().show(result.problems());
    if (result.scene().isPresent()) {
      window.session().watchMeshes(result.scene().get());
      if (window.session().hasRead(result.scene().get())) {
        window.camera().reset();
      }
    } else {
      end(Messages.text(job == null ? "window.status.errors" : "window.status.errorsBefore"));
      if (job == null) {
        window.view().clear();
      }
    }
  }

  @Override
  public void started(final RenderJob next, final ProgressivePicture nextPicture) {
    window.dialogs().closeLights();
    job = next;
    picture = nextPicture;
    running = true;
    stall = new StallDetector();
    window.view().setPicture(nextPicture.image());
    window.view().setRendering(true);
    window.status().setRunning(true);
    window.cancelCommand().setEnabled(true);
    if (window.session().file() == null) {
      window.problems().show(List.of());
    }
    if (window.view().pinned() == null) {
      window.inspector().clear();
    }
    showProgress();
    updates.start();
  }

  /** What is pinned is inspected now, not once more at the end: so what the user selects meanwhile stays selected. */
  @Override
  public void refining(final RenderJob next, final ProgressivePicture nextPicture) {
    showProgress();
    job = next;
    picture = nextPicture;
    stall = new StallDetector();
    window.view().refine(nextPicture.image());
    repeatInspection();
  }

  /** Shows the pixels rendered since the last update. */
  private void showProgress() {
    if (picture != null) {
      window.view().repaintPixels(picture.takeChanged());
      window.legend().setScale(job.scale().orElse(null));
      updates.setDelay((int) Math.max(DELAY_MS, Math.min(MAX_DELAY_MS,
          1e3 * PAINTING_RATIO * window.view().secondsToPaint())));
      stall.check(job.share()).ifPresentOrElse(window.status()::showText, () -> window.status().showProgress(job));
    }
  }

  @Override
  public void finished(final RenderJob ended, final boolean completed) {
    showProgress();
    end(StatusBar.finished(ended, completed));
    if (ended.samples() == 1) {
      repeatInspection();
    }
    window.dialogs().renderingFinished();
  }

  private void repeatInspection() {
    if (window.view().pinned() != null) {
      window.view().pin(window.view().pinned());
    }
  }

  @Override
  public void failed(final Throwable failure) {
    end(Messages.text("window.status.failed"));
    window.problems().show(List.of(Failure.problem(failure)));
  }

  /** Cancels the rendering. After a grace period it counts as ended even if a shape has not returned. */
  void cancel() {
    window.session().cancel();
    final RenderJob cancelled = job;
    final Timer timer = new Timer(LatestOnlyExecutor.GRACE_PERIOD_MS, event -> {
      if (running && job == cancelled) {
        finished(job, false);
      }
    });
    timer.setRepeats(false);
    timer.start();
  }

  private void end(final String message) {
    updates.stop();
    running = false;
    window.view().setRendering(false);
    window.cancelCommand().setEnabled(false);
    window.status().setRunning(false);
    window.status().showText(message);
  }

  void stop() {
    updates.stop();
  }
}
