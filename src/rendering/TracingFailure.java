package rendering;

import tracer.Ray;

/** A light, a material, or an object failed while a radiance was computed. {@link FailureLocator} explains it. */
final class TracingFailure extends RuntimeException {

  private static final long serialVersionUID = 1L;

  /** The method that failed; null if it is one of an object of the scene, which is not known yet. */
  private final transient String call;
  private final transient Ray ray;

  private TracingFailure(final String call, final Ray ray, final Throwable cause) {
    super(cause);
    this.call = call;
    this.ray = ray;
  }

  /** Some object of the scene failed for a ray. */
  static TracingFailure ofScene(final Ray ray, final Throwable cause) {
    return new TracingFailure(null, ray, cause);
  }

  /**
   * A light or a material failed.
   *
   * @param atFault the light or material
   * @param method the method at fault if the failure does not show another of its class
   */
  static TracingFailure of(final Object atFault, final String method, final Ray ray, final Throwable cause) {
    String failed = method;
    for (final StackTraceElement frame : cause.getStackTrace()) {
      if (frame.getClassName().equals(atFault.getClass().getName())) {
        failed = frame.getMethodName();
      }
    }
    return new TracingFailure(atFault.getClass().getName() + "." + failed, ray, cause);
  }

  String call() {
    return call;
  }

  Ray ray() {
    return ray;
  }
}
