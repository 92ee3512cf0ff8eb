package netbeans;

import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.engine.TestExecutionResult.Status;
import org.junit.platform.engine.support.descriptor.ClassSource;
import org.junit.platform.engine.support.descriptor.MethodSource;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;

/**
 * Prints the results of tests: in NetBeans the lines from which it fills its window Test Results, elsewhere a line for
 * each class, the failures, and a line with the totals.
 *
 * <p>NetBeans can only read the output of the runner of JUnit 3 and 4. It accepts only Java identifiers as names of
 * tests, so the runs of a parameterised method become {@code method_1}, {@code method_2}. The system property
 * {@code test.lines}, which build.xml sets, says which lines are wanted.
 */
public final class TestResultLines implements TestExecutionListener {

  private static final String EVENT = "junit.framework.TestListener: ";

  /** Saved at once, as tests may replace it. */
  private static final PrintStream OUT = System.out;
  private static final boolean FOR_NETBEANS = "netbeans".equals(System.getProperty("test.lines"));

  /** Of all classes: Ant makes a new listener for each one, and only the end of the program is the end of all. */
  private static final Counts ALL = new Counts();

  private final List<String> troubles = new ArrayList<>();
  private TestIdentifier suite;
  private String suiteName;
  private Counts counts;
  private long start;

  static {
    if (!FOR_NETBEANS) {
      Runtime.getRuntime().addShutdownHook(new Thread(() -> OUT.println(ALL)));
    }
  }

  /** For the runner of the tests. */
  public TestResultLines() {
  }

  @Override
  public void executionStarted(final TestIdentifier id) {
    if (suite == null && id.getSource().orElse(null) instanceof final ClassSource source) {
      begin(id, source.getClassName());
    } else if (id.isTest()) {
      event("startTest(" + name(id) + ")");
    }
  }

  @Override
  public void executionSkipped(final TestIdentifier id, final String reason) {
    (suite == null ? ALL : counts).skipped++;
  }

  @Override
  public void executionFinished(final TestIdentifier id, final TestExecutionResult result) {
    if (result.getStatus() == Status.FAILED) {
      // A class or a factory of tests may fail as well, in what it does before or after its tests.
      failed(id, result.getThrowable().orElseGet(() -> new AssertionError("no reason given")));
    } else if (id.isTest() && result.getStatus() == Status.SUCCESSFUL) {
      counts.passed++;
    } else if (id.isTest()) {
      counts.skipped++;
    }
    if (id.isTest() || result.getStatus() == Status.FAILED) {
      event("endTest(" + name(id) + ")");
    }
    if (id.equals(suite)) {
      end();
    }
  }

  private void begin(final TestIdentifier id, final String className) {
    suite = id;
    suiteName = className;
    counts = new Counts();
    start = System.nanoTime();
    troubles.clear();
    if (FOR_NETBEANS) {
      OUT.println("Testsuite: " + className);
    }
  }

  private void end() {
    final double seconds = (System.nanoTime() - start) / 1e9;
    if (FOR_NETBEANS) {
      OUT.println(String.format(Locale.ROOT, "Tests run: %d, Failures: %d, Errors: %d, Time elapsed: %.3f sec",
          counts.passed + counts.failures + counts.errors, counts.failures, counts.errors, seconds));
    } else {
      OUT.println(String.format(Locale.ROOT, "%s: %s, %.1f s", suiteName, counts, seconds));
    }
    troubles.forEach(OUT::println);
    ALL.add(counts);
    suite = null;
  }

  private void failed(final TestIdentifier id, final Throwable problem) {
    final boolean failure = problem instanceof AssertionError;
    counts.failures += failure ? 1 : 0;
    counts.errors += failure ? 0 : 1;
    if (!id.isTest()) {
      event("startTest(" + name(id) + ")");
    }
    event((failure ? "addFailure(" : "addError(") + name(id) + ", " + problem.getMessage() + ")");
    troubles.add("Testcase: " + name(id) + "(" + suiteName + "):\t" + (failure ? "FAILED" : "Caused an ERROR"));
    if (FOR_NETBEANS) {
      troubles.add(String.valueOf(problem.getMessage()));
    }
    final StringWriter trace = new StringWriter();
    problem.printStackTrace(new PrintWriter(trace, true));
    troubles.add(trace.toString());
  }

  private static void event(final String text) {
    if (FOR_NETBEANS) {
      OUT.println(EVENT + text);
    }
  }

  private static String name(final TestIdentifier id) {
    final String method = id.getSource().filter(MethodSource.class::isInstance)
        .map(s -> ((MethodSource) s).getMethodName()).orElseGet(() -> id.getDisplayName().replaceAll("\\W+", "_"));
    final String last = id.getUniqueIdObject().getLastSegment().getValue();
    return last.startsWith("#") ? method + "_" + last.substring(1) : method;
  }

  /** The results of the tests of a class, or of all. */
  private static final class Counts {

    private int passed;
    private int failures;
    private int errors;
    private int skipped;

    private void add(final Counts other) {
      passed += other.passed;
      failures += other.failures;
      errors += other.errors;
      skipped += other.skipped;
    }

    @Override
    public String toString() {
      return passed + " passed, " + (failures + errors) + " failed" + (skipped == 0 ? "" : ", " + skipped + " skipped");
    }
  }
}
