package meshes;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import trials.Trials;

/** The parser of the JDK is the oracle. */
class DecimalParserTest {

  private final DecimalParser parser = new DecimalParser();

  private void assertAsTheJdk(final String text) {
    final byte[] bytes = (text + " ").getBytes(StandardCharsets.ISO_8859_1);
    assertEquals(Double.parseDouble(text), parser.parse(bytes, 0), text);
    assertEquals(text.length(), parser.end(), text);
  }

  @ParameterizedTest
  @ValueSource(strings = {"0", "-0", "+0.0", "1", "-1.5", ".5", "5.", "1e5", "1E-5", "1e+5", "00012.500", "16777217",
    "16777216.9999999999999",
    "16777217.0000000000000000000000001", "3.4028235e38", "3.4028236e38", "1e39", "-1e39", "1.4e-45", "0.7e-45",
    "0.70064923e-45", "1e-99",
    "1e999999999999", "1e-999999999999", "0e999999", "1.1754943e-38", "9007199254740993", "123456789012345678901234567890",
    "0.000000000000000000000000000000000000000000001", "1.00000017881393421514957253748434595763683319091796875",
    "1.00000017881393432617187499", "8.5899345920000001e9", "0000000000000000000000000000000000000000000001.5"})
  void hardCases(final String text) {
    assertAsTheJdk(text);
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "-", "+", ".", "e5", "x", "-.e1", "nan", "inf"})
  void noNumber(final String text) {
    final byte[] bytes = (text + " ").getBytes(StandardCharsets.ISO_8859_1);
    assertEquals(Double.NaN, parser.parse(bytes, 0));
    assertEquals(0, parser.end());
  }

  @Test
  void theNumberEndsWhereItEnds() {
    final byte[] bytes = "ab1.5e+x".getBytes(StandardCharsets.ISO_8859_1);
    assertEquals(1.5, parser.parse(bytes, 2));
    assertEquals(5, parser.end());
  }

  @Test
  void floatsAsTheyArePrinted() {
    Trials.of(300_000, random -> assertAsTheJdk(Float.toString(anyFloat(random))));
  }

  @Test
  void middlesBetweenFloatsAndTheirNeighbours() {
    Trials.of(30_000, random -> {
      final float x = anyFloat(random);
      final BigDecimal middle = new BigDecimal(x).add(new BigDecimal(Math.nextUp(x))).divide(BigDecimal.valueOf(2));
      assertAsTheJdk(middle.toString());
      assertAsTheJdk(middle.add(middle.ulp()).toString());
      assertAsTheJdk(middle.subtract(middle.ulp()).toString());
      assertAsTheJdk(Double.toString(middle.doubleValue()));
      assertAsTheJdk(Double.toString(Math.nextUp(middle.doubleValue())));
    });
  }

  @Test
  void digitsAtRandom() {
    Trials.of(300_000, random -> {
      final StringBuilder text = new StringBuilder(random.nextBoolean() ? "-" : "");
      digits(random, 1 + random.nextInt(random.nextInt(9) == 0 ? 40 : 9), text);
      if (random.nextBoolean()) {
        digits(random, random.nextInt(20), text.append('.'));
      }
      assertAsTheJdk(random.nextInt(3) > 0 ? text.toString() : text.append('e').append(random.nextInt(100) - 50).toString());
    });
  }

  private static void digits(final Random random, final int number, final StringBuilder text) {
    for (int i = 0; i < number; i++) {
      text.append(random.nextInt(10));
    }
  }

  private static float anyFloat(final Random random) {
    float x = Float.intBitsToFloat(random.nextInt());
    while (!Float.isFinite(x) || !Float.isFinite(Math.nextUp(x))) {
      x = Float.intBitsToFloat(random.nextInt());
    }
    return x;
  }
}
