package rendering;

import java.util.concurrent.ThreadFactory;

/** Threads that share one task. */
final class Workers {

  private Workers() {
  }

  /**
   * Runs a task on the calling thread and on others, and returns when all have returned. There are fewer threads if the
   * system does not allow so many.
   *
   * @param threads number of threads, the calling one included
   * @param factory makes the others
   * @param work the task of each, which takes its parts itself
   */
  static void run(final int threads, final ThreadFactory factory, final Runnable work) {
    final Thread[] helpers = new Thread[threads - 1];
    final int started = start(helpers, factory, work);
    work.run();
    boolean interrupted = false;
    for (int i = 0; i < started; i++) {
      interrupted |= await(helpers[i]);
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  private static int start(final Thread[] threads, final ThreadFactory factory, final Runnable work) {
    int started = 0;
    try {
      for (; started < threads.length; started++) {
        threads[started] = factory.newThread(work);
        threads[started].setDaemon(true);
        threads[started].start();
      }
    } catch (OutOfMemoryError noMoreThreads) {
      // The threads that have started share the task with the calling thread.
    }
    return started;
  }

  /** Waits for a helper to end, which is soon, as no work is left; returns whether this thread was interrupted meanwhile. */
  private static boolean await(final Thread helper) {
    boolean interrupted = false;
    while (true) {
      try {
        helper.join();
        return interrupted;
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
  }

  /** Throws what a thread failed with; null is nothing. */
  static void rethrow(final Throwable failure) {
    if (failure instanceof Error) {
      throw (Error) failure;
    }
    if (failure != null) {
      throw (RuntimeException) failure;
    }
  }
}
