package netbeans;

import org.junit.platform.engine.FilterResult;
import org.junit.platform.engine.TestDescriptor;
import org.junit.platform.engine.support.descriptor.MethodSource;
import org.junit.platform.launcher.PostDiscoveryFilter;

/**
 * Filters the tests of a class to those of one method, if the system properties {@code test.class} and
 * {@code test.method} name one: NetBeans' "Run Focused Test Method".
 *
 * <p>Ant can select a method too, but by name finds only methods without parameters.
 */
public final class TestMethodFilter implements PostDiscoveryFilter {

  private final String className = System.getProperty("test.class", "");
  private final String method = System.getProperty("test.method", "");

  /** For the runner of the tests, which finds this class through META-INF/services. */
  public TestMethodFilter() {
  }

  @Override
  public FilterResult apply(final TestDescriptor test) {
    final boolean wanted = method.isEmpty() || !(test.getSource().orElse(null) instanceof final MethodSource source)
        || source.getMethodName().equals(method) && source.getClassName().equals(className);
    return FilterResult.includedIf(wanted);
  }
}
