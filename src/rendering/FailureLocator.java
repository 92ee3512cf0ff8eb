package rendering;

import static arguments.Arguments.notNull;

import java.util.List;

import arguments.Messages;
import models.Group3D;
import models.Object3D;
import tracer.Hit;
import tracer.Ray;
import tracer.RayGenerator;

/**
 * Finds out, after a tile has failed, which object failed at which pixel, so that the author of the object reads more than
 * where the exception was thrown. The pixels are asked once more one by one, which nobody waits for.
 */
final class FailureLocator {

  private final Group3D scene;
  private final RayGenerator generator;

  FailureLocator(final Group3D scene, final RayGenerator generator) {
    this.scene = scene;
    this.generator = generator;
  }

  /** What to throw for the failure of a tile: an explanation with the failure as its cause, or else the failure itself. */
  RuntimeException explain(final RuntimeException failure, final int m, final int n, final int width, final int height) {
    final IllegalStateException explanation = explanation(failure, m, n, width, height);
    return explanation == null ? failure : explanation;
  }

  /** What to throw for a full stack: an object that calls itself for ever, or else objects within too many others. */
  IllegalStateException explain(final StackOverflowError failure, final int m, final int n, final int width,
      final int height) {
    IllegalStateException explanation = null;
    try {
      explanation = explanation(failure, m, n, width, height);
    } catch (StackOverflowError tooDeepForThisToo) {
      // The explanation below holds all the more.
    }
    return explanation == null ? new IllegalStateException(Messages.text("rendering.tooDeep"), failure) : explanation;
  }

  private IllegalStateException explanation(final Throwable failure, final int m, final int n, final int width,
      final int height) {
    for (int row = n; row < n + height; row++) {
      for (int column = m; column < m + width; column++) {
        final String fault = fault(column, row, failure);
        if (fault != null) {
          return new IllegalStateException(fault, failure);
        }
      }
    }
    return null;
  }

  /** What fails at a pixel, in words; null if nothing does. */
  private String fault(final int m, final int n, final Throwable failure) {
    final Ray ray;
    try {
      ray = generator.getRay(m, n);
    } catch (RuntimeException | StackOverflowError generatorFails) {
      return Messages.text("rendering.rayFails", generator.getClass().getName(), m, n, failure);
    }
    final String call = ray == null ? null : failing(scene, ray);
    return call == null ? null : Messages.text("rendering.objectFails", call, m, n, ray, failure);
  }

  /** The method that fails for a ray, of an object or of one within it; null if there is none. */
  private static String failing(final Object3D object, final Ray ray) {
    final List<Object3D> parts = object.parts();
    for (final Object3D part : parts) {
      final String failing = failing(part, object.rayToParts(ray));
      if (failing != null) {
        return failing;
      }
    }
    if (!parts.isEmpty() || object instanceof Group3D) {
      return null;
    }
    final String name = object.getClass().getName();
    if (fails(object::getBoundingBox)) {
      return name + ".getBoundingBox";
    }
    if (fails(() -> notNull("hit", object.intersectionWith(ray)))) {
      return name + ".intersectionWith";
    }
    final Hit hit = object.intersectionWith(ray);
    final Object3D painted = hit.getObject();
    if (painted == null) {
      return null;
    }
    if (fails(() -> notNull("color", painted.getColor()))) {
      return painted.getClass().getName() + ".getColor";
    }
    return fails(() -> notNull("color", painted.getColorAt(hit))) ? painted.getClass().getName() + ".getColorAt" : null;
  }

  private static boolean fails(final Runnable call) {
    try {
      call.run();
      return false;
    } catch (RuntimeException | StackOverflowError itFails) {
      return true;
    }
  }
}
