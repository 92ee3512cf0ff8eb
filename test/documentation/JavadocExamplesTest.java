package documentation;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The examples in comments compile: a class as it stands, statements as the body of a method. */
class JavadocExamplesTest {

  private static final Pattern BLOCK = Pattern.compile("^ *\\* <pre>(.*?)</pre>", Pattern.DOTALL | Pattern.MULTILINE);
  private static final Pattern JAVA = Pattern.compile("\\s*\\{@code\\n(.*)\\}", Pattern.DOTALL);
  private static final Pattern CLASS = Pattern.compile("\\bclass (\\w+) ");
  private static final String IMPORTS = Stream.of("java.awt.Color", "lights.*", "materials.*", "models.*", "primitives.*",
      "radiometry.*", "tracer.*", "view.*", "upnatray.*").map(name -> "import " + name + ";\n")
      .collect(Collectors.joining());

  @TempDir
  private Path folder;

  private static List<Path> sources(final String root) throws IOException {
    try (Stream<Path> files = Files.walk(Path.of(root))) {
      return files.filter(file -> file.toString().endsWith(".java")).sorted().collect(Collectors.toList());
    }
  }

  /** The package is that of the file, so that an example can use what its readers can. */
  private static String source(final Path file, final Path root, final String example) {
    final String place = root.relativize(file.getParent()).toString().replace('/', '.').replace('\\', '.');
    final String body = CLASS.matcher(example).find() ? example
        : "class Example {\n  void example() {\n" + example + "  }\n}\n";
    return "package " + place + ";\n" + IMPORTS + body;
  }

  private int compileAll(final String root) throws IOException {
    int examples = 0;
    for (final Path file : sources(root)) {
      final Matcher block = BLOCK.matcher(Files.readString(file));
      while (block.find()) {
        final Matcher java = JAVA.matcher(block.group(1).replaceAll("(?m)^ *\\* ?", ""));
        assertTrue(java.matches(), () -> file + ": what is this? " + block.group());
        final String source = source(file, Path.of(root), java.group(1));
        final Matcher name = CLASS.matcher(source);
        assertTrue(name.find());
        new Compilation(folder.resolve(root + ++examples)).add(name.group(1) + ".java", source).succeeds();
      }
    }
    return examples;
  }

  @Test
  void examplesInCommentsCompile() throws IOException {
    final int ofProgram = compileAll("src");
    final int ofTests = compileAll("test");
    assertTrue(ofProgram >= 2 && ofTests >= 1, () -> ofProgram + ", " + ofTests);
  }
}
