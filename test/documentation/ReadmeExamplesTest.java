package documentation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;

import javax.imageio.ImageIO;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import models.Object3D;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/** The examples of the README compile without warnings, and do what it says. */
class ReadmeExamplesTest {

  private static final Pattern CLASS = Pattern.compile("^public class (\\w+) ", Pattern.MULTILINE);

  @TempDir
  private Path folder;

  private final List<String> blocks;

  ReadmeExamplesTest() throws IOException {
    blocks = new Document("README.md").blocks("java");
  }

  /** The source that defines a public class. */
  private String source(final String className) {
    return blocks.stream().filter(block -> block.contains("public class " + className + " "))
        .findFirst().orElseThrow(() -> new AssertionError("the README has no class " + className));
  }

  private Compilation compile(final String className) throws IOException {
    final Compilation compilation = new Compilation(folder).add(className + ".java", source(className));
    compilation.succeeds();
    return compilation;
  }

  @Test
  void theFirstProgramMakesItsPicture() throws Exception {
    assertEquals("", compile("First").run("First"));
    final BufferedImage picture = ImageIO.read(folder.resolve("first.png").toFile());
    assertEquals(600, picture.getWidth());
    assertEquals(400, picture.getHeight());
    assertEquals(Color.DARK_GRAY.getRGB(), picture.getRGB(0, 0), "background in a corner");
    final Color middle = new Color(picture.getRGB(300, 200));
    assertTrue(middle.getRed() > 240 && middle.getBlue() == 0, "the orange sphere faces the camera, not " + middle);
  }

  @Test
  void rayHitsTheDiscWithinItsEdgeOnly() throws Exception {
    compile("Disc");
    try (URLClassLoader loader = new URLClassLoader(new URL[] {folder.toUri().toURL()}, getClass().getClassLoader())) {
      final Object3D disc = (Object3D) loader.loadClass("Disc")
          .getConstructor(Point3D.class, Vector3D.class, float.class, Color.class)
          .newInstance(new Point3D(0, 1, 0), new Vector3D(0, 2, 0), 2f, Color.RED);
      final Vector3D down = new Vector3D(0, -1, 0);
      final Hit hit = disc.intersectionWith(new Ray(new Point3D(1.9f, 5, 0), down));
      assertEquals(4, hit.getT());
      assertEquals(new Vector3D(0, 1, 0), hit.getNormal());
      assertSame(disc, hit.getObject());
      assertSame(Hit.NOHIT, disc.intersectionWith(new Ray(new Point3D(2.1f, 5, 0), down)));
      assertSame(Hit.NOHIT, disc.intersectionWith(new Ray(new Point3D(0, 0, 0), down)));
    }
  }

  @Test
  void theDiscIsInThePictureOfTheFirstProgram() throws Exception {
    final List<String> calls = new Document("README.md").all("`(scene\\.addObject[^`]+;)`");
    assertEquals(1, calls.size());
    final Compilation compilation = new Compilation(folder).add("Disc.java", source("Disc"))
        .add("First.java", source("First").replace("    Camera camera", calls.get(0) + "\n    Camera camera"));
    compilation.succeeds();
    assertEquals("", compilation.run("First"));
    final Color low = new Color(ImageIO.read(folder.resolve("first.png").toFile()).getRGB(300, 360));
    assertTrue(low.getRed() > low.getGreen() && low.getGreen() == low.getBlue(), "the pink disc, not " + low);
  }

  @Test
  void theCustomLightAndMaterialAreInTheLitPicture() throws Exception {
    final Compilation compilation = new Compilation(folder).add("Candle.java", source("Candle"))
        .add("Toon.java", source("Toon"))
        .add("Lit.java", source("Lit"));
    compilation.succeeds();
    assertEquals("", compilation.run("Lit"));
    final BufferedImage picture = ImageIO.read(folder.resolve("lit.png").toFile());
    final Color bright = new Color(picture.getRGB(390, 150)), dark = new Color(picture.getRGB(325, 220));
    assertTrue(bright.getRed() > 2 * bright.getBlue() && bright.getRed() > dark.getRed() + 40, bright + ", " + dark);
  }

  @Test
  void everyBlockIsAClass() {
    assertEquals(5, blocks.size());
    blocks.forEach(block -> assertTrue(CLASS.matcher(block).find(), block));
  }

  @Test
  void theBoxOfTheDiscCompiles() throws IOException {
    final List<String> members = new Document("doc/window.md").blocks("java");
    assertEquals(1, members.size());
    final String disc = source("Disc");
    new Compilation(folder).add("Disc.java", disc.substring(0, disc.lastIndexOf('}')) + "\n" + members.get(0) + "}\n")
        .succeeds();
  }

  /** As the text says: the lines of the first program up to the projection, and then the call. */
  @Test
  void theProgramThatShowsADiscInTheWindowCompiles() throws IOException {
    final List<String> calls = new Document("doc/window.md").all("`(window\\.[^`]+\\))`");
    assertEquals(1, calls.size());
    final String first = source("First");
    final int projection = first.indexOf('\n', first.indexOf("setProjection"));
    new Compilation(folder).add("First.java", first.substring(0, projection) + "\n" + calls.get(0) + ";\n}\n}\n").succeeds();
  }
}
