package upnatray;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

import javax.imageio.ImageIO;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rendering.RenderSettings;
import rendering.Shading;
import scenes.ReadResult;
import scenes.SceneFile;
import scenes.SceneReader;

/**
 * Every example scene, rendered small, is the picture that is kept in {@code test/references}, pixel by pixel. Of one
 * that is not, the picture and the differences are left in {@code build/references}. The current pictures become the
 * references by
 * {@code ant test-single -Dtest.includes=upnatray/ReferenceImagesTest.java -Dtest.jvmargs="-ea -Dtest.references=write"};
 * look at the pictures before committing them.
 */
class ReferenceImagesTest {

  private static final int LONGER_SIDE = 160;
  private static final Path SCENES = Path.of("scenes"), REFERENCES = Path.of("test", "references");
  private static final Path FAILURES = Path.of("build", "references");
  private static final boolean WRITE = "write".equals(System.getProperty("test.references"));

  static List<String> names() throws IOException {
    return names(SCENES, ".xml");
  }

  private static List<String> names(final Path folder, final String ending) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.map(file -> file.getFileName().toString()).filter(name -> name.endsWith(ending))
          .map(name -> name.substring(0, name.length() - ending.length())).sorted().toList();
    }
  }

  private static Image render(final String name) {
    final ReadResult reading = SceneReader.read(SCENES.resolve(name + ".xml"));
    final SceneFile scene = reading.scene().orElseThrow(() -> new AssertionError(reading.problems().toString()));
    final double scale = (double) LONGER_SIDE / Math.max(scene.width(), scene.height());
    final Image image = new Image((int) Math.max(1, Math.round(scale * scene.width())),
        (int) Math.max(1, Math.round(scale * scene.height())), scene.background());
    final RenderSettings rendering = RenderSettings.STANDARD.withShading(RenderJob.shading(scene));
    assertTrue(image.synthesis(scene.objects(), scene.camera(), rendering));
    return image;
  }

  @ParameterizedTest
  @MethodSource("names")
  void everySceneIsItsReference(final String name) throws IOException {
    final Image image = render(name);
    final Path reference = REFERENCES.resolve(name + ".png");
    if (WRITE) {
      write(image, reference);
    }
    if (!Files.exists(reference)) {
      write(image, FAILURES.resolve(name + ".png"));
      fail("there is no " + reference + "; the picture is in " + FAILURES);
    }
    final BufferedImage expected = ImageIO.read(reference.toFile());
    final BufferedImage difference = difference(expected, image);
    if (difference != null) {
      write(image, FAILURES.resolve(name + ".png"));
      write(difference, FAILURES.resolve(name + "-difference.png"));
      fail(name + " is not " + reference + "; the picture and the differences are in " + FAILURES);
    }
  }

  /** White where two images differ; null if they are equal. */
  private static BufferedImage difference(final BufferedImage a, final BufferedImage b) {
    final int W = Math.max(a.getWidth(), b.getWidth()), H = Math.max(a.getHeight(), b.getHeight());
    final BufferedImage difference = new BufferedImage(W, H, BufferedImage.TYPE_INT_RGB);
    boolean equal = a.getWidth() == b.getWidth() && a.getHeight() == b.getHeight();
    for (int x = 0; x < W; x++) {
      for (int y = 0; y < H; y++) {
        final boolean same = contains(a, x, y) && contains(b, x, y) && a.getRGB(x, y) == b.getRGB(x, y);
        difference.setRGB(x, y, same ? 0 : 0xffffff);
        equal &= same;
      }
    }
    return equal ? null : difference;
  }

  private static boolean contains(final BufferedImage image, final int x, final int y) {
    return x < image.getWidth() && y < image.getHeight();
  }

  private static void write(final BufferedImage image, final Path file) {
    try {
      Files.createDirectories(file.getParent());
      ImageIO.write(image, "png", file.toFile());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Test
  void thereIsNoReferenceWithoutAScene() throws IOException {
    final Set<String> references = new TreeSet<>(names(REFERENCES, ".png"));
    references.removeAll(names());
    assertEquals(Set.of(), references);
  }

  @Test
  void thereAreScenes() throws IOException {
    assertTrue(names().size() >= 8, names()::toString);
  }

  @ParameterizedTest
  @MethodSource("names")
  void everySceneHasThePixelsOfSingleRays(final String name) {
    final SceneFile scene = SceneReader.read(SCENES.resolve(name + ".xml")).scene().orElseThrow();
    final Image image = new Image(70, 50, scene.background());
    for (final Shading shading : List.of(Shading.PLAIN, Shading.FACING, RenderJob.shading(scene))) {
      final int[] expected = SingleRays.pixels(
          scene.objects(), scene.camera(), 70, 50, scene.background().getRGB(), shading);
      assertTrue(image.synthesis(scene.objects(), scene.camera(),
          RenderSettings.STANDARD.withThreads(3).withShading(shading)));
      assertArrayEquals(expected, ImageTest.pixels(image));
    }
  }
}
