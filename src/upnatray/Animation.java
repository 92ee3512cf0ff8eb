package upnatray;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

import arguments.Messages;
import rendering.RenderPass;
import scenes.SceneFile;

/**
 * The pictures of a {@link Turntable}, each in a file of its own, and the animated picture of all of them. Complete pictures
 * of this very scene that already exist are not rendered again: so an interrupted animation continues, and parts that were
 * rendered separately are joined.
 */
final class Animation {

  /** Makes the jobs that render scenes. */
  @FunctionalInterface
  interface Renderer {

    /** The job of rendering a scene. */
    RenderJob job(SceneFile scene) throws SaveException, UsageException;
  }

  private final Path file;
  private final SceneFile scene;
  private final Path target;
  private final Turntable turntable;
  private final InterruptHandler interruption;

  /**
   * An animation to be rendered.
   *
   * @param file the scene file
   * @param scene what it describes
   * @param target where the animated picture goes
   * @param turntable how the camera moves
   * @param interruption may stop the rendering
   */
  Animation(final Path file, final SceneFile scene, final Path target, final Turntable turntable,
      final InterruptHandler interruption) {
    this.file = file;
    this.scene = scene;
    this.target = target;
    this.turntable = turntable;
    this.interruption = interruption;
  }

  /**
   * Renders the pictures that are missing, and writes the animated picture if all are wanted.
   *
   * @param resolution size and rays of a picture
   * @param view what the pictures show
   * @param renderer renders a picture
   * @param out where the files are named
   * @throws SaveException if a file cannot be read or written
   * @throws UsageException if the options do not fit the scene
   */
  void render(final Resolution resolution, final RenderPass view, final Renderer renderer, final PrintStream out)
      throws SaveException, UsageException {
    final FrameMark mark = mark(resolution, view);
    final List<Integer> missing = missing(mark);
    final int wanted = turntable.last() - turntable.first() + 1, there = wanted - missing.size();
    final long pixels = (long) missing.size() * resolution.W() * resolution.rows();
    try (AnimationProgress progress = new AnimationProgress(file, there, wanted, pixels, interruption)) {
      for (final int k : missing) {
        final RenderJob job = renderer.job(scene.withCamera(turntable.camera(scene.camera(), k)));
        if (!job.run(progress) || interruption.requested()) {
          return;
        }
        interruption.save(turntable.file(target, k), stream -> PngEncoder.write(job.image(), mark.of(k), stream));
        progress.pictureDone();
      }
      if (turntable.isWhole()) {
        interruption.save(target, stream -> AnimatedPng.write(files(), turntable.seconds(), stream));
      }
    }
    out.println(Messages.text("upnatray.frames", file, turntable.file(target, turntable.first()),
        turntable.file(target, turntable.last()).getFileName(), wanted, there));
    if (turntable.isWhole()) {
      out.println(file + " -> " + target);
    }
  }

  /** The files of the pictures. */
  private List<Path> files() {
    final List<Path> files = new ArrayList<>();
    for (int k = turntable.first(); k <= turntable.last(); k++) {
      files.add(turntable.file(target, k));
    }
    return files;
  }

  private List<Integer> missing(final FrameMark mark) {
    final List<Integer> missing = new ArrayList<>();
    for (int k = turntable.first(); k <= turntable.last(); k++) {
      if (turntable.again() || !mark.isOn(turntable.file(target, k), k)) {
        missing.add(k);
      }
    }
    return missing;
  }

  private FrameMark mark(final Resolution resolution, final RenderPass view) throws SaveException {
    final Set<Path> files = new HashSet<>(scene.meshes());
    files.add(file);
    try {
      return new FrameMark(files, resolution + " " + view + " " + turntable.pictures() + " " + Main.version());
    } catch (final IOException failure) {
      throw new SaveException("notSaved", target, SaveFailure.reason(failure), failure);
    }
  }
}
