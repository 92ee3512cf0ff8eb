package window;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.UnaryOperator;

import javax.swing.SwingUtilities;
import javax.swing.Timer;

import arguments.Messages;
import inspection.Numbers;
import rendering.Progress;
import scenes.CameraText;
import scenes.SceneFile;
import upnatray.RenderJob;
import view.Camera;

/**
 * Moves the camera. While it moves, a coarse picture follows, with as many pixels as keep the rate of pictures; when it
 * rests, the picture is rendered. Called on the event dispatch thread.
 */
final class CameraControl {

  private static final int REST_MS = 250;
  private static final double RADIANS_PER_UNIT = Math.toRadians(0.4);

  private final RenderWindow window;
  private final LatestOnlyExecutor previews = new LatestOnlyExecutor("preview");
  private final LatestOnlyExecutor writing = new LatestOnlyExecutor("camera");
  private final Timer rest = new Timer(REST_MS, event -> render());
  private final Deque<CameraText> undo = new ArrayDeque<>();
  private Path undoFile;
  private CameraPose pose;
  private final PreviewSize size = new PreviewSize();
  private BufferedImage preview;

  CameraControl(final RenderWindow window) {
    this.window = window;
    rest.setRepeats(false);
  }

  /** Turns about the point looked at, by a movement of the mouse. */
  void turn(final double dx, final double dy) {
    change(current -> current.turned(-RADIANS_PER_UNIT * dx, RADIANS_PER_UNIT * dy));
  }

  /** Moves so that the point looked at follows the mouse, in parts of the height of the picture. */
  void move(final double dx, final double dy) {
    change(current -> current.moved(-dx, dy));
  }

  void nearer(final double factor) {
    change(current -> current.atDistance(1 / factor));
  }

  void widen(final double factor) {
    change(current -> current.widened(factor));
  }

  void setProjection(final CameraPose.Optics kind) {
    final RenderJob job = window.job();
    if (job != null) {
      change(current -> current.withProjection(kind, job.scene().width() / (double) job.scene().height()));
    }
  }

  private void change(final UnaryOperator<CameraPose> step) {
    final RenderJob job = window.job();
    if (job == null) {
      return;
    }
    if (pose == null) {
      pose = CameraPose.of(job.scene().camera());
    }
    try {
      final CameraPose next = step.apply(pose);
      final Camera camera = next.camera();
      pose = next;
      window.status().showText(text(camera));
      showPreview(job.scene().withCamera(camera), job);
      rest.restart();
    } catch (final IllegalArgumentException outOfRange) {
      window.status().showText(outOfRange.getMessage());
    }
  }

  private static String text(final Camera camera) {
    return "V = " + Numbers.text(camera.getPosition()) + "   C = " + Numbers.text(camera.getLookAt()) + "   up = "
        + Numbers.text(camera.getUp());
  }

  private void showPreview(final SceneFile scene, final RenderJob job) {
    final int W = job.image().getWidth(), H = job.image().getHeight();
    window.session().cancel();
    previews.execute(() -> {
      final double k = Math.min(1, Math.sqrt(size.pixels() / ((double) W * H)));
      final int w = (int) Math.max(1, Math.round(k * W)), h = (int) Math.max(1, Math.round(k * H));
      final RenderJob coarse = new RenderJob(scene, job.view(), w, h, Runtime.getRuntime().availableProcessors());
      try {
        coarse.run(Progress.NONE);
        size.add(w * (double) h, coarse.seconds());
        SwingUtilities.invokeLater(() -> setPreview(coarse.image()));
      } catch (final RuntimeException | StackOverflowError failure) {
        System.getLogger("upnatray").log(System.Logger.Level.DEBUG, failure);
      }
    });
  }

  private void setPreview(final BufferedImage image) {
    if (pose != null) {
      preview = image;
      window.view().setPreview(image);
      window.view().setRays(RayOverlay.NONE);
    }
  }

  /** Renders the picture of the camera as it is now. */
  private void render() {
    if (pose != null) {
      window.session().setCamera(pose.camera(), preview);
    }
  }

  /** Goes back to the camera of the scene. */
  void home() {
    reset();
    window.session().setCamera(null, null);
  }

  /** Forgets the moved camera: another one is shown. */
  void reset() {
    rest.stop();
    pose = null;
    preview = null;
    window.view().setPreview(null);
  }

  private Camera camera() {
    return pose == null ? window.job().scene().camera() : pose.camera();
  }

  void copyXml() {
    if (window.job() != null) {
      copy(CameraText.of(camera()).toXml());
    }
  }

  void copyJava() {
    if (window.job() != null) {
      final Camera camera = camera();
      copy("new Camera(new Point3D" + java(camera.getPosition()) + ", new Point3D" + java(camera.getLookAt())
          + ", new Vector3D" + java(camera.getUp()) + ")");
    }
  }

  private static String java(final javax.vecmath.Tuple3f tuple) {
    return "(" + Numbers.text(tuple.x) + "f, " + Numbers.text(tuple.y) + "f, " + Numbers.text(tuple.z) + "f)";
  }

  private void copy(final String text) {
    ClipboardCopy.put(text);
    window.status().showText(Messages.text("window.camera.copied", text));
  }

  /** Writes the camera into the scene file. */
  void write() {
    final Path file = window.session().file();
    if (file != null && window.job() != null) {
      if (!file.equals(undoFile)) {
        undo.clear();
        undoFile = file;
      }
      write(file, CameraText.of(camera()), true);
    }
  }

  /** Restores the camera that the last writing replaced. */
  void undo() {
    if (!undo.isEmpty() && undoFile.equals(window.session().file())) {
      write(undoFile, undo.pop(), false);
    }
  }

  private void write(final Path file, final CameraText text, final boolean canBeUndone) {
    writing.execute(() -> {
      try {
        final CameraText before = text.writeTo(file);
        SwingUtilities.invokeLater(() -> {
          if (canBeUndone) {
            undo.push(before);
          }
          window.status().showText(Messages.text(canBeUndone ? "window.camera.written" : "window.camera.restored", file));
        });
      } catch (final IOException failure) {
        SwingUtilities.invokeLater(() -> window.dialogs().showError(
            Messages.text("window.camera.notWritten", file, String.valueOf(failure.getMessage()))));
      }
    });
  }

  void stop() {
    rest.stop();
    previews.stop();
  }
}
