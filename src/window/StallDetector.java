package window;

import java.util.Optional;
import java.util.Set;

import arguments.Messages;
import lights.Light;
import materials.Material;
import models.Object3D;
import rendering.PixelLoop;
import rendering.RenderSettings;
import rendering.Supersampling;
import rendering.TileRenderer;

/** Detects that a rendering has stalled, and finds the method of the object in which it hangs. */
final class StallDetector {

  /** Seconds without a finished tile that count as a stall. */
  private static final double STALL_SECONDS = 3;

  /** Classes of which each rendering thread runs one. */
  private static final Set<String> RENDERERS = Set.of(TileRenderer.class.getName(), PixelLoop.class.getName(),
      Supersampling.class.getName(), RenderSettings.class.getName());

  private double share = -1;
  private long since;

  /** Returns a message if the completed share has not changed for a while. */
  Optional<String> check(final double completed) {
    final long now = System.nanoTime();
    if (completed != share) {
      share = completed;
      since = now;
    }
    final double seconds = 1e-9 * (now - since);
    return seconds < STALL_SECONDS ? Optional.empty()
        : Optional.of(Messages.text("window.status.stalled", (int) seconds, place().orElse("?")));
  }

  /** The innermost method of an object, a light, or a material that a rendering thread is in. */
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
      if (object != null && RENDERERS.contains(call.getClassName())) {
        return Optional.of(object);
      }
    }
    return Optional.empty();
  }

  private static boolean isObject(final String name) {
    try {
      final Class<?> type = Class.forName(name, false, Thread.currentThread().getContextClassLoader());
      return Object3D.class.isAssignableFrom(type) || Light.class.isAssignableFrom(type)
          || Material.class.isAssignableFrom(type);
    } catch (final ClassNotFoundException | LinkageError hidden) {
      return false;
    }
  }
}
