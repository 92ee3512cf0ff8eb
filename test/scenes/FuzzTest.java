package scenes;

import static org.junit.jupiter.api.Assertions.assertNull;

import java.io.IOException;
import java.nio.file.Path;

import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** A little of what {@link Fuzz} does, with the same files in every run. */
class FuzzTest {

  private static final int FILES = 1000;

  @ParameterizedTest
  @EnumSource
  void whateverIsInAFileTheReaderAnswers(final Mutations.Kind kind, @TempDir final Path folder)
      throws IOException, InterruptedException {
    try (Fuzz fuzz = new Fuzz(folder)) {
      for (int seed = 0; seed < FILES; seed++) {
        assertNull(fuzz.finding(kind, seed), "seed " + seed);
      }
    }
  }
}
