package upnatray;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.List;

import arguments.Messages;
import diagnostics.Problem;
import scenes.ReadResult;
import scenes.SceneFile;
import scenes.SceneReader;

/** The scenes of a command line, one after the other; what is wrong with one does not stop the others. */
final class Batch {

  private static final int AT_FAULT = 1;
  private static final int INTERRUPTED = 130;

  private final Options options;
  private final PrintStream out;
  private final PrintStream err;
  private final InterruptHandler interruption = new InterruptHandler();

  Batch(final Options options, final PrintStream out, final PrintStream err) {
    this.options = options;
    this.out = out;
    this.err = err;
  }

  /** Renders or checks the scenes and answers the exit status. */
  int run(final List<Path> scenes) throws UsageException {
    int status = 0;
    interruption.install();
    for (final Path scene : scenes) {
      if (!interruption.requested() && !isDone(scene)) {
        status = AT_FAULT;
      }
    }
    interruption.uninstall();
    return interruption.requested() ? INTERRUPTED : status;
  }

  private boolean isDone(final Path file) throws UsageException {
    final Path target = options.check() ? null : options.target(file);
    try {
      if (target != null) {
        PngFile.check(target);
      }
      final ReadResult reading = SceneReader.read(file);
      reading.problems().forEach(err::println);
      if (target == null) {
        return isSound(file, reading);
      }
      if (reading.scene().isPresent()) {
        render(file, reading.scene().get(), target);
        return true;
      }
    } catch (final SaveException failure) {
      err.println(failure.getMessage());
    } catch (final OutOfMemoryError full) {
      err.println(Messages.text("upnatray.memory", file, Runtime.getRuntime().maxMemory() >> 20));
    }
    return false;
  }

  /** Counts what is wrong with a scene; a picture that no array can hold is wrong as well. */
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

  private void render(final Path file, final SceneFile scene, final Path target) throws SaveException {
    final int[] size = options.size(scene.width(), scene.height());
    final RenderJob job = job(file, scene, size[0], size[1]);
    final Rendition rendition = new Rendition(job, file, target, interruption);
    if (rendition.render() && !interruption.requested()) {
      interruption.save(rendition.image(), target);
      out.println(file + " -> " + target);
      job.scale().ifPresent(scale -> out.println(scale.isDepth()
          ? Messages.text("upnatray.depthScale", (float) scale.least(), (float) scale.greatest())
          : Messages.text("upnatray.costScale", (long) scale.greatest())));
    }
  }

  /** The job of rendering a scene; told in bytes if its image cannot be held. */
  private RenderJob job(final Path file, final SceneFile scene, final int W, final int H) throws SaveException {
    final long pixels = (long) W * H;
    final long megabytes = (pixels * Integer.BYTES >> 20) + 1;
    try {
      return new RenderJob(scene, options.view(), W, H, options.threads() > 0 ? options.threads()
          : Runtime.getRuntime().availableProcessors());
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
