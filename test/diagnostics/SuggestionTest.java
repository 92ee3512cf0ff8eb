package diagnostics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SuggestionTest {

  private static final List<String> KNOWN = List.of("radius", "Axislength", "circunferenceRadius", "W", "H", "lookAt", "a");

  @ParameterizedTest
  @CsvSource({"axisLength, Axislength", "Radius, radius", "raduis, radius", "radios, radius", "radiuses, "
      + "radius", "lookat, lookAt", "loockAt, lookAt",
    "circumferenceRadius, circunferenceRadius", "w, W", "color, ", "x, ", "radial, radius", "rdiu, ", "'', "})
  void namesTheNearestOfTheKnown(final String found, final String expected) {
    assertEquals(expected, Suggestion.of(found, KNOWN));
  }

  @ParameterizedTest
  @CsvSource({"'', '', 0", "abc, abc, 0", "abc, '', 3", "abc, abd, 1", "abc, acb, 1", "abc, bc, 1", "abc, xabc, "
      + "1", "kitten, sitting, 3", "ca, abc, 3"})
  void distancesCountEdits(final String a, final String b, final int distance) {
    assertEquals(distance, Suggestion.distance(a, b));
    assertEquals(distance, Suggestion.distance(b, a));
  }

  @Test
  void longNamesAreNotComparedAtAll() {
    assertEquals("", Suggestion.question("r".repeat(1_000_000), KNOWN));
  }
}
