package upnatray;

import java.nio.file.Path;

/**
 * Handles an interruption of the program (Ctrl-C): the rendering stops, and its finished part is saved or reported. The
 * virtual machine waits for this, however busy the other threads are.
 */
final class InterruptHandler extends Thread {

  /** Grace period for the rendering to stop by itself; then the picture is taken as it is. */
  private static final long PATIENCE_MILLISECONDS = 500;

  private volatile boolean requested;
  private Interruptible current;

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
  synchronized void rendering(final Interruptible work) {
    current = work;
  }

  /** The picture is rendered, or its rendering was stopped. */
  synchronized void rendered() {
    if (!requested) {
      current = null;
    }
    notifyAll();
  }

  /** Saves a picture; the end of the program waits for that. */
  synchronized void save(final Path target, final PngFile.Content picture) throws SaveException {
    PngFile.save(target, picture);
  }

  @Override
  public void run() {
    requested = true;
    final Interruptible stopped = stopped();
    if (stopped != null) {
      stopped.interrupted();
    }
  }

  /** The rendering in progress, once it has stopped or the grace period is over; null if there was none. */
  private synchronized Interruptible stopped() {
    final Interruptible stopped = current;
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
