package window;

import java.util.Optional;

import arguments.Messages;
import models.Object3D;

import rendering.TileRenderer;

/** Notices that a rendering does not get on, and finds out which object keeps it so long. */
final class StallDetector {

  /** For how long no tile may be finished without anybody wondering. */
  private static final double SECONDS = 3;

  private double share = -1;
  private long since;

  /** What to tell if no tile has been finished for long; how much is done tells whether one was. */
  Optional<String> look(final double done) {
    final long now = System.nanoTime();
    if (done != share) {
      share = done;
      since = now;
    }
    final double seconds = 1e-9 * (now - since);
    return seconds < SECONDS ? Optional.empty()
        : Optional.of(Messages.text("window.status.standstill", (int) seconds, place().orElse("?")));
  }

  /** Where the threads that render are: in which method of which object. */
  private static Optional<String> place() {
    for (final StackTraceElement[] trace : Thread.getAllStackTraces().values()) {
      final Optional<String> place = place(trace);
      if (place.isPresent()) {
        return place;
      }
    }
    return Optional.empty();
  }

  private static Optional<String> place(final StackTraceElement[] trace) {
    String object = null;
    for (final StackTraceElement call : trace) {
      if (object == null && isObject(call.getClassName())) {
        object = String.format("%s.%s (%s:%d)", call.getClassName(), call.getMethodName(), call.getFileName(),
            call.getLineNumber());
      }
      if (object != null && call.getClassName().equals(TileRenderer.class.getName())) {
        return Optional.of(object);
      }
    }
    return Optional.empty();
  }

  private static boolean isObject(final String name) {
    try {
      return Object3D.class.isAssignableFrom(Class.forName(name, false, Thread.currentThread().getContextClassLoader()));
    } catch (final ClassNotFoundException | LinkageError hidden) {
      return false;
    }
  }
}
