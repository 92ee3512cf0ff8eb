package window;

import java.util.Optional;

import inspection.ThrowSite;
import diagnostics.Problem;

/** Describes an exception thrown during rendering, most likely by a user-written shape. */
final class Failure {

  private Failure() {
  }

  /** The exception as a problem, located at the source line that caused it. */
  static Problem problem(final Throwable failure) {
    Throwable first = failure;
    while (first.getCause() != null) {
      first = first.getCause();
    }
    final String message = failure == first || failure.getMessage() == null ? failure.toString() : failure.getMessage();
    final Optional<StackTraceElement> site = ThrowSite.of(first);
    return new Problem(site.map(StackTraceElement::getFileName).orElse(""),
        site.map(call -> Math.max(0, call.getLineNumber())).orElse(0), 0, Problem.Severity.ERROR, message);
  }
}
