package inspection;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Where an exception comes from: who gave something wrong to a method of the JDK, of vecmath, or that checks arguments, and
 * not where in that method it was noticed.
 */
public final class ThrowSite {

  private ThrowSite() {
  }

  /**
   * The place where an exception comes from.
   *
   * @param thrown the exception
   * @return the call, with its file and line; empty if the file is not known
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
