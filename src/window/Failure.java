package window;

import java.util.Optional;

import inspection.ThrowSite;
import diagnostics.Problem;

/** What to tell of an exception that a rendering threw: most likely by a shape of the user's own. */
final class Failure {

  private Failure() {
  }

  /** The exception as a problem, at the place in the code that it comes from. */
  static Problem problem(final Throwable failure) {
    Throwable first = failure;
    while (first.getCause() != null) {
      first = first.getCause();
    }
    final String message = failure == first || failure.getMessage() == null ? failure.toString() : failure.getMessage();
    final Optional<StackTraceElement> origin = ThrowSite.of(first);
    return new Problem(origin.map(StackTraceElement::getFileName).orElse(""),
        origin.map(call -> Math.max(0, call.getLineNumber())).orElse(0), 0, Problem.Severity.ERROR, message);
  }
}
