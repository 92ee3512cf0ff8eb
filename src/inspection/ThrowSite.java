package inspection;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Finds the call that caused an exception: the innermost one outside the JDK, vecmath and the checks of arguments, which
 * merely detect the mistake of their caller.
 */
public final class ThrowSite {

  private ThrowSite() {
  }

  /**
   * The call that caused an exception.
   *
   * @param thrown the exception
   * @return the call with its source file and line; empty if the file is unknown
   */
  public static Optional<StackTraceElement> of(final Throwable thrown) {
    final StackTraceElement[] trace = thrown.getStackTrace();
    return Arrays.stream(trace).filter(call -> !isChecking(call.getClassName())).findFirst()
        .or(() -> Arrays.stream(trace).findFirst()).filter(call -> call.getFileName() != null);
  }

  private static boolean isChecking(final String name) {
    return Stream.of("java.", "javax.", "jdk.", "sun.", "arguments.").anyMatch(name::startsWith);
  }
}
