package window;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Point;
import java.util.Locale;

import javax.swing.Action;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.SwingConstants;

import arguments.Messages;
import upnatray.RenderJob;

/** The status bar: the pixel under the pointer, and progress and outcome of the rendering. */
final class StatusBar extends JPanel {

  private static final long serialVersionUID = 1L;

  private static final int STEPS = 1000;

  private final JLabel pixel = new JLabel(" ");
  private final JLabel zoom = new JLabel(" ");
  private final JLabel text = new JLabel(" ");
  private final JProgressBar progress = new JProgressBar(0, STEPS);
  private final JButton cancel;

  StatusBar(final Action cancelling) {
    super(new BorderLayout(12, 0));
    setBorder(BorderFactory.createEmptyBorder(3, 8, 3, 8));
    pixel.setName("pixel");
    text.setName("status");
    progress.setName("progress");
    progress.getAccessibleContext().setAccessibleName(Messages.text("window.progress.name"));
    progress.setPreferredSize(new Dimension(120, 18));
    cancel = new JButton(cancelling);
    cancel.setName("cancel");
    cancel.setHideActionText(false);
    zoom.setPreferredSize(new Dimension(zoom.getFontMetrics(zoom.getFont()).stringWidth("00000.0 %"), 18));
    text.setHorizontalAlignment(SwingConstants.TRAILING);
    final JPanel left = new JPanel(new BorderLayout(12, 0)), right = new JPanel(new BorderLayout(6, 0));
    left.add(zoom, BorderLayout.WEST);
    left.add(pixel, BorderLayout.CENTER);
    right.add(progress, BorderLayout.CENTER);
    right.add(cancel, BorderLayout.EAST);
    add(left, BorderLayout.WEST);
    add(text, BorderLayout.CENTER);
    add(right, BorderLayout.EAST);
    setPreferredSize(getPreferredSize());
    setRunning(false);
  }

  /** Shows a pixel in the convention of the assignment, with row 0 at the bottom; null clears it. */
  void showPixel(final Point place, final int H, final int argb) {
    pixel.setText(place == null ? " " : Messages.text("window.status.pixel", place.x, H - 1 - place.y,
        InspectionTree.colour(argb), String.format(Locale.ROOT, "#%08x", argb)));
  }

  /** Shows the number of device pixels per pixel of the picture; 0 clears it. */
  void showZoom(final double magnification) {
    zoom.setText(magnification == 0 ? " " : String.format(Locale.ROOT, "%.4g %%", 100 * magnification));
  }

  void setRunning(final boolean running) {
    progress.setVisible(running);
    cancel.setVisible(running);
  }

  void showProgress(final RenderJob job) {
    progress.setValue((int) (STEPS * job.share()));
    final double left = job.secondsLeft();
    final String key = job.samples() == 1 ? "progress" : job.isAtEdges() ? "refiningEdges" : "refining";
    text.setText(Messages.text("window.status." + key,
        (int) (100 * job.share()), left < Double.POSITIVE_INFINITY ? seconds(left) : "?", rays(job.raysPerSecond()),
        job.samples()));
  }

  /** The message for a rendering that has ended. */
  static String finished(final RenderJob job, final boolean completed) {
    final String key = !completed ? "cancelled" : job.samples() == 1 ? "finished"
        : job.isAtEdges() ? "refinedEdges" : "refined";
    return Messages.text("window.status." + key, job.image().getWidth(), job.image().getHeight(), seconds(job.seconds()),
        rays(job.raysPerSecond()), job.samples());
  }

  void showText(final String message) {
    text.setText(message);
    text.setToolTipText(message);
  }

  private static String seconds(final double seconds) {
    return seconds < 60 ? String.format(Locale.ROOT, seconds < 1 ? "%.3f s" : "%.1f s", seconds)
        : String.format(Locale.ROOT, "%d:%02d min", (long) seconds / 60, (long) seconds % 60);
  }

  private static String rays(final double rays) {
    return rays < 1e6 ? String.format(Locale.ROOT, "%.0f k", rays * 1e-3)
        : String.format(Locale.ROOT, "%.2f M", rays * 1e-6);
  }
}
