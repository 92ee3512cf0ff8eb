package window;

import java.util.List;

import javax.swing.Timer;

import arguments.Messages;
import scenes.ReadResult;
import upnatray.RenderJob;

/** Shows in a window what becomes of a rendering: pixels and progress, legend and problems. */
final class RenderPresenter implements BackgroundRenderer.Listener {

  /** Between two looks at what has been rendered: fast enough to look alive, and cheap. */
  private static final int MILLISECONDS_BETWEEN = 80;

  /** Painting takes at most one part in so many of the time of one core, whatever the size of the picture ... */
  private static final int PART_FOR_PAINTING = 40;

  /** ... unless it would be seen too seldom. */
  private static final int MOST_MILLISECONDS_BETWEEN = 500;

  private final RenderWindow window;
  private final Timer clock = new Timer(MILLISECONDS_BETWEEN, event -> showProgress());
  private RenderJob job;
  private ProgressivePicture canvas;
  private StallDetector standstill = new StallDetector();
  private boolean running;

  RenderPresenter(final RenderWindow window) {
    this.window = window;
  }

  /** What is shown, or was before; null if there is nothing. */
  RenderJob job() {
    return job;
  }

  boolean isRunning() {
    return running;
  }

  /** Something else is opened. */
  void forget() {
    job = null;
    canvas = null;
  }

  @Override
  public void read(final ReadResult reading) {
    window.problems().show(reading.problems());
    if (reading.scene().isPresent()) {
      window.session().watchMeshes(reading.scene().get());
    } else {
      end(Messages.text(job == null ? "window.status.errors" : "window.status.errorsBefore"));
      if (job == null) {
        window.view().clear();
      }
    }
  }

  @Override
  public void started(final RenderJob next, final ProgressivePicture itsCanvas) {
    job = next;
    canvas = itsCanvas;
    running = true;
    standstill = new StallDetector();
    window.view().setPicture(itsCanvas.picture());
    window.view().setFilling(true);
    window.status().setRunning(true);
    window.cancelCommand().setEnabled(true);
    if (window.session().file() == null) {
      window.problems().show(List.of());
    }
    if (window.view().pinned() == null) {
      window.inspector().clear();
    }
    showProgress();
    clock.start();
  }

  /** Shows the pixels that are new. */
  private void showProgress() {
    if (canvas != null) {
      window.view().repaintPixels(canvas.takeChanged());
      window.legend().setScale(job.scale().orElse(null));
      clock.setDelay((int) Math.max(MILLISECONDS_BETWEEN, Math.min(MOST_MILLISECONDS_BETWEEN,
          1e3 * PART_FOR_PAINTING * window.view().secondsToPaint())));
      standstill.look(job.share()).ifPresentOrElse(window.status()::showText, () -> window.status().showProgress(job));
    }
  }

  @Override
  public void finished(final RenderJob ended, final boolean completed) {
    showProgress();
    end(StatusBar.finished(ended, completed));
    if (window.view().pinned() != null) {
      window.view().pin(window.view().pinned());
    }
    window.dialogs().renderingFinished();
  }

  @Override
  public void failed(final Throwable failure) {
    end(Messages.text("window.status.failed"));
    window.problems().show(List.of(Failure.problem(failure)));
  }

  /** Cancels the rendering. A shape that does not answer is not waited for. */
  void cancel() {
    window.session().cancel();
    final RenderJob cancelled = job;
    final Timer patience = new Timer(LatestOnlyExecutor.PATIENCE, event -> {
      if (running && job == cancelled) {
        finished(job, false);
      }
    });
    patience.setRepeats(false);
    patience.start();
  }

  private void end(final String message) {
    clock.stop();
    running = false;
    window.view().setFilling(false);
    window.cancelCommand().setEnabled(false);
    window.status().setRunning(false);
    window.status().showText(message);
  }

  void stop() {
    clock.stop();
  }
}
