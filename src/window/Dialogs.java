package window;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;

import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.SwingUtilities;
import javax.swing.filechooser.FileNameExtensionFilter;

import arguments.Messages;
import rendering.RenderPass;
import upnatray.PngFile;
import upnatray.RenderJob;
import upnatray.SaveException;

/** The dialogs of the window: file choosers, the comparison with a reference, the lights and the wireframe view. */
final class Dialogs {

  private final RenderWindow window;
  private final WireframeDialog wireframe;
  private final LatestOnlyExecutor reading = new LatestOnlyExecutor("reference");
  private final LatestOnlyExecutor listing = new LatestOnlyExecutor("list of lights");
  private Comparison comparison;
  private LightsDialog lights;

  Dialogs(final RenderWindow window) {
    this.window = window;
    this.wireframe = new WireframeDialog(window);
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
    final String name = scene == null ? "picture"
        : Objects.toString(scene.getFileName(), "").replaceFirst("(?i)\\.xml$", "");
    return name + ".png";
  }

  /**
   * Saves a picture to the chosen file, on a thread of its own, which also completes if the window is closed meanwhile. A
   * file that is not a PNG or is an input of the scene is refused; the user confirms before another existing file is
   * replaced.
   */
  void saveAs(final BufferedImage picture, final Path file) {
    final Path target = PictureFile.withExtension(file);
    final List<Path> inputs = window.session().inputs();
    window.settings().setFolder(target.toAbsolutePath().getParent());
    new Thread(() -> save(picture, target, inputs), "saving").start();
  }

  private void save(final BufferedImage picture, final Path target, final List<Path> inputs) {
    try {
      PngFile.check(target, inputs);
      if (!Files.exists(target) || confirmsReplacing(target)) {
        showStatus(Messages.text("window.status.saving", target));
        PngFile.save(picture, target);
        showStatus(Messages.text("window.status.saved", target));
      }
    } catch (final SaveException failure) {
      showStatus(" ");
      SwingUtilities.invokeLater(() -> showError(failure.getMessage()));
    }
  }

  /** Asks the user, on the event dispatch thread, and waits for the reply. */
  private boolean confirmsReplacing(final Path target) {
    final FutureTask<Boolean> question = new FutureTask<>(() -> JOptionPane.showConfirmDialog(window.frame(),
        Messages.text("window.save.replace", target), "UPNaTRay", JOptionPane.YES_NO_OPTION,
        JOptionPane.WARNING_MESSAGE) == JOptionPane.YES_OPTION);
    SwingUtilities.invokeLater(question);
    try {
      return question.get();
    } catch (final InterruptedException | ExecutionException notAsked) {
      return false;
    }
  }

  private void showStatus(final String text) {
    SwingUtilities.invokeLater(() -> window.status().showText(text));
  }

  void showError(final String message) {
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

  /** Compares the picture, and each picture rendered from now on, with a reference file. */
  void compareWith(final Path file) {
    reading.execute(() -> {
      try {
        final BufferedImage reference = PictureFile.read(file);
        SwingUtilities.invokeLater(() -> {
          endComparison();
          comparison = new Comparison(window, reference, file);
        });
      } catch (final IOException failure) {
        final String reason = failure.getMessage() == null ? failure.toString() : failure.getMessage();
        SwingUtilities.invokeLater(() -> showError(Messages.text("window.compare.failed", file, reason)));
      }
    });
  }

  /** Repeats an open comparison after a rendering. */
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

  /** Opens the list of lights, once these have been asked where they are, if the picture that is shown is a lit one. */
  void showLights(final RenderJob job) {
    closeLights();
    if (!job.scene().isLit() || job.view() != RenderPass.COLOUR) {
      window.status().showText(Messages.text("window.lights.notLit"));
      return;
    }
    listing.execute(() -> {
      final List<String> names = LightsDialog.names(job.scene());
      SwingUtilities.invokeLater(() -> {
        if (window.shows(job)) {
          closeLights();
          lights = new LightsDialog(window, job, names);
        }
      });
    });
  }

  /** Closes the list of lights: another picture is shown. */
  void closeLights() {
    if (lights != null) {
      lights.close();
      lights = null;
    }
  }

  void chooseDrawing(final WireframeView drawing) {
    choose("wireframe.save", "png", false, "wireframe.png").ifPresent(file -> saveAs(drawing.image(), file));
  }

  WireframeDialog wireframeDialog() {
    return wireframe;
  }

  WireframeView wireframe() {
    return wireframe.view();
  }

  void close() {
    wireframe.close();
    endComparison();
    closeLights();
  }
}
