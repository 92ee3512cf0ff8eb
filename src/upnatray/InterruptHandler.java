package upnatray;

import java.nio.file.Path;

import arguments.Messages;

/**
 * Handles an interruption of the program (Ctrl-C): the rendering stops, and the finished part of its picture is saved
 * under another name. The virtual machine waits for this, however busy the other threads are.
 */
final class InterruptHandler extends Thread {

  /** Grace period for the rendering to stop by itself; then the picture is taken as it is. */
  private static final long PATIENCE_MILLISECONDS = 500;

  private volatile boolean requested;
  private PictureProgress current;

  InterruptHandler() {
    super("interruption");
  }

  void install() {
    Runtime.getRuntime().addShutdownHook(this);
  }

  /** Unregisters the handler; of no effect if the program is ending already. */
  void uninstall() {
    try {
      Runtime.getRuntime().removeShutdownHook(this);
    } catch (final IllegalStateException ending) {
      requested = true;
    }
  }

  boolean requested() {
    return requested;
  }

  /** A picture is being rendered from now on. */
  synchronized void rendering(final PictureProgress progress) {
    current = progress;
  }

  /** The picture is rendered, or its rendering was stopped. */
  synchronized void rendered() {
    if (!requested) {
      current = null;
    }
    notifyAll();
  }

  /** Saves a picture; the end of the program waits for that. */
  synchronized void save(final Image image, final Path target) throws SaveException {
    PngFile.save(image, target);
  }

  @Override
  public void run() {
    requested = true;
    final PictureProgress stopped = stopped();
    if (stopped != null) {
      final Path target = stopped.target();
      final String file = target.getFileName().toString();
      final String name = file.endsWith(".png") ? file.substring(0, file.length() - 4) : file;
      final Path partial = target.resolveSibling(name + ".partial.png");
      try {
        PngFile.save(stopped.partial(), partial);
        System.err.println(Messages.text("upnatray.partial", partial));
      } catch (final SaveException failure) {
        System.err.println(failure.getMessage());
      } catch (final OutOfMemoryError full) {
        System.err.println(Messages.text("upnatray.noPartial", partial));
      }
    }
  }

  /** The rendering in progress, once it has stopped or the grace period is over; null if there was none. */
  private synchronized PictureProgress stopped() {
    final PictureProgress stopped = current;
    if (stopped != null) {
      try {
        wait(PATIENCE_MILLISECONDS);
      } catch (final InterruptedException impatient) {
        interrupt();
      }
    }
    return stopped;
  }
}
