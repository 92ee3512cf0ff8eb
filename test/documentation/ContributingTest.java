package documentation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The extensions and their tests that CONTRIBUTING gives compile, and the laws of their kinds hold for them. */
class ContributingTest {

  private static final Pattern FILE = Pattern.compile("`((?:src|test)/\\S+)\\.java`.*?^```java\\n(.*?)^```$",
      Pattern.MULTILINE | Pattern.DOTALL);
  /** How many laws each kind has at least, as methods; fewer would mean that they were not found. */
  private static final Map<String, Integer> LAWS = Map.of("models.DiscTest", 10, "lights.PanelTest", 4,
      "materials.MoonDustTest", 5, "view.StereographicTest", 10, "rendering.ChequersTest", 3);

  @TempDir
  private Path folder;

  @Test
  void theExamplesObeyTheLawsOfTheirKinds() throws Exception {
    final Compilation compilation = new Compilation(folder);
    final Matcher file = FILE.matcher(Files.readString(Path.of("CONTRIBUTING.md")));
    final Set<String> tests = new TreeSet<>();
    int files = 0;
    for (; file.find(); files++) {
      compilation.add(file.group(1) + ".java", file.group(2));
      if (file.group(1).startsWith("test/")) {
        tests.add(file.group(1).substring("test/".length()).replace('/', '.'));
      }
    }
    assertEquals(new TreeSet<>(LAWS.keySet()), tests);
    assertEquals(files, new Document("CONTRIBUTING.md").blocks("java").size());
    compilation.succeeds();
    for (final String test : tests) {
      final String passed = compilation.run("documentation.Laws", test).strip();
      assertTrue(Integer.parseInt(passed) >= LAWS.get(test), () -> test + ": " + passed);
    }
  }
}
