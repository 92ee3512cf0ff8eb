package window;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;

/**
 * Watches files and reports changes. It polls them, which works on every file system and also notices files that an editor
 * replaces instead of rewriting.
 */
final class SceneWatch {

  private static final long DELAY_MS = 250;

  /** By how much the times of files may be too early, as they come from a clock that ticks slowly. */
  private static final long CLOCK_TICK_MS = 10;

  /** The attributes that reveal a change. A missing file has size -1. */
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

  /** Files to be watched, and since when, in ms since 1970. */
  private record Wanted(List<Path> files, long since) {
  }

  private final Runnable listener;
  private final AtomicReference<Wanted> wanted = new AtomicReference<>();
  private final ScheduledExecutorService clock = Executors.newSingleThreadScheduledExecutor(job -> {
    final Thread thread = new Thread(job, "scene watch");
    thread.setDaemon(true);
    return thread;
  });
  /** Used by the thread of the watch alone, as each look at a file may take long. */
  private final Map<Path, State> states = new HashMap<>();
  private boolean unsettled;

  /** A watch without files. The listener is called on a thread of the watch. */
  SceneWatch(final Runnable listener) {
    this.listener = listener;
    clock.scheduleWithFixedDelay(this::poll, DELAY_MS, DELAY_MS, TimeUnit.MILLISECONDS);
  }

  /** Sets the files to be watched, without waiting for them. */
  void watch(final Collection<Path> files) {
    wanted.set(new Wanted(List.copyOf(files), System.currentTimeMillis()));
    if (!clock.isShutdown()) {
      clock.execute(this::replace);
    }
  }

  /** A file that is found to have changed since its watching was asked for counts as changed. */
  private void replace() {
    final Wanted next = wanted.getAndSet(null);
    if (next == null) {
      return;
    }
    states.keySet().retainAll(next.files);
    for (final Path file : next.files) {
      if (!states.containsKey(file)) {
        final State now = State.of(file);
        states.put(file, now);
        unsettled |= now.time.toMillis() > next.since - CLOCK_TICK_MS;
      }
    }
  }

  /** Reports a change once two successive polls agree, so that a file is not read while it is being written. */
  private void poll() {
    replace();
    if (hasSettled()) {
      listener.run();
    }
  }

  private boolean hasSettled() {
    boolean different = false;
    for (final Map.Entry<Path, State> file : states.entrySet()) {
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
