package examples;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;

import javax.imageio.ImageIO;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The documentation of a shape shows its picture, and names the source of its algorithm. */
class ShapePicturesTest {

  private static final Path MODELS = Path.of("src", "models");
  private static final Pattern PICTURE = Pattern.compile("<img src=\"doc-files/(\\w+)\\.png\"");
  /** A title and a year, as in: "Sphere tracing", The Visual Computer 12, 1996. */
  private static final Pattern SOURCE = Pattern.compile("\"[^\"]+\",\\s[^\"]*\\d{4}");
  /** Their documentation refers to that of their objects. */
  private static final Set<String> WITHOUT_SOURCE = Set.of("Group3D", "TriangularMesh");

  @TempDir
  private Path folder;

  @Test
  void thoseThatAreDrawnAreThoseThatAreShown() throws IOException {
    ShapePictures.main(folder.toString());
    final Set<String> shown = new TreeSet<>();
    try (Stream<Path> files = Files.list(MODELS)) {
      for (final Path file : (Iterable<Path>) files::iterator) {
        PICTURE.matcher(Files.readString(file)).results().forEach(picture -> shown.add(picture.group(1)));
      }
    }
    assertEquals(13, shown.size());
    assertEquals(shown, new TreeSet<>(ShapePictures.shapes().keySet()));
    for (final String name : shown) {
      assertEquals(320, ImageIO.read(folder.resolve(name + ".png").toFile()).getWidth());
    }
  }

  @Test
  void eachClassHasItsPictureAndASource() throws IOException {
    for (final String name : ShapePictures.shapes().keySet()) {
      final String text = Files.readString(MODELS.resolve(name + ".java"));
      final String comment = text.substring(text.indexOf("/**"), text.indexOf("public class"));
      assertTrue(comment.contains("<img src=\"doc-files/" + name + ".png\" width=\"320\" height=\"240\" alt="), name);
      assertTrue(WITHOUT_SOURCE.contains(name) || SOURCE.matcher(comment).find(), name);
    }
  }
}
