package documentation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.io.StringWriter;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import javax.imageio.ImageIO;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import models.Object3D;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/** The examples of the README compile without a warning, and do what is said of them. */
class ReadmeExamplesTest {

  private static final String CLASS_PATH = Stream.of(System.getProperty("java.class.path").split(File.pathSeparator))
      .map(entry -> Path.of(entry).toAbsolutePath().toString()).collect(Collectors.joining(File.pathSeparator));

  @TempDir
  private Path folder;

  /** Compiles a class of the README into the folder. */
  private void compile(final String className) throws IOException {
    final Path source = Files.writeString(folder.resolve(className + ".java"), new Readme().source(className));
    final JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    final StringWriter messages = new StringWriter();
    final boolean compiled = compiler.getTask(messages, null, null,
        List.of("-Xlint:all", "-Werror", "-proc:none", "--release", "17", "-cp", CLASS_PATH, "-d", folder.toString()), null,
        compiler.getStandardFileManager(null, null, null).getJavaFileObjects(source)).call();
    assertTrue(compiled, messages::toString);
  }

  @Test
  void theFirstProgramMakesItsPicture() throws Exception {
    compile("First");
    final Path output = folder.resolve("output");
    final Process program = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
        "-Djava.awt.headless=true", "-cp", folder + File.pathSeparator + CLASS_PATH, "First")
        .directory(folder.toFile()).redirectErrorStream(true).redirectOutput(output.toFile()).start();
    assertTrue(program.waitFor(2, TimeUnit.MINUTES), "it does not come to an end");
    assertEquals("", Files.readString(output));
    assertEquals(0, program.exitValue());
    final BufferedImage picture = ImageIO.read(folder.resolve("first.png").toFile());
    assertEquals(600, picture.getWidth());
    assertEquals(400, picture.getHeight());
    assertEquals(Color.DARK_GRAY.getRGB(), picture.getRGB(0, 0), "background in a corner");
    final Color middle = new Color(picture.getRGB(300, 200));
    assertTrue(middle.getRed() > 240 && middle.getBlue() == 0, "the orange sphere faces the camera, not " + middle);
  }

  @Test
  void theShapeOfOnesOwnIsMetInsideItsEdgeOnly() throws Exception {
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
}
