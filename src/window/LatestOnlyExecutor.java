package window;

import javax.swing.Timer;

/**
 * Runs jobs in the background, one at a time. Only the latest of the waiting jobs is run: it supersedes the others. If a job
 * does not end, for example because of a user-written shape, the next one starts on a new thread after a grace period, and
 * the old thread ends with its job. Called on the event dispatch thread.
 */
final class LatestOnlyExecutor {

  /** How long a job waits for the previous one to end, in ms. */
  static final int GRACE_PERIOD_MS = 1000;

  private final String name;
  private Thread worker;
  private Runnable next;

  LatestOnlyExecutor(final String name) {
    this.name = name;
  }

  /** Runs a job as soon as the previous one has ended or been abandoned. */
  synchronized void execute(final Runnable job) {
    next = job;
    if (worker == null) {
      start();
    } else {
      final Timer timer = new Timer(GRACE_PERIOD_MS, event -> abandon(job));
      timer.setRepeats(false);
      timer.start();
    }
  }

  private synchronized void abandon(final Runnable waiting) {
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
      try {
        job.run();
      } catch (final RuntimeException | Error failure) {
        final Thread thread = Thread.currentThread();
        thread.getUncaughtExceptionHandler().uncaughtException(thread, failure);
      }
    }
  }

  /** The next job; null if none, or if the calling thread has been abandoned. */
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

  /** Discards the waiting job. */
  synchronized void stop() {
    next = null;
  }
}
