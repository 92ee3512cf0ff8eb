package window;

import java.awt.BorderLayout;
import java.awt.FlowLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;

import arguments.Messages;
import inspection.Inspection;
import inspection.Intersection;
import inspection.LightRays;
import inspection.Wireframe;
import tracer.Hit;
import upnatray.RenderJob;

/** The wireframe view in a dialog of its own. The boxes of objects are computed in the background. */
final class WireframeDialog {

  private final RenderWindow window;
  private final WireframeView view = new WireframeView();
  private final LatestOnlyExecutor background = new LatestOnlyExecutor("wireframe");
  private JDialog dialog;

  WireframeDialog(final RenderWindow window) {
    this.window = window;
  }

  WireframeView view() {
    return view;
  }

  /** Opens the dialog with the scene of a picture. */
  void show(final RenderJob job) {
    setLines(() -> Wireframe.of(job.scene(), job.image().getWidth(), job.image().getHeight()));
    if (dialog == null) {
      create();
    }
    dialog.setVisible(true);
  }

  private void create() {
    dialog = new JDialog(window.frame(), Messages.text("window.wireframe.text"));
    dialog.setName("wireframeDialog");
    final JPanel buttons = new JPanel(new FlowLayout(FlowLayout.TRAILING));
    buttons.add(new JButton(Command.of("wireframe.save", "", () -> window.dialogs().chooseDrawing(view))))
        .setName("wireframe.save");
    dialog.add(view, BorderLayout.CENTER);
    dialog.add(buttons, BorderLayout.SOUTH);
    dialog.pack();
    dialog.setLocationRelativeTo(window.frame());
    WindowPlacement.fit(dialog);
    WireframeKeys.bind(view, dialog::dispose);
  }

  /** Adds the ray of the pinned pixel and those of its light, if the dialog is open. */
  void showRay(final RenderJob job, final Inspection inspection) {
    if (dialog != null && dialog.isVisible()) {
      setLines(() -> lines(job, inspection));
    }
  }

  private static List<Wireframe.Line> lines(final RenderJob job, final Inspection inspection) {
    final Hit hit = inspection.winner().map(Intersection::hit).orElse(Hit.NOHIT);
    final List<Wireframe.Line> lines = new ArrayList<>(Wireframe.of(job.scene(), job.image().getWidth(),
        job.image().getHeight(), inspection.pixel().ray(), hit));
    inspection.light().ifPresent(light -> lines.addAll(LightRays.of(light.root(), hit.getT())));
    return lines;
  }

  private void setLines(final Supplier<List<Wireframe.Line>> lines) {
    background.execute(() -> {
      try {
        final List<Wireframe.Line> made = lines.get();
        SwingUtilities.invokeLater(() -> view.setLines(made));
      } catch (final RuntimeException | StackOverflowError failure) {
        SwingUtilities.invokeLater(() -> window.status().showText(Failure.problem(failure).toString()));
      }
    });
  }

  void close() {
    if (dialog != null) {
      dialog.dispose();
    }
  }
}
