package trials;

import java.util.Random;

import org.junit.jupiter.api.function.ThrowingConsumer;

/**
 * Repeats a test with random numbers, the same in every run. A trial that fails reports its seed; with the system
 * property {@code test.seed} set to it (ant -Dtest.jvmargs="-ea -Dtest.seed=17" test-single ...) it comes first. The
 * property {@code test.trials} multiplies the number of trials.
 */
public final class Trials {

  private static final long SEED = Long.getLong("test.seed", 0);
  private static final int FACTOR = Integer.getInteger("test.trials", 1);

  private Trials() {
  }

  /** Runs a test with a number of different random generators. */
  public static void of(final int number, final ThrowingConsumer<Random> test) {
    for (long seed = SEED; seed < SEED + (long) number * FACTOR; seed++) {
      try {
        test.accept(random(seed));
      } catch (Throwable failure) {
        throw new AssertionError("with -Dtest.seed=" + seed + ": " + failure, failure);
      }
    }
  }

  /** Generators of neighbouring seeds begin alike, unless the first numbers are skipped. */
  private static Random random(final long seed) {
    final Random random = new Random(seed * 0x9E3779B97F4A7C15L);
    random.nextLong();
    return random;
  }
}
