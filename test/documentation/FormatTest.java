package documentation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import org.junit.jupiter.api.Test;

/** Text files follow the rules of {@code .editorconfig}. */
class FormatTest {

  private static final List<String> FOLDERS =
      List.of(".ci", "ant", "bench", "doc", "handin", "nbproject", "scenes", "src", "test");
  private static final String TEXT = ".*\\.(java|properties|xml|xsd|xsl|html|md)|\\.ci/\\w+|UPNaTRay";

  private final List<String> rules = Files.readAllLines(Path.of(".editorconfig"));
  private final List<String> faults = new ArrayList<>();

  FormatTest() throws IOException {
    // The rules are read where they are declared, which may fail.
  }

  private static List<Path> texts() throws IOException {
    final List<Path> texts = new ArrayList<>();
    try (Stream<Path> here = Files.list(Path.of(""))) {
      here.filter(Files::isRegularFile).forEach(texts::add);
    }
    for (final String folder : FOLDERS) {
      try (Stream<Path> files = Files.walk(Path.of(folder))) {
        files.filter(Files::isRegularFile).forEach(texts::add);
      }
    }
    return texts.stream().filter(file -> file.toString().replace('\\', '/').matches(TEXT))
        .filter(file -> !isForeign(file)).sorted().collect(Collectors.toList());
  }

  /** Files written by NetBeans, and the programs of students, which are in no package. */
  private static boolean isForeign(final Path file) {
    return file.startsWith(Path.of("nbproject", "private")) || file.endsWith("build-impl.xml")
        || file.endsWith("genfiles.properties") || Path.of("src").equals(file.getParent());
  }

  /** The settings of all sections whose pattern fits the file's name; later ones win. */
  private Map<String, String> settings(final Path file) {
    final Map<String, String> settings = new HashMap<>();
    boolean fits = false;
    for (final String rule : rules) {
      final int equals = rule.indexOf('=');
      if (rule.startsWith("[")) {
        fits = FileSystems.getDefault().getPathMatcher("glob:" + rule.substring(1, rule.lastIndexOf(']')))
            .matches(file.getFileName());
      } else if (fits && equals > 0) {
        settings.put(rule.substring(0, equals).strip(), rule.substring(equals + 1).strip());
      }
    }
    return settings;
  }

  private void check(final Path file) throws IOException {
    final Map<String, String> settings = settings(file);
    final String columns = settings.get("max_line_length");
    final int longest = "off".equals(columns) ? Integer.MAX_VALUE : Integer.parseInt(columns);
    final String text = Files.readString(file);
    final String[] lines = text.split("\n");
    fault(file, lines.length, "true".equals(settings.get("insert_final_newline")) && !text.endsWith("\n"),
        "no end of line at its end");
    for (int i = 0; i < lines.length; i++) {
      final String line = lines[i];
      fault(file, i + 1, "space".equals(settings.get("indent_style")) && line.indexOf('\t') >= 0, "a tab");
      fault(file, i + 1, "lf".equals(settings.get("end_of_line")) && line.indexOf('\r') >= 0, "a carriage return");
      fault(file, i + 1, "true".equals(settings.get("trim_trailing_whitespace")) && line.matches(".*[ \t]"),
          "a blank at its end");
      fault(file, i + 1, line.codePointCount(0, line.length()) > longest, "more than " + columns + " columns");
    }
  }

  private void fault(final Path file, final int line, final boolean isFault, final String what) {
    if (isFault) {
      faults.add(file + ":" + line + ": " + what);
    }
  }

  @Test
  void textsAreFormatted() throws IOException {
    final List<Path> texts = texts();
    assertTrue(texts.size() > 200, () -> "only " + texts.size());
    for (final Path text : texts) {
      check(text);
    }
    assertEquals("", String.join("\n", faults));
  }
}
