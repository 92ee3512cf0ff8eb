package documentation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.MessageFormat;
import java.util.List;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import org.junit.jupiter.api.Test;

/** The README agrees with the project. */
class ReadmeTest {

  private static final Path SCENES = Path.of("scenes");
  private static final Path GALLERY = Path.of("doc", "gallery");
  private static final int LARGEST_PICTURE = 60_000;

  private final Document readme;

  ReadmeTest() throws IOException {
    readme = new Document("README.md");
  }

  private static Set<String> names(final Path folder, final String ending) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.map(file -> file.getFileName().toString()).filter(name -> name.endsWith(ending))
          .map(name -> name.substring(0, name.length() - ending.length())).collect(Collectors.toCollection(TreeSet::new));
    }
  }

  @Test
  void isAtMost300LinesLong() throws IOException {
    assertTrue(Files.readAllLines(Path.of("README.md")).size() <= 300);
  }

  @Test
  void linksLeadToFiles() {
    final List<String> links = readme.all("\\]\\(([^)#:]+)\\)");
    assertTrue(links.size() > 15, links.toString());
    assertEquals(List.of(), links.stream().filter(link -> !Files.isRegularFile(Path.of(link))).collect(Collectors.toList()));
  }

  @Test
  void linksOfTheOtherDocumentsLeadToFiles() throws IOException {
    for (final String name : List.of("LEEME.md", "CONTRIBUTING.md", "doc/architecture.md", "doc/language.md", "doc/light.md",
        "doc/luz.md", "doc/parallel.md", "doc/performance.md", "doc/scenes.md", "doc/window.md")) {
      final Path folder = Path.of(name).toAbsolutePath().getParent();
      for (final String link : new Document(name).all("\\]\\(([^)#:]+)\\)")) {
        assertTrue(Files.isRegularFile(folder.resolve(link)), name + ": " + link);
      }
    }
  }

  @Test
  void galleryShowsEachSceneOnce() throws IOException {
    final List<String> rows = new Document("doc/scenes.md").all(
        "^\\| !\\[\\w+\\]\\(gallery/(\\w+)\\.png\\) \\| \\[\\1\\.xml\\]\\(\\.\\./scenes/\\1\\.xml\\): .+\\.");
    assertEquals(names(SCENES, ".xml"), new TreeSet<>(rows));
    assertEquals(rows.size(), new TreeSet<>(rows).size());
    assertEquals(names(SCENES, ".xml"), names(GALLERY, ".png"));
  }

  @Test
  void picturesAreSmall() throws IOException {
    for (final String name : names(GALLERY, ".png")) {
      final long size = Files.size(GALLERY.resolve(name + ".png"));
      assertTrue(size <= LARGEST_PICTURE, name + " has " + size + " bytes");
    }
  }

  @Test
  void commandsForANewMachineStandNearTheTop() {
    final String install = "apt-get update && apt-get install -y ant ant-optional ivy && ";
    assertEquals(List.of(install + "./UPNaTRay scenes/shapes.xml --no-window\n", install + "ant test\n"),
        readme.blocks("sh"));
  }

  @Test
  void theSpanishCounterpartGivesTheFirstOfThem() throws IOException {
    assertEquals(readme.blocks("sh").subList(0, 2), new Document("LEEME.md").blocks("sh"));
  }

  /** In English, whatever language the tests run in. */
  @Test
  void helpIsThatOfTheProgram() {
    final ResourceBundle messages = ResourceBundle.getBundle("upnatray.messages", Locale.ROOT);
    final String help = new MessageFormat(messages.getString("usage") + "\n", Locale.ROOT).format(null);
    assertEquals(List.of(help), readme.blocks("text"));
  }

  @Test
  void antKnowsTheTargetsThatItIsGiven() throws IOException {
    final StringBuilder build = new StringBuilder();
    for (final String part : names(Path.of("ant"), ".xml")) {
      build.append(Files.readString(Path.of("ant", part + ".xml")));
    }
    final List<String> targets = readme.all("`ant ([a-z-]{3,})`");
    assertTrue(targets.size() > 6, targets.toString());
    assertEquals(List.of(), targets.stream().filter(target -> build.indexOf("<target name=\"" + target + "\"") < 0)
        .collect(Collectors.toList()));
  }

  @Test
  void eachLibraryIsNamed() throws IOException {
    final List<String> named = readme.all("^\\| (\\w+) \\| [^|]+ \\|$").stream().map(name -> name.toLowerCase(Locale.ROOT))
        .collect(Collectors.toList());
    final String ivy = Files.readString(Path.of("ivy.xml"));
    final Matcher dependency = Pattern.compile("<dependency org=\"([^\"]+)\" name=\"([^\"]+)\"").matcher(ivy);
    assertTrue(dependency.find());
    do {
      final String library = dependency.group(1) + ' ' + dependency.group(2);
      assertTrue(named.stream().anyMatch(library::contains), library);
    } while (dependency.find());
  }
}
