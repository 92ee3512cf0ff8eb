package scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.MessageFormat;
import java.util.Properties;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The messages of all packages exist in English and in Spanish, with the same keys and placeholders. */
class BundlesTest {

  private static final Pattern PLACE = Pattern.compile("\\{(\\d+)\\}");

  static Stream<Path> bundles() throws IOException {
    try (Stream<Path> files = Files.walk(Path.of("src"))) {
      return files.filter(file -> file.endsWith("messages.properties")).sorted().collect(Collectors.toList()).stream();
    }
  }

  private static Properties properties(final Path file) throws IOException {
    final Properties properties = new Properties();
    try (Reader reader = Files.newBufferedReader(file)) {
      properties.load(reader);
    }
    return properties;
  }

  @Test
  void allBundlesAreSeen() throws IOException {
    final Set<String> packages = bundles().map(file -> file.getParent().getFileName().toString())
        .collect(Collectors.toSet());
    assertTrue(packages.containsAll(Set.of("arguments", "scenes", "upnatray")), packages.toString());
  }

  @ParameterizedTest
  @MethodSource("bundles")
  void bothLanguagesHaveTheSameKeysAndPlaces(final Path english) throws IOException {
    final Properties en = properties(english), es = properties(english.resolveSibling("messages_es.properties"));
    assertEquals(new TreeSet<>(en.stringPropertyNames()), new TreeSet<>(es.stringPropertyNames()));
    for (final String key : en.stringPropertyNames()) {
      assertEquals(places(en.getProperty(key)), places(es.getProperty(key)), key);
      assertNotEquals("", en.getProperty(key).strip(), key);
      assertNotEquals("", es.getProperty(key).strip(), key);
    }
  }

  /** A lone apostrophe would disable the placeholders after it. */
  @ParameterizedTest
  @MethodSource("bundles")
  void everyPlaceIsFilled(final Path english) throws IOException {
    for (final Path file : new Path[] {english, english.resolveSibling("messages_es.properties")}) {
      final Properties properties = properties(file);
      for (final String key : properties.stringPropertyNames()) {
        final Object[] values = {"v0v", "v1v", "v2v", "v3v", "v4v", "v5v"};
        final String text = MessageFormat.format(properties.getProperty(key), values);
        for (final String place : places(properties.getProperty(key))) {
          assertTrue(text.contains("v" + place + "v"), file + ": " + key);
        }
        assertFalse(PLACE.matcher(text).find(), file + ": " + key);
      }
    }
  }

  private static Set<String> places(final String text) {
    final Matcher matcher = PLACE.matcher(text);
    final Set<String> places = new TreeSet<>();
    while (matcher.find()) {
      places.add(matcher.group(1));
    }
    return places;
  }

  /**
   * A key that no source names is unused. The source may have it as a literal or at the end of one, without the ending
   * "Any", or up to its first point if it is composed; its package may precede it.
   */
  @ParameterizedTest
  @MethodSource("bundles")
  void everyKeyIsUsed(final Path english) throws IOException {
    final StringBuilder sources = new StringBuilder();
    try (Stream<Path> files = Files.walk(Path.of("src"))) {
      for (final Path file : files.filter(path -> path.toString().endsWith(".java")).collect(Collectors.toList())) {
        sources.append(Files.readString(file).replace('"' + english.getParent().getFileName().toString() + '.', "\""));
      }
    }
    for (final String key : properties(english).stringPropertyNames()) {
      final String start = '"' + key.replaceAll("\\..*", "");
      final boolean composed = key.indexOf('.') > 0 && (sources.indexOf(start + '.') >= 0 || sources.indexOf(start
          + '"') >= 0);
      final boolean used = composed || sources.indexOf('"' + key.replaceAll("Any$", "") + '"') >= 0
          || sources.indexOf(' ' + key + '"') >= 0;
      assertTrue(used, english + ": " + key);
    }
  }
}
