package window;

import java.awt.BorderLayout;
import java.awt.FlowLayout;
import java.awt.Point;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;

import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;

import arguments.Messages;
import inspection.Difference;

/** Compares the picture of a window, and each picture rendered while this dialog is open, with a reference. */
final class Comparison {

  private final PictureView view;
  private final BufferedImage reference;
  private final JDialog dialog;
  private final JLabel figures = new JLabel();
  private final Command worst = Command.of("compare.worst", "", this::showWorst);
  private final Command mask = Command.of("compare.mask", "", this::switchMask);
  private final LatestOnlyExecutor background = new LatestOnlyExecutor("comparison");
  private Difference difference;

  /** Opens the dialog beside a window. */
  Comparison(final RenderWindow window, final BufferedImage reference, final Path file) {
    this.view = window.view();
    this.reference = reference;
    this.dialog = new JDialog(window.frame(), Messages.text("window.compare.title", file.getFileName()));
    dialog.setName("comparison");
    figures.setName("figures");
    layOut(Command.of("compare.close", "ESCAPE", this::end));
    figures.setText(Messages.text("window.compare.running"));
    dialog.pack();
    dialog.setLocation(window.frame().getX() + 40, window.frame().getY() + 120);
    WindowPlacement.fit(dialog);
    dialog.setVisible(true);
    compare();
  }

  private void layOut(final Command end) {
    final JPanel buttons = new JPanel(new FlowLayout(FlowLayout.TRAILING));
    for (final Command command : new Command[] {worst, mask, end}) {
      buttons.add(new JButton(command)).setName(command.key());
    }
    final JPanel all = new JPanel(new BorderLayout(8, 8));
    all.setBorder(BorderFactory.createEmptyBorder(10, 12, 6, 12));
    all.add(figures, BorderLayout.CENTER);
    all.add(buttons, BorderLayout.SOUTH);
    dialog.add(all);
    dialog.getRootPane().registerKeyboardAction(end, KeyStroke.getKeyStroke("ESCAPE"),
        JComponent.WHEN_IN_FOCUSED_WINDOW);
    dialog.addWindowListener(new WindowAdapter() {
      @Override
      public void windowClosing(final WindowEvent event) {
        end();
      }
    });
  }

  boolean isOpen() {
    return dialog.isDisplayable();
  }

  /** Compares the current picture in the background. */
  void compare() {
    final BufferedImage picture = view.picture();
    worst.setEnabled(false);
    mask.setEnabled(false);
    background.execute(() -> {
      final Optional<Difference> found = Difference.between(picture, reference);
      SwingUtilities.invokeLater(() -> {
        if (isOpen() && view.picture() == picture) {
          show(picture, found);
        }
      });
    });
  }

  private void show(final BufferedImage picture, final Optional<Difference> found) {
    difference = found.orElse(null);
    view.setOverlay(found.map(Difference::mask).orElse(null));
    worst.setEnabled(found.isPresent() && difference.differing() > 0);
    mask.setEnabled(found.isPresent());
    figures.setText(found.isEmpty()
        ? Messages.text("window.compare.size", reference.getWidth(), reference.getHeight(), picture.getWidth(),
            picture.getHeight())
        : Messages.text("window.compare.figures", difference.differing(), difference.largest(),
            String.format(Locale.ROOT, "%.4f", difference.mean())));
    dialog.pack();
    WindowPlacement.fit(dialog);
  }

  private void showWorst() {
    view.show(new Point(difference.worstX(), difference.worstY()));
  }

  private void switchMask() {
    view.setOverlay(view.hasOverlay() ? null : difference.mask());
  }

  void end() {
    background.stop();
    view.setOverlay(null);
    dialog.dispose();
  }
}
