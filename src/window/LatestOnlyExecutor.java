package window;

import javax.swing.Timer;

/**
 * Does jobs in the background, one at a time. Of those that wait only the last is done, as nobody wants the others any more.
 * A job that does not come to an end, in a shape of the user's own for example, is left behind when another has waited for a
 * while, and goes on alone. Called by the event thread.
 */
final class LatestOnlyExecutor {

  /** How long a job waits for the one before to end. */
  static final int PATIENCE = 1000;

  private final String name;
  private Thread worker;
  private Runnable next;

  LatestOnlyExecutor(final String name) {
    this.name = name;
  }

  /** Does a job as soon as the one before has ended or is left behind. */
  synchronized void execute(final Runnable job) {
    next = job;
    if (worker == null) {
      start();
    } else {
      final Timer patience = new Timer(PATIENCE, event -> leaveBehind(job));
      patience.setRepeats(false);
      patience.start();
    }
  }

  private synchronized void leaveBehind(final Runnable waiting) {
    if (next == waiting) {
      start();
    }
  }

  private void start() {
    worker = new Thread(this::work, name);
    worker.setDaemon(true);
    worker.start();
  }

  private void work() {
    for (Runnable job = take(); job != null; job = take()) {
      job.run();
    }
  }

  /** The next job; null if there is none, or if the calling thread has been left behind. */
  private synchronized Runnable take() {
    if (Thread.currentThread() != worker) {
      return null;
    }
    final Runnable job = next;
    next = null;
    if (job == null) {
      worker = null;
    }
    return job;
  }

  /** Begins nothing more. */
  synchronized void stop() {
    next = null;
  }
}
