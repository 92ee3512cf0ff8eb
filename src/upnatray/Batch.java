package upnatray;

import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

import arguments.Messages;
import diagnostics.Problem;
import rendering.RenderPass;
import scenes.ReadResult;
import scenes.SceneFile;
import scenes.SceneReader;

/**
 * Renders the scenes of a command line, one after the other. A fault in one does not stop the others; but if the picture
 * of any of them must not be written to its target, none is rendered.
 */
final class Batch {

  private static final int AT_FAULT = 1;
  private static final int REFUSED = 2;
  private static final int INTERRUPTED = 130;

  /** In place of the number of a light: all lights. */
  private static final int ALL = -1;

  private final Options options;
  private final PrintStream out;
  private final PrintStream err;
  private final InterruptHandler interruption = new InterruptHandler();

  Batch(final Options options, final PrintStream out, final PrintStream err) {
    this.options = options;
    this.out = out;
    this.err = err;
  }

  /** Renders or checks the scenes and returns the exit status. */
  int run(final List<Path> scenes) throws UsageException {
    if (!options.check() && !mayBeWritten(scenes)) {
      return REFUSED;
    }
    int status = 0;
    interruption.install();
    for (final Path scene : scenes) {
      if (!interruption.requested()) {
        status = Math.max(status, status(scene));
      }
    }
    interruption.uninstall();
    return interruption.requested() ? INTERRUPTED : status;
  }

  /** Reports each target that is refused. */
  private boolean mayBeWritten(final List<Path> scenes) throws UsageException {
    final Set<Path> targets = new LinkedHashSet<>(), ofAnimations = new HashSet<>();
    for (final Path scene : scenes) {
      targets.addAll(options.targets(scene));
      ofAnimations.addAll(options.targets(scene));
      ofAnimations.remove(options.target(scene));
    }
    final InputFiles inputs = inputs(new LinkedHashSet<>(scenes), targets);
    boolean good = true;
    for (final Path target : targets) {
      try {
        new PngTarget(target).check(inputs);
        if (ofAnimations.contains(target)) {
          checkFrame(target);
        }
      } catch (final RefusedTargetException refused) {
        err.println(refused.getMessage());
        good = false;
      } catch (final SaveException later) {
        continue;
      }
    }
    return good;
  }

  /** A picture of an animation, whose name the user did not choose, replaces only those of animations unless asked to. */
  private void checkFrame(final Path target) throws SaveException {
    if (!options.turntable().map(Turntable::again).orElse(false) && FrameMark.isForeign(target)) {
      throw new RefusedTargetException("notOfAnimation", target);
    }
  }

  /**
   * The scenes and, if there are several and a target exists, the files of their meshes: one that a later scene needs
   * must not be replaced by the picture of an earlier one. Those of a single scene are known in time, when it is read.
   */
  private static InputFiles inputs(final Set<Path> scenes, final Set<Path> targets) {
    final Set<Path> inputs = new HashSet<>(scenes);
    if (scenes.size() > 1 && targets.stream().anyMatch(Files::exists)) {
      for (final Path scene : scenes) {
        inputs.addAll(meshes(scene));
      }
    }
    return new InputFiles(inputs);
  }

  private static Set<Path> meshes(final Path scene) {
    try {
      return SceneReader.read(scene).scene().map(SceneFile::meshes).orElse(Set.of());
    } catch (final OutOfMemoryError reportedLater) {
      return Set.of();
    }
  }

  private int status(final Path file) throws UsageException {
    final Path target = options.check() ? null : options.target(file);
    try {
      if (target != null) {
        PngFile.check(target, List.of(file));
      }
      final ReadResult reading = SceneReader.read(file);
      reading.problems().forEach(err::println);
      if (target == null) {
        return isSound(file, reading) ? 0 : AT_FAULT;
      }
      if (reading.scene().isPresent()) {
        render(file, reading.scene().get(), target);
        return 0;
      }
    } catch (final RefusedTargetException refused) {
      err.println(refused.getMessage());
      return REFUSED;
    } catch (final SaveException failure) {
      err.println(failure.getMessage());
    } catch (final OutOfMemoryError full) {
      err.println(Messages.text("upnatray.memory", file, Runtime.getRuntime().maxMemory() >> 20));
    }
    return AT_FAULT;
  }

  /** Counts the problems of a scene; a picture too large for an array is one as well. */
  private boolean isSound(final Path file, final ReadResult reading) {
    long errors = reading.problems().stream().filter(Problem::isError).count();
    final long warnings = reading.problems().size() - errors;
    if (reading.scene().isPresent()) {
      final int[] size = options.size(reading.scene().get().width(), reading.scene().get().height());
      try {
        Image.height(size[0], size[1]);
      } catch (final IllegalArgumentException tooLarge) {
        err.println(Messages.text("upnatray.imageTooLarge", file, tooLarge.getMessage()));
        errors++;
      }
    }
    out.println(Messages.text("upnatray.checked", file, errors, warnings));
    return errors == 0;
  }

  /** Renders the pass asked for; for the light of a single picture, a picture of each light follows. */
  private void render(final Path file, final SceneFile scene, final Path target) throws SaveException, UsageException {
    final boolean animated = options.turntable().isPresent();
    if (options.view() == RenderPass.LIGHT && !scene.isLit()) {
      err.println(Messages.text("upnatray.noLight", file));
    }
    final int lights = options.view() == RenderPass.LIGHT && !animated ? scene.lights().getLights().size() : 0;
    final Set<Path> inputs = new HashSet<>(scene.meshes());
    inputs.add(file);
    for (final Path each : options.targets(file)) {
      PngFile.check(each, inputs);
    }
    for (int light = 0; light < lights; light++) {
      PngFile.check(target(target, light), inputs);
    }
    if (animated) {
      new Animation(file, scene, target, options.turntable().get(), interruption)
          .render(options.resolution(scene.width(), scene.height()), options.view(), moved -> job(file, moved, ALL), out);
    }
    for (int light = ALL; light < lights && !animated && !interruption.requested(); light++) {
      render(file, job(file, scene, light), target(target, light));
    }
  }

  private void render(final Path file, final RenderJob job, final Path target) throws SaveException {
    boolean completed = false;
    try (PictureProgress progress = PictureProgress.of(job.image(), file, target, interruption)) {
      completed = job.run(progress);
    }
    if (completed && !interruption.requested()) {
      save(file, job, target);
    }
  }

  private static Path target(final Path target, final int light) {
    final String name = target.getFileName().toString().replaceFirst("(?i)\\.png$", "");
    return light == ALL ? target : target.resolveSibling(name + "-light" + (light + 1) + ".png");
  }

  private void save(final Path file, final RenderJob job, final Path target) throws SaveException {
    interruption.save(target, stream -> PngEncoder.write(job.image(), null, stream));
    out.println(file + " -> " + target);
    job.scale().ifPresent(scale -> out.println(scale.isDepth()
        ? Messages.text("upnatray.depthScale", (float) scale.least(), (float) scale.greatest())
        : Messages.text("upnatray.costScale", (long) scale.greatest())));
  }

  /**
   * The job of rendering a scene; the message for an image that does not fit in memory gives its size.
   *
   * @param light number of the light whose picture it is, or ALL
   */
  private RenderJob job(final Path file, final SceneFile scene, final int light) throws SaveException, UsageException {
    final Resolution resolution = options.resolution(scene.width(), scene.height());
    final int W = resolution.W(), H = resolution.rows();
    final int threads = options.threads() > 0 ? options.threads() : Runtime.getRuntime().availableProcessors();
    final long pixels = (long) W * H;
    final long megabytes = (pixels * Integer.BYTES >> 20) + 1;
    try {
      return light == ALL ? RenderJob.of(scene, options.view(), resolution, threads)
          : RenderJob.ofLight(scene, light, resolution, threads);
    } catch (final IllegalArgumentException tooLarge) {
      throw new SaveException("imageTooLarge", file, tooLarge.getMessage(), tooLarge);
    } catch (final OutOfMemoryError full) {
      final long megabytesNow = Runtime.getRuntime().maxMemory() >> 20;
      final String reason = Messages.text("upnatray.imageMemory", W, H, megabytes, megabytesNow, megabytes + megabytes / 4
          + 256);
      throw new SaveException("imageTooLarge", file, reason, full);
    }
  }
}
