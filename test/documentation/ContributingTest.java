package documentation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The shape and its test that CONTRIBUTING gives compile, and the laws of all shapes hold for it. */
class ContributingTest {

  private static final Pattern FILE = Pattern.compile("`((?:src|test)/\\S+\\.java)`.*?^```java\\n(.*?)^```$",
      Pattern.MULTILINE | Pattern.DOTALL);
  /** What the laws are at least, as methods; fewer would mean that they were not found. */
  private static final int LAWS = 10;

  @TempDir
  private Path folder;

  @Test
  void theExampleObeysTheLawsOfAllShapes() throws Exception {
    final Compilation compilation = new Compilation(folder);
    final Matcher file = FILE.matcher(Files.readString(Path.of("CONTRIBUTING.md")));
    int files = 0;
    for (; file.find(); files++) {
      compilation.add(file.group(1), file.group(2));
    }
    assertEquals(2, files);
    assertEquals(files, new Document("CONTRIBUTING.md").blocks("java").size());
    compilation.succeeds();
    final String passed = compilation.run("documentation.Laws", "models.DiscTest").strip();
    assertTrue(Integer.parseInt(passed) >= LAWS, passed);
  }
}
