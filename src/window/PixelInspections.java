package window;

import java.awt.Point;

import javax.swing.SwingUtilities;
import javax.swing.Timer;
import javax.swing.tree.DefaultMutableTreeNode;

import arguments.Messages;
import inspection.Inspection;
import inspection.Inspector;
import upnatray.RenderJob;

/** Inspects pixels in the background, so that a shape that is slow or never returns cannot block the window. */
final class PixelInspections {

  /** Delay in ms before "waiting" is shown. */
  static final int WAITING_DELAY_MS = 300;

  private final RenderWindow window;
  private final LatestOnlyExecutor background = new LatestOnlyExecutor("inspector");
  private Object pending;

  PixelInspections(final RenderWindow window) {
    this.window = window;
  }

  /** Inspects a pixel of a picture, counted from the upper left corner. */
  void inspect(final RenderJob job, final Point pixel) {
    final int W = job.image().getWidth(), H = job.image().getHeight(), m = pixel.x, n = H - 1 - pixel.y;
    final Object request = new Object();
    pending = request;
    background.execute(() -> {
      try {
        final Inspection inspection = new Inspector(job.scene(), W, H).inspect(m, n);
        final DefaultMutableTreeNode lines = InspectionTree.of(inspection, job.scene().names(),
            new Samples(job.samples(), job.isAtEdges()));
        SwingUtilities.invokeLater(() -> succeeded(request, job, inspection, lines));
      } catch (final RuntimeException | Error failure) {
        SwingUtilities.invokeLater(() -> failed(request, failure));
      }
    });
    final Timer timer = new Timer(WAITING_DELAY_MS, event -> {
      if (pending == request) {
        window.inspector().showNothing(Messages.text("window.inspector.waiting", m, n));
      }
    });
    timer.setRepeats(false);
    timer.start();
  }

  private void succeeded(final Object request, final RenderJob job, final Inspection inspection,
      final DefaultMutableTreeNode lines) {
    if (pending == request) {
      pending = null;
      window.inspector().show(inspection, lines, window.session().file());
      window.dialogs().wireframeDialog().showRay(job, inspection);
    }
  }

  private void failed(final Object request, final Throwable failure) {
    if (pending == request) {
      pending = null;
      window.inspector().showNothing(Failure.problem(failure).toString());
    }
  }

  /** Discards the result of the current inspection. */
  void discard() {
    pending = null;
  }
}
