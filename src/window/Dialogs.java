package window;

import java.awt.BorderLayout;
import java.awt.FlowLayout;
import java.awt.Point;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;

import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.filechooser.FileNameExtensionFilter;

import inspection.Difference;
import inspection.Inspection;
import inspection.Meeting;
import inspection.Outline;
import tracer.Hit;
import upnatray.FailedException;
import upnatray.PngFile;
import upnatray.RenderJob;

/** What opens beside the window: choosers of files, the comparison with a reference, the scene from outside. */
final class Dialogs {

  private final RenderWindow window;
  private final OutsideView outside = new OutsideView();
  private final JLabel figures = new JLabel();
  private JDialog outsideDialog;
  private JDialog comparison;
  private BufferedImage reference;
  private Difference difference;

  Dialogs(final RenderWindow window) {
    this.window = window;
    figures.setName("figures");
  }

  void chooseScene() {
    choose("open", "xml", true, null).ifPresent(window::open);
  }

  void choosePicture() {
    if (window.view().hasPicture()) {
      choose("save", "png", false, pictureName()).ifPresent(file -> save(window.view().picture(), file));
    }
  }

  private String pictureName() {
    final Path scene = window.session().file();
    final String name = scene == null ? "picture" : Objects.toString(scene.getFileName(), "").replaceFirst("\\.xml$", "");
    return name + ".png";
  }

  void save(final BufferedImage picture, final Path file) {
    try {
      final Path target = PictureFile.withEnding(file);
      PngFile.save(picture, target);
      window.settings().setFolder(target.toAbsolutePath().getParent());
      window.status().showText(Messages.text("status.saved", target));
    } catch (final FailedException failure) {
      complain(failure.getMessage());
    }
  }

  private void complain(final String message) {
    JOptionPane.showMessageDialog(window.frame(), message, "UPNaTRay", JOptionPane.ERROR_MESSAGE);
  }

  private Optional<Path> choose(final String key, final String ending, final boolean toOpen, final String name) {
    final JFileChooser chooser = new JFileChooser(window.settings().folder().toFile());
    chooser.setDialogTitle(Messages.text(key + ".tip"));
    chooser.setFileFilter(new FileNameExtensionFilter("*." + ending, ending));
    if (name != null) {
      chooser.setSelectedFile(window.settings().folder().resolve(name).toFile());
    }
    final int answer = toOpen ? chooser.showOpenDialog(window.frame()) : chooser.showSaveDialog(window.frame());
    return answer == JFileChooser.APPROVE_OPTION ? Optional.of(chooser.getSelectedFile().toPath()) : Optional.empty();
  }

  void chooseReference() {
    if (window.view().hasPicture()) {
      choose("compare", "png", true, null).ifPresent(this::compareWith);
    }
  }

  /** Compares the picture with a file, and with each picture that is rendered from now on. */
  void compareWith(final Path file) {
    try {
      reference = PictureFile.read(file);
      openComparison(file);
      compare();
    } catch (final IOException failure) {
      final String reason = failure.getMessage() == null ? failure.toString() : failure.getMessage();
      complain(Messages.text("compare.failed", file, reason));
    }
  }

  /** A picture is finished: what is compared is compared anew. */
  void renderingFinished() {
    if (reference != null) {
      compare();
    }
  }

  private void compare() {
    final Optional<Difference> found = Difference.between(window.view().picture(), reference);
    difference = found.orElse(null);
    window.view().setOverlay(difference == null ? null : difference.mask());
    figures.setText(difference == null
        ? Messages.text("compare.size", reference.getWidth(), reference.getHeight())
        : Messages.text("compare.figures", difference.differing(), difference.largest(),
            String.format(Locale.ROOT, "%.4f", difference.mean())));
    comparison.pack();
  }

  private void openComparison(final Path file) {
    if (comparison != null) {
      comparison.dispose();
    }
    comparison = new JDialog(window.frame(), Messages.text("compare.title", file.getFileName()));
    comparison.setName("comparison");
    final JPanel buttons = new JPanel(new FlowLayout(FlowLayout.TRAILING));
    buttons.add(button("compare.worst", this::showWorst));
    buttons.add(button("compare.mask", this::switchMask));
    buttons.add(button("compare.end", this::endComparison));
    final JPanel all = new JPanel(new BorderLayout(8, 8));
    all.setBorder(javax.swing.BorderFactory.createEmptyBorder(10, 12, 6, 12));
    all.add(figures, BorderLayout.CENTER);
    all.add(buttons, BorderLayout.SOUTH);
    comparison.add(all);
    comparison.addWindowListener(new java.awt.event.WindowAdapter() {
      @Override
      public void windowClosing(final java.awt.event.WindowEvent event) {
        endComparison();
      }
    });
    comparison.pack();
    comparison.setLocation(window.frame().getX() + 40, window.frame().getY() + 120);
    comparison.setVisible(true);
  }

  private static JButton button(final String key, final Runnable job) {
    final JButton button = new JButton(Command.of(key, "", job));
    button.setName(key);
    return button;
  }

  private void showWorst() {
    if (difference != null && difference.differing() > 0) {
      window.view().show(new Point(difference.worstX(), difference.worstY()));
    }
  }

  private void switchMask() {
    final boolean shown = window.view().hasOverlay();
    window.view().setOverlay(shown || difference == null ? null : difference.mask());
  }

  private void endComparison() {
    reference = null;
    difference = null;
    window.view().setOverlay(null);
    comparison.dispose();
  }

  /** Opens the scene from outside. */
  void showOutside(final RenderJob job) {
    outside.setLines(Outline.of(job.scene(), job.image().getWidth(), job.image().getHeight()));
    if (outsideDialog == null) {
      outsideDialog = new JDialog(window.frame(), Messages.text("outside.text"));
      outsideDialog.setName("outsideDialog");
      final JPanel buttons = new JPanel(new FlowLayout(FlowLayout.TRAILING));
      buttons.add(button("outside.save", this::saveOutside));
      outsideDialog.add(outside, BorderLayout.CENTER);
      outsideDialog.add(buttons, BorderLayout.SOUTH);
      outsideDialog.pack();
      outsideDialog.setLocationRelativeTo(window.frame());
      OutsideKeys.bind(outside);
    }
    outsideDialog.setVisible(true);
  }

  private void saveOutside() {
    choose("outside.save", "png", false, "outside.png").ifPresent(file -> save(outside.image(), file));
  }

  /** Shows the ray of the pinned pixel in the scene from outside, if that is open. */
  void showRay(final RenderJob job, final Inspection inspection) {
    if (outsideDialog != null && outsideDialog.isVisible()) {
      final Hit hit = inspection.winner().map(Meeting::hit).orElse(Hit.NOHIT);
      outside.setLines(Outline.of(job.scene(), job.image().getWidth(), job.image().getHeight(), inspection.pixel().ray(),
          hit));
    }
  }

  OutsideView outside() {
    return outside;
  }

  void close() {
    if (outsideDialog != null) {
      outsideDialog.dispose();
    }
    if (comparison != null) {
      comparison.dispose();
    }
  }
}
