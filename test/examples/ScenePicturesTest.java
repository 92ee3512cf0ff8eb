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

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** The documentation of the passes, of light and of meshes shows the pictures that are drawn for it, in their size. */
class ScenePicturesTest {

  private static final Pattern PICTURE =
      Pattern.compile("<img src=\"(doc-files/\\w+\\.png)\" width=\"(\\d+)\" height=\"(\\d+)\"\\s+(?:\\* +)?alt=");

  private static Map<String, BufferedImage> drawn;

  @BeforeAll
  static void draw() {
    drawn = ScenePictures.pictures();
  }

  @Test
  void thoseThatAreDrawnAreThoseThatAreShown() throws IOException {
    final Set<String> shown = new TreeSet<>();
    for (final String folder : new String[] {"rendering", "meshes"}) {
      try (Stream<Path> files = Files.list(Path.of("src", folder))) {
        for (final Path file : (Iterable<Path>) files.filter(file -> file.toString().endsWith(".java"))::iterator) {
          PICTURE.matcher(Files.readString(file)).results().forEach(picture -> {
            final String name = folder + "/" + picture.group(1);
            shown.add(name);
            final BufferedImage image = drawn.get(name);
            assertTrue(image != null, name);
            assertEquals(picture.group(2) + " x " + picture.group(3), image.getWidth() + " x " + image.getHeight(), name);
          });
        }
      }
    }
    assertEquals(new TreeSet<>(drawn.keySet()), shown);
  }

  @Test
  void eachShowsSomething() {
    drawn.forEach((name, image) -> {
      final Set<Integer> colours = new TreeSet<>();
      for (int i = 0; i < image.getWidth() * image.getHeight(); i++) {
        colours.add(image.getRGB(i % image.getWidth(), i / image.getWidth()));
      }
      assertTrue(colours.size() > 5, () -> name + " has " + colours.size() + " colours");
    });
  }
}
