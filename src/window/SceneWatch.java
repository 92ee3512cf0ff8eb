package window;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/**
 * Watches files, and tells when one has changed. It looks at them again and again: that finds files that editors replace
 * instead of writing them, and works on every file system.
 */
final class SceneWatch {

  private static final long MILLISECONDS_BETWEEN = 250;

  /** What a file looks like from outside. A file that is not there has size -1. */
  private record State(FileTime time, long size) {

    static State of(final Path file) {
      try {
        final BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
        return new State(attributes.lastModifiedTime(), attributes.size());
      } catch (final IOException missing) {
        return new State(FileTime.fromMillis(0), -1);
      }
    }
  }

  private final Runnable changed;
  private final ScheduledExecutorService clock = Executors.newSingleThreadScheduledExecutor(job -> {
    final Thread thread = new Thread(job, "scene watch");
    thread.setDaemon(true);
    return thread;
  });
  private final Map<Path, State> states = new HashMap<>();
  private boolean unsettled;

  /** A watch of no files yet. Whoever is told is called by a thread of the watch. */
  SceneWatch(final Runnable changed) {
    this.changed = changed;
    clock.scheduleWithFixedDelay(this::look, MILLISECONDS_BETWEEN, MILLISECONDS_BETWEEN, TimeUnit.MILLISECONDS);
  }

  /** Watches these files from now on, and no others. */
  synchronized void watch(final Collection<Path> files) {
    states.keySet().retainAll(files);
    for (final Path file : files) {
      states.computeIfAbsent(file, State::of);
    }
  }

  /** Tells of a change once two looks in a row found the same: a file is not read while it is being written. */
  private void look() {
    if (look(states)) {
      changed.run();
    }
  }

  private synchronized boolean look(final Map<Path, State> known) {
    boolean different = false;
    for (final Map.Entry<Path, State> file : known.entrySet()) {
      final State now = State.of(file.getKey());
      different |= !now.equals(file.setValue(now));
    }
    final boolean settled = unsettled && !different;
    unsettled = different || unsettled && !settled;
    return settled;
  }

  void stop() {
    clock.shutdownNow();
  }
}
