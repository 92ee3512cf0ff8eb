package arguments;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Locale;
import java.util.MissingResourceException;
import java.util.ResourceBundle;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import javax.vecmath.Vector3f;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

import primitives.Point3D;

class ArgumentsTest {

  private final Locale before = Locale.getDefault();

  @AfterEach
  void restoreTheLocale() {
    Locale.setDefault(before);
  }

  private static String message(final org.junit.jupiter.api.function.Executable call) {
    return assertThrows(IllegalArgumentException.class, call).getMessage();
  }

  @Test
  void rightArgumentsAreAnswered() {
    final Point3D P = new Point3D(1, 2, 3);
    final Vector3f v = new Vector3f(0, -0f, Float.MIN_VALUE);
    assertSame(P, Arguments.notNull("P", P));
    assertSame(P, Arguments.finite("P", P));
    assertSame(v, Arguments.direction("v", v));
    assertEquals(-2.5f, Arguments.finite("x", -2.5f));
    assertEquals(Float.MIN_VALUE, Arguments.positive("x", Float.MIN_VALUE));
    assertEquals(Float.MAX_VALUE, Arguments.positive("x", Float.MAX_VALUE));
    assertEquals(1, Arguments.positive("n", 1));
    assertEquals(Math.nextUp(0f), Arguments.between("x", 0, 180, Math.nextUp(0f)));
    assertEquals(Math.nextDown(180f), Arguments.between("x", 0, 180, Math.nextDown(180f)));
    assertEquals(0f, Arguments.within("x", 0f, 90f, 0f));
    assertEquals(90f, Arguments.within("x", 0f, 90f, 90f));
    assertEquals(-20.0, Arguments.within("x", -20.0, 20.0, -20.0));
    assertEquals(20.0, Arguments.within("x", -20.0, 20.0, 20.0));
    assertEquals(0f, Arguments.notNegative("x", 0f));
    assertEquals(Float.MAX_VALUE, Arguments.notNegative("x", Float.MAX_VALUE));
    assertEquals(0.0, Arguments.notNegative("x", 0.0));
    assertEquals(Double.MAX_VALUE, Arguments.notNegative("x", Double.MAX_VALUE));
    assertEquals(0, Arguments.index("i", 3, 0));
    assertEquals(2, Arguments.index("i", 3, 2));
  }

  @Test
  void wrongArgumentsAreNamedWithTheirValue() {
    Locale.setDefault(Locale.US);
    assertEquals("x must not be null", message(() -> Arguments.notNull("x", null)));
    assertEquals("x must be finite, but it is NaN", message(() -> Arguments.finite("x", Float.NaN)));
    assertEquals("x must be greater than 0 and finite, but it is -0.0", message(() -> Arguments.positive("x", -0f)));
    assertEquals("n must be at least 1, but it is 0", message(() -> Arguments.positive("n", 0)));
    assertEquals("n must be at least 1, but it is -2147483648", message(() -> Arguments.positive("n", Integer.MIN_VALUE)));
    assertEquals("a must be between 0.0 and 180.0, both excluded, but it is 180.0",
        message(() -> Arguments.between("a", 0, 180, 180)));
    assertEquals("a must be between 0.0 and 180.0, both excluded, but it is 0.0",
        message(() -> Arguments.between("a", 0, 180, 0)));
    assertEquals("a must be between 0.0 and 180.0, both excluded, but it is NaN",
        message(() -> Arguments.between("a", 0, 180, Float.NaN)));
    assertEquals("a must be between 0.0 and 90.0, both included, but it is 90.00001",
        message(() -> Arguments.within("a", 0f, 90f, Math.nextUp(90f))));
    assertEquals("a must be between 0.0 and 90.0, both included, but it is -1.4E-45",
        message(() -> Arguments.within("a", 0f, 90f, -Float.MIN_VALUE)));
    assertThrows(IllegalArgumentException.class, () -> Arguments.within("a", 0f, 90f, Float.NaN));
    assertEquals("a must be between -20.0 and 20.0, both included, but it is 20.000000000000004",
        message(() -> Arguments.within("a", -20.0, 20.0, Math.nextUp(20.0))));
    assertThrows(IllegalArgumentException.class, () -> Arguments.within("a", -20.0, 20.0, Math.nextDown(-20.0)));
    assertThrows(IllegalArgumentException.class, () -> Arguments.within("a", -20.0, 20.0, Double.NaN));
    assertEquals("x must be at least 0 and finite, but it is -0.3", message(() -> Arguments.notNegative("x", -0.3f)));
    assertEquals("x must be at least 0 and finite, but it is Infinity",
        message(() -> Arguments.notNegative("x", Float.POSITIVE_INFINITY)));
    assertThrows(IllegalArgumentException.class, () -> Arguments.notNegative("x", Float.NaN));
    assertEquals("x must be at least 0 and finite, but it is -0.3", message(() -> Arguments.notNegative("x", -0.3)));
    assertThrows(IllegalArgumentException.class, () -> Arguments.notNegative("x", Double.POSITIVE_INFINITY));
    assertThrows(IllegalArgumentException.class, () -> Arguments.notNegative("x", Double.NaN));
    assertEquals("i must be between 0 and 2, but it is 3", message(() -> Arguments.index("i", 3, 3)));
    assertEquals("i must be between 0 and 2, but it is -1", message(() -> Arguments.index("i", 3, -1)));
    assertEquals("v must be a vector other than zero, but it is (0.0, -0.0, 0.0)",
        message(() -> Arguments.direction("v", new Vector3f(0, -0f, 0))));
    assertEquals("P must be finite, but it is (1.0, Infinity, 0.0)",
        message(() -> Arguments.finite("P", new Point3D(1, Float.POSITIVE_INFINITY, 0))));
  }

  @Test
  void largeNumbersAreToldWithoutSeparators() {
    assertEquals("n must be between 0 and 1999999, but it is 2000000", message(() ->
        Arguments.index("n", 2_000_000, 2_000_000)));
  }

  @Test
  void messagesAreInTheLanguageOfTheLocale() {
    Locale.setDefault(new Locale("es", "MX"));
    assertEquals("x no debe ser null", message(() -> Arguments.notNull("x", null)));
    assertEquals("r debe ser mayor que 0 y finito, pero es -1.5", message(() -> Arguments.positive("r", -1.5f)));
    Locale.setDefault(Locale.FRANCE);
    assertEquals("x must not be null", message(() -> Arguments.notNull("x", null)));
  }

  @Test
  void directionsAreParallelUpToTheRoundingOfFloats() {
    final Vector3f u = new Vector3f(0.1f, 0.7f, -0.3f);
    for (final float k : new float[] {1, -1, 3, 1e-20f, -1e20f, 1 / 3f}) {
      final Vector3f v = new Vector3f(k * u.x, k * u.y, k * u.z);
      final String message = message(() -> Arguments.notParallel("aux", v, "i", u));
      assertEquals("aux must not be parallel to i = " + u + ", but it is " + v, message);
    }
    assertDoesNotThrow(() -> Arguments.notParallel("aux", new Vector3f(1, 1e-6f, 0), "i", new Vector3f(1, 0, 0)));
    assertDoesNotThrow(() -> Arguments.notParallel("aux", new Vector3f(1e-30f, 0, 0), "i", new Vector3f(0, 1e30f, 0)));
    assertThrows(IllegalArgumentException.class, () -> Arguments.notParallel("aux", new Vector3f(), "i", u));
    assertThrows(IllegalArgumentException.class, () -> Arguments.notParallel("aux", u, "i", new Vector3f(Float.NaN, 0, 0)));
  }

  @Test
  void wrongStateIsAnExceptionOfItsOwn() {
    Locale.setDefault(Locale.US);
    assertEquals("the camera has no projection: call setProjection first",
        Arguments.wrongState("noProjection").getMessage());
    assertThrows(MissingResourceException.class, () -> Arguments.wrong("there is no such message"));
  }

  /** Both languages have the same messages with the same placeholders, none of them disabled by an apostrophe. */
  @Test
  void messagesOfBothLanguagesCorrespond() {
    final ResourceBundle english = ResourceBundle.getBundle("arguments.messages", Locale.ROOT);
    final ResourceBundle spanish = ResourceBundle.getBundle("arguments.messages", new Locale("es"));
    assertEquals("es", spanish.getLocale().getLanguage());
    assertTrue(english.keySet().size() > 10);
    for (final String key : english.keySet()) {
      assertTrue(spanish.keySet().contains(key), key);
      assertFalse(english.getString(key).equals(spanish.getString(key)), key);
      assertEquals(places(english.getString(key)), places(spanish.getString(key)), key);
      assertFalse((english.getString(key) + spanish.getString(key)).contains("'"), key);
    }
    assertEquals(english.keySet(), spanish.keySet());
  }

  private static TreeSet<String> places(final String message) {
    final TreeSet<String> places = new TreeSet<>();
    final Matcher matcher = Pattern.compile("\\{\\d}").matcher(message);
    while (matcher.find()) {
      places.add(matcher.group());
    }
    return places;
  }
}
