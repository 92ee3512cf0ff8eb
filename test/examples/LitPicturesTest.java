package examples;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;

import javax.imageio.ImageIO;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The documentation of a material, a distribution or a light shows its picture, and says where its formula comes from. */
class LitPicturesTest {

  private static final Pattern PICTURE = Pattern.compile("<img src=\"doc-files/(\\w+)\\.png\" width=\"320\"");
  /** A title and a year, as in: "Models of light reflection", SIGGRAPH 1977. */
  private static final Pattern SOURCE = Pattern.compile("\"[^\"]+\",\\s[^\"]*\\d{4}");
  /** The kind of light that is the course's own. */
  private static final Set<String> WITHOUT_SOURCE = Set.of("Directional");

  @TempDir
  private Path folder;

  @Test
  void thoseThatAreDrawnAreThoseThatAreShown() throws IOException {
    LitPictures.main(folder.toString());
    final Map<String, Set<String>> drawn = Map.of("materials", LitPictures.materials().keySet(),
        "lights", LitPictures.lights().keySet());
    for (final Map.Entry<String, Set<String>> names : drawn.entrySet()) {
      final Set<String> shown = new TreeSet<>();
      try (Stream<Path> files = Files.list(Path.of("src", names.getKey()))) {
        for (final Path file : (Iterable<Path>) files::iterator) {
          PICTURE.matcher(Files.readString(file)).results().forEach(picture -> shown.add(picture.group(1)));
        }
      }
      assertEquals(shown, new TreeSet<>(names.getValue()));
      for (final String name : shown) {
        assertShowsALitBall(ImageIO.read(folder.resolve(Path.of(names.getKey(), "doc-files", name + ".png")).toFile()));
      }
    }
  }

  /** Neither black nor overexposed. */
  private static void assertShowsALitBall(final BufferedImage image) {
    assertEquals(320, image.getWidth());
    int lit = 0, burnt = 0;
    for (int x = 80; x < 240; x++) {
      for (int y = 30; y < 180; y++) {
        final int green = image.getRGB(x, y) >> 8 & 0xFF;
        lit += green > 30 ? 1 : 0;
        burnt += green == 255 && image.getRGB(x, y) >>> 24 == 255 ? 1 : 0;
      }
    }
    final String counts = lit + " lit, " + burnt + " burnt";
    assertTrue(lit > 160 * 150 / 3 && burnt < 160 * 150 / 6, counts);
  }

  @Test
  void eachClassHasItsPictureAndASource() throws IOException {
    for (final String name : LitPictures.materials().keySet()) {
      assertDocumented(Path.of("src", "materials", name + ".java"), name);
    }
    for (final String name : LitPictures.lights().keySet()) {
      assertDocumented(Path.of("src", "lights", name + ".java"), name);
    }
  }

  private static void assertDocumented(final Path file, final String name) throws IOException {
    final String text = Files.readString(file);
    final String comment = text.substring(text.indexOf("/**"), text.indexOf("public final class"))
        .replaceAll("\\n \\* ?", " ");
    assertTrue(comment.contains("<img src=\"doc-files/" + name + ".png\" width=\"320\" height=\"240\" alt="), name);
    assertTrue(WITHOUT_SOURCE.contains(name) || SOURCE.matcher(comment).find(), name);
  }
}
