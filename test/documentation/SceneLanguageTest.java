package documentation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import javax.imageio.ImageIO;
import javax.xml.XMLConstants;
import javax.xml.transform.stream.StreamSource;
import javax.xml.validation.Schema;
import javax.xml.validation.SchemaFactory;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import rendering.RenderSettings;
import scenes.ReadResult;
import scenes.SceneFile;
import scenes.SceneReader;
import upnatray.Image;
import upnatray.RenderJob;

/**
 * The page of the scene language covers every element, and its pictures are those of its snippets. After a change, write
 * the pictures anew by
 * {@code ant test-single -Dtest.includes=documentation/SceneLanguageTest.java -Dtest.jvmargs="-ea -Dlanguage.write=true"},
 * and look at them before committing.
 */
class SceneLanguageTest {

  private static final Path PICTURES = Path.of("doc", "language");
  private static final boolean WRITE = Boolean.getBoolean("language.write");
  private static final int LARGEST_FILE = 25_000;
  /** How far a channel of the picture may be off, for a rounding that falls to the other side. */
  private static final int ROUNDING = 2;

  private final SceneLanguagePage page;
  private final Map<String, String> scenes;

  @TempDir
  private Path folder;

  SceneLanguageTest() throws Exception {
    page = new SceneLanguagePage();
    scenes = page.scenes();
  }

  private BufferedImage picture(final String name, final String text) throws IOException {
    final ReadResult reading = SceneReader.read(Files.writeString(folder.resolve(name + ".xml"), text));
    assertEquals("[]", reading.problems().toString(), name);
    final SceneFile scene = reading.scene().orElseThrow();
    final Image image = new Image(scene.width(), scene.height(), scene.background());
    image.synthesis(scene.objects(), scene.camera(), RenderSettings.STANDARD.withShading(RenderJob.shading(scene)));
    final BufferedImage opaque = new BufferedImage(scene.width(), scene.height(), BufferedImage.TYPE_INT_RGB);
    opaque.createGraphics().drawImage(image, 0, 0, null);
    return opaque;
  }

  @Test
  void eachPictureIsThatOfItsSnippet() throws Exception {
    assertTrue(scenes.size() > 40, () -> scenes.keySet().toString());
    final List<String> faults = new ArrayList<>();
    for (final Map.Entry<String, String> scene : scenes.entrySet()) {
      final BufferedImage picture = picture(scene.getKey(), scene.getValue());
      final File file = PICTURES.resolve(scene.getKey() + ".png").toFile();
      if (WRITE) {
        ImageIO.write(picture, "png", file);
      }
      if (!file.isFile() || file.length() > LARGEST_FILE || !isNear(ImageIO.read(file), picture)) {
        faults.add(scene.getKey());
      }
    }
    assertEquals(List.of(), faults, "pictures that are missing, too large, or of another snippet");
  }

  private static boolean isNear(final BufferedImage a, final BufferedImage b) {
    int far = Math.abs(a.getWidth() - b.getWidth()) + Math.abs(a.getHeight() - b.getHeight());
    for (int y = 0; far == 0 && y < a.getHeight(); y++) {
      for (int x = 0; x < a.getWidth(); x++) {
        far += isNear(a.getRGB(x, y), b.getRGB(x, y)) ? 0 : 1;
      }
    }
    return far == 0;
  }

  private static boolean isNear(final int a, final int b) {
    return Stream.of(0, 8, 16).allMatch(shift -> Math.abs((a >> shift & 255) - (b >> shift & 255)) <= ROUNDING);
  }

  @Test
  void eachSceneKeepsToTheSchema() throws Exception {
    final Schema schema = SchemaFactory.newInstance(XMLConstants.W3C_XML_SCHEMA_NS_URI)
        .newSchema(Path.of("scenes", "scene.xsd").toFile());
    for (final String scene : scenes.values()) {
      schema.newValidator().validate(new StreamSource(new StringReader(scene)));
    }
  }

  @Test
  void eachNameOfTheLanguageIsOnThePage() throws IOException {
    final String schema = Files.readString(Path.of("scenes", "scene.xsd"));
    final Set<String> names = Pattern.compile("<xs:(?:element name|enumeration value|attribute name)=\"([\\w-]+)\"")
        .matcher(schema).results().map(name -> name.group(1)).collect(Collectors.toCollection(TreeSet::new));
    assertTrue(names.size() > 90, names::toString);
    names.removeAll(Set.of("true", "false", "TRUE", "FALSE", "True", "False"));
    names.removeIf(this::isOnThePage);
    assertEquals(Set.of(), names);
  }

  /** As code of its own, or in a snippet as an element, an attribute, or a value. */
  private boolean isOnThePage(final String name) {
    return Pattern.compile("`" + name + "`|[<\">]" + name + "[ <\">]| " + name + "=\"").matcher(page.text()).find();
  }

  @Test
  void thePageHasNoOtherPictures() throws IOException {
    try (Stream<Path> files = Files.list(PICTURES)) {
      final Set<String> names = files.map(file -> file.getFileName().toString().replaceFirst("\\.png$", ""))
          .collect(Collectors.toCollection(TreeSet::new));
      assertEquals(new TreeSet<>(scenes.keySet()), names);
    }
    assertEquals(scenes.size(), page.text().split("\\(language/", -1).length - 1);
  }
}
