package window;

import java.awt.BorderLayout;
import java.awt.FlowLayout;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;

import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.filechooser.FileNameExtensionFilter;

import arguments.Messages;
import inspection.Inspection;
import inspection.Intersection;
import inspection.Wireframe;
import tracer.Hit;
import upnatray.PngFile;
import upnatray.RenderJob;
import upnatray.SaveException;

/** What opens beside the window: choosers of files, the comparison with a reference, the scene from outside. */
final class Dialogs {

  private final RenderWindow window;
  private final WireframeView outside = new WireframeView();
  private JDialog outsideDialog;
  private Comparison comparison;

  Dialogs(final RenderWindow window) {
    this.window = window;
  }

  void chooseScene() {
    choose("open", "xml", true, null).ifPresent(window::open);
  }

  void choosePicture() {
    if (window.view().hasPicture()) {
      choose("save", "png", false, pictureName()).ifPresent(file -> saveAs(window.view().picture(), file));
    }
  }

  private String pictureName() {
    final Path scene = window.session().file();
    final String name = scene == null ? "picture" : Objects.toString(scene.getFileName(), "").replaceFirst("\\.xml$", "");
    return name + ".png";
  }

  /** Saves a picture in a file that was chosen; one that is there already is replaced only if that is meant. */
  void saveAs(final BufferedImage picture, final Path file) {
    final Path target = PictureFile.withEnding(file);
    if (!Files.isRegularFile(target) || JOptionPane.showConfirmDialog(window.frame(), Messages.text("window.save.replace",
        target),
        "UPNaTRay", JOptionPane.YES_NO_OPTION, JOptionPane.WARNING_MESSAGE) == JOptionPane.YES_OPTION) {
      save(picture, target);
    }
  }

  private void save(final BufferedImage picture, final Path target) {
    try {
      PngFile.save(picture, target);
      window.settings().setFolder(target.toAbsolutePath().getParent());
      window.status().showText(Messages.text("window.status.saved", target));
    } catch (final SaveException failure) {
      complain(failure.getMessage());
    }
  }

  private void complain(final String message) {
    JOptionPane.showMessageDialog(window.frame(), message, "UPNaTRay", JOptionPane.ERROR_MESSAGE);
  }

  private Optional<Path> choose(final String key, final String ending, final boolean toOpen, final String name) {
    final JFileChooser chooser = new JFileChooser(window.settings().folder().toFile());
    chooser.setDialogTitle(Messages.text("window." + key + ".tip"));
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
      final BufferedImage reference = PictureFile.read(file);
      endComparison();
      comparison = new Comparison(window, reference, file);
    } catch (final IOException failure) {
      final String reason = failure.getMessage() == null ? failure.toString() : failure.getMessage();
      complain(Messages.text("window.compare.failed", file, reason));
    }
  }

  /** A picture is finished: what is compared is compared anew. */
  void renderingFinished() {
    if (comparison != null && comparison.isOpen()) {
      comparison.compare();
    }
  }

  private void endComparison() {
    if (comparison != null) {
      comparison.end();
    }
  }

  /** Opens the scene from outside. */
  void showOutside(final RenderJob job) {
    outside.setLines(Wireframe.of(job.scene(), job.image().getWidth(), job.image().getHeight()));
    if (outsideDialog == null) {
      outsideDialog = new JDialog(window.frame(), Messages.text("window.outside.text"));
      outsideDialog.setName("outsideDialog");
      final JPanel buttons = new JPanel(new FlowLayout(FlowLayout.TRAILING));
      buttons.add(new JButton(Command.of("outside.save", "", this::saveOutside))).setName("outside.save");
      outsideDialog.add(outside, BorderLayout.CENTER);
      outsideDialog.add(buttons, BorderLayout.SOUTH);
      outsideDialog.pack();
      outsideDialog.setLocationRelativeTo(window.frame());
      WireframeKeys.bind(outside, outsideDialog::dispose);
    }
    outsideDialog.setVisible(true);
  }

  private void saveOutside() {
    choose("outside.save", "png", false, "outside.png").ifPresent(file -> saveAs(outside.image(), file));
  }

  /** Shows the ray of the pinned pixel in the scene from outside, if that is open. */
  void showRay(final RenderJob job, final Inspection inspection) {
    if (outsideDialog != null && outsideDialog.isVisible()) {
      final Hit hit = inspection.winner().map(Intersection::hit).orElse(Hit.NOHIT);
      outside.setLines(Wireframe.of(job.scene(), job.image().getWidth(), job.image().getHeight(), inspection.pixel().ray(),
          hit));
    }
  }

  WireframeView outside() {
    return outside;
  }

  void close() {
    if (outsideDialog != null) {
      outsideDialog.dispose();
    }
    endComparison();
  }
}
