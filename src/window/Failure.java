package window;

import scenes.Problem;

/** What to tell of an exception that a rendering threw: most likely by a shape of the user's own. */
final class Failure {

  private Failure() {
  }

  /** The exception as a problem, at the place in the code where it began. */
  static Problem problem(final Throwable failure) {
    Throwable first = failure;
    while (first.getCause() != null) {
      first = first.getCause();
    }
    final StackTraceElement[] trace = first.getStackTrace();
    final boolean known = trace.length > 0 && trace[0].getFileName() != null;
    final String message = failure == first || failure.getMessage() == null ? failure.toString() : failure.getMessage();
    return new Problem(known ? trace[0].getFileName() : "", known ? Math.max(0, trace[0].getLineNumber()) : 0, 0,
        Problem.Severity.ERROR, message);
  }
}
