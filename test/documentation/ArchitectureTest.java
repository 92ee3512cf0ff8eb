package documentation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import java.util.stream.Stream;

import org.junit.jupiter.api.Test;

import models.Object3D;

/** Packages depend only on those that {@code doc/architecture.md} says; jdeps reads the dependencies from the classes. */
class ArchitectureTest {

  private static final Pattern DEPENDENCY = Pattern.compile("^ +([a-z]+) +-> ([a-z]+) ", Pattern.MULTILINE);
  private static final Pattern ROW = Pattern.compile("^\\| `([a-z]+)` \\| ([^|]*) \\|", Pattern.MULTILINE);
  private static final Pattern NAME = Pattern.compile("`([a-z]+)`");

  /** Columns of the picture; what follows explains it. */
  private static final int WIDTH = 38;

  /** For each package, those that its classes use. */
  private static Map<String, Set<String>> found() throws Exception {
    final Path classes = Path.of(Object3D.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    final Map<String, Set<String>> found = new TreeMap<>();
    try (Stream<Path> folders = Files.list(classes)) {
      folders.filter(Files::isDirectory).map(folder -> folder.getFileName().toString())
          .filter(name -> !"META-INF".equals(name)).forEach(name -> found.put(name, new TreeSet<>()));
    }
    final StringWriter text = new StringWriter();
    ToolProvider.findFirst("jdeps").orElseThrow().run(new PrintWriter(text), new PrintWriter(text),
        "-verbose:package", "--ignore-missing-deps", "--multi-release", "17", classes.toString());
    final Matcher line = DEPENDENCY.matcher(text.toString());
    while (line.find()) {
      if (found.containsKey(line.group(1)) && found.containsKey(line.group(2))) {
        found.get(line.group(1)).add(line.group(2));
      }
    }
    return found;
  }

  private static Map<String, Set<String>> documented() throws IOException {
    final Map<String, Set<String>> documented = new TreeMap<>();
    final Matcher row = ROW.matcher(Files.readString(Path.of("doc", "architecture.md")));
    while (row.find()) {
      final Set<String> known = new TreeSet<>();
      NAME.matcher(row.group(2)).results().forEach(name -> known.add(name.group(1)));
      documented.put(row.group(1), known);
    }
    return documented;
  }

  @Test
  void packagesKnowThoseThatTheDocumentSays() throws Exception {
    assertEquals(text(documented()), text(found()));
  }

  /** The cycles that the assignment itself makes: a generator keeps its camera, a hit its object. */
  @Test
  void noTwoPackagesNeedEachOtherExceptWhereTheAssignmentSaysSo() throws Exception {
    final Map<String, Set<String>> found = found();
    found.get("tracer").removeAll(Set.of("models", "view"));
    while (found.values().removeIf(Set::isEmpty)) {
      found.values().forEach(known -> known.retainAll(found.keySet()));
    }
    assertEquals(Map.of(), found, "these depend on each other");
  }

  /** In the picture, a package stands above those that it depends on; view, tracer and models stand in one row. */
  @Test
  void thePictureShowsTheOrder() throws Exception {
    final List<String> rows = new Document("doc/architecture.md").blocks("text").get(0).lines()
        .map(row -> row.substring(0, Math.min(row.length(), WIDTH))).toList();
    final Map<String, Set<String>> found = found();
    final Set<String> row = Set.of("view", "tracer", "models");
    found.forEach((name, known) -> known.forEach(other -> assertTrue(
        row(rows, name) < row(rows, other) || row.contains(name) && row.contains(other), () -> name + " and " + other)));
  }

  private static int row(final List<String> rows, final String name) {
    for (int i = 0; i < rows.size(); i++) {
      if (List.of(rows.get(i).strip().split("\\W+")).contains(name)) {
        return i;
      }
    }
    throw new AssertionError(name + " is not in the picture");
  }

  private static String text(final Map<String, Set<String>> map) {
    return map.toString().replace("], ", "],\n");
  }
}
