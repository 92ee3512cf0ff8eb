package rendering;

import static arguments.Arguments.notNull;
import static arguments.Arguments.wrongState;

import java.util.List;

import arguments.Messages;
import models.Group3D;
import models.Object3D;
import tracer.Hit;
import tracer.Ray;
import tracer.RayGenerator;

/**
 * Finds out, after a tile has failed, which object, light, or material failed at which pixel, so that its author learns
 * more than where the exception was thrown. The pixels are computed once more, one by one.
 */
final class FailureLocator {

  private final Group3D scene;
  private final RayGenerator generator;
  private final PixelWriter picture;

  FailureLocator(final Group3D scene, final RayGenerator generator, final PixelWriter picture) {
    this.scene = scene;
    this.generator = generator;
    this.picture = picture;
  }

  /**
   * The exception to throw for the failure of a tile: an explanation with the failure as its cause, or else the failure
   * itself. A stack overflow is caused by an object that calls itself endlessly, or by objects nested too deeply.
   */
  RuntimeException explain(final Throwable failure, final int m, final int n, final int width, final int height) {
    final Throwable cause = failure instanceof TracingFailure ? failure.getCause() : failure;
    IllegalStateException explanation = null;
    try {
      explanation = explanation(cause, m, n, width, height);
    } catch (StackOverflowError tooDeepForThisToo) {
      // The explanation below applies even more.
    }
    if (explanation != null) {
      return explanation;
    }
    return cause instanceof RuntimeException ? (RuntimeException) cause
        : new IllegalStateException(Messages.text("rendering.tooDeep"), cause);
  }

  private IllegalStateException explanation(final Throwable cause, final int m, final int n, final int width,
      final int height) {
    for (int row = n; row < n + height; row++) {
      for (int column = m; column < m + width; column++) {
        final String fault = fault(column, row, cause);
        if (fault != null) {
          return new IllegalStateException(fault, cause);
        }
      }
    }
    return null;
  }

  /** The failure at a pixel, in words; null if none. */
  private String fault(final int column, final int row, final Throwable cause) {
    final int m = GeneratorWindow.column(generator, column), n = GeneratorWindow.row(generator, row);
    final String origin = GeneratorWindow.origin(generator).getClass().getName();
    final Ray ray;
    try {
      ray = generator.getRay(column, row);
    } catch (RuntimeException | StackOverflowError generatorFails) {
      return Messages.text("rendering.rayFails", origin, m, n, cause);
    }
    if (ray == null) {
      return wrongState("nullRay", origin, m, n).getMessage();
    }
    final String call = failing(scene, ray);
    final int pixel = (generator.getHeight() - 1 - row) * generator.getWidth() + column;
    return call == null ? faultOfShading(ray, pixel, m, n, cause)
        : Messages.text("rendering.objectFails", call, m, n, ray, cause);
  }

  private String faultOfShading(final Ray ray, final int pixel, final int m, final int n, final Throwable cause) {
    try {
      final Hit hit = scene.intersectionWith(ray);
      if (hit.hits()) {
        picture.hit(pixel, ray, hit);
      }
      return null;
    } catch (TracingFailure failure) {
      final String call = failure.call() == null ? failing(scene, failure.ray()) : failure.call();
      return call == null ? Messages.text("rendering.shadingFails", picture.toString(), m, n, cause)
          : Messages.text("rendering.objectFails", call, m, n, failure.ray(), failure.getCause());
    } catch (RuntimeException | StackOverflowError failure) {
      return cause instanceof StackOverflowError ? null
          : Messages.text("rendering.shadingFails", picture.toString(), m, n, cause);
    }
  }

  /** The method that fails for a ray, of an object or of one within it; null if none. */
  private static String failing(final Object3D object, final Ray ray) {
    final List<Object3D> parts = object.parts();
    for (final Object3D part : parts) {
      final String failing = failing(part, object.rayToParts(ray));
      if (failing != null) {
        return failing;
      }
    }
    if (!parts.isEmpty()) {
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
