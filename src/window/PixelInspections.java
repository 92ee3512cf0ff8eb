package window;

import java.awt.Point;

import javax.swing.SwingUtilities;
import javax.swing.Timer;

import arguments.Messages;
import inspection.Inspection;
import inspection.Inspector;
import upnatray.RenderJob;

/** Asks pixels in the background, so that a shape that is slow to answer, or never does, does not hold up the window. */
final class PixelInspections {

  /** After so long without an answer it is shown that there will be one. */
  static final int SOON = 300;

  private final RenderWindow window;
  private final LatestOnlyExecutor background = new LatestOnlyExecutor("inspector");
  private Object question;

  PixelInspections(final RenderWindow window) {
    this.window = window;
  }

  /** Asks a pixel of a picture, counted from the upper left corner. */
  void ask(final RenderJob job, final Point pixel) {
    final int W = job.image().getWidth(), H = job.image().getHeight(), m = pixel.x, n = H - 1 - pixel.y;
    final Object asked = new Object();
    question = asked;
    background.execute(() -> {
      try {
        final Inspection inspection = new Inspector(job.scene(), W, H).inspect(m, n);
        SwingUtilities.invokeLater(() -> answered(asked, job, inspection));
      } catch (final RuntimeException | Error failure) {
        SwingUtilities.invokeLater(() -> failed(asked, failure));
      }
    });
    final Timer soon = new Timer(SOON, event -> {
      if (question == asked) {
        window.inspector().showNothing(Messages.text("window.inspector.waiting", m, n));
      }
    });
    soon.setRepeats(false);
    soon.start();
  }

  private void answered(final Object asked, final RenderJob job, final Inspection inspection) {
    if (question == asked) {
      question = null;
      window.inspector().show(inspection);
      window.dialogs().showRay(job, inspection);
    }
  }

  private void failed(final Object asked, final Throwable failure) {
    if (question == asked) {
      question = null;
      window.inspector().showNothing(Failure.problem(failure).toString());
    }
  }

  /** The answer is no longer wanted. */
  void forget() {
    question = null;
  }
}
