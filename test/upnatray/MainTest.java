package upnatray;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import javax.imageio.ImageIO;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The command line from outside: processes, their output, their files and their exit status. */
class MainTest {

  private static final String SCENE = """
      <image>
        <raster><W>40</W><H>30</H><backgroundColor>0 0 1</backgroundColor></raster>
        <rayTracer><wblock>32</wblock><hblock>32</hblock><showProgress>true</showProgress></rayTracer>
        <engine><illumination>false</illumination><falseLighting>false</falseLighting></engine>
        <camera><position>0 0 5</position><lookAt>0 0 0</lookAt><up>0 1 0</up></camera>
        <projection type="orthographic"><height>3</height><aspect>1.3333</aspect></projection>
        <models><model id="ball" type="sphere"><radius>1</radius></model></models>
        <scene><object><modelId>ball</modelId><color>255 0 0</color></object></scene>
      </image>
      """;

  @TempDir
  Path folder;

  private CommandLine program;

  @BeforeEach
  void start() throws IOException {
    program = new CommandLine(folder);
    Files.writeString(folder.resolve("ball.xml"), SCENE);
    Files.writeString(folder.resolve("bad.xml"), SCENE.replace("<W>40", "<W>0"));
  }

  private BufferedImage picture(final String name) throws IOException {
    return ImageIO.read(folder.resolve(name).toFile());
  }

  private List<String> files(final String name) throws IOException {
    try (Stream<Path> files = Files.list(folder.resolve(name))) {
      return files.map(file -> file.getFileName().toString()).sorted().collect(Collectors.toList());
    }
  }

  @Test
  void aSceneBecomesAPicture() throws Exception {
    assertEquals(new CommandLine.Result(0, "ball.xml -> " + Path.of("images", "ball.png") + "\n", ""),
        program.run("ball.xml"));
    final BufferedImage picture = picture("images/ball.png");
    assertEquals(40, picture.getWidth());
    assertEquals(30, picture.getHeight());
    assertEquals(0xffff0000, picture.getRGB(20, 15));
    assertEquals(0xff0000ff, picture.getRGB(1, 1));
    assertEquals(List.of("ball.png"), files("images"));
  }

  @Test
  void sizeAndPlaceCanBeChosen() throws Exception {
    assertEquals(0, program.run("ball.xml", "--width", "80", "-o", "large.png", "--threads", "1", "--no-window").status());
    assertEquals(60, picture("large.png").getHeight());
  }

  @Test
  void aBadSceneDoesNotStopTheOthers() throws Exception {
    final Path root = folder.getRoot();
    final CommandLine.Result result = program.run("bad.xml", "none.xml", root.toString(), "ball.xml", "-o", "out");
    assertEquals(1, result.status());
    assertEquals("bad.xml:2:14: `W` is out of range: found `0`, expected a whole number, W >= 1\n"
        + "none.xml: there is no such file\n" + root + ": this is a folder, not a scene file\n", result.err());
    assertEquals(List.of("ball.png"), files("out"));
  }

  @Test
  void checkingRendersNothing() throws Exception {
    final CommandLine.Result result = program.run("--check", "ball.xml", "bad.xml");
    assertEquals(1, result.status());
    assertEquals("ball.xml: errors: 0, warnings: 0\nbad.xml: errors: 1, warnings: 0\n", result.out());
    assertFalse(Files.exists(folder.resolve("images")));
    assertEquals(0, program.run("--check", "ball.xml").status());
  }

  @Test
  void checkingTellsOfAPictureThatNoArrayHolds() throws Exception {
    Files.writeString(folder.resolve("vast.xml"), SCENE.replace("<W>40</W>", "<W>70000</W>")
        .replace("<H>30</H>", "<H>70000</H>"));
    final CommandLine.Result result = program.run("--check", "vast.xml");
    assertEquals(1, result.status());
    assertEquals("vast.xml:2:14: an image of 70000 x 70000 pixels is too large: at most 2147483639 pixels are possible\n",
        result.err());
    assertTrue(result.out().startsWith("vast.xml: errors: 1,"), result.out());
  }

  @Test
  void warningsDoNotMatterToTheStatus() throws Exception {
    Files.writeString(folder.resolve("warned.xml"), SCENE.replace("<raster>", "<rooster/><raster>"));
    final CommandLine.Result result = program.run("warned.xml");
    assertEquals(0, result.status());
    assertEquals("warned.xml:2:3: warning: unknown element `rooster` in `image`. Did you mean `raster`?\n", result.err());
  }

  @Test
  void aNameThatDiffersInCaseIsSuggested() throws Exception {
    final CommandLine.Result result = program.run("Ball.xml");
    if (result.status() != 0) {
      assertEquals("Ball.xml: there is no such file. Did you mean `ball.xml`?\n", result.err());
    }
  }

  @Test
  void aNameThatTheLocaleCannotExpress() throws Exception {
    final CommandLine.Result result = program.withLocale("C").run("ball.xml", "-o", "pr\u00e1ctica.png");
    if (result.status() != 0) {
      assertEquals(2, result.status());
      assertTrue(result.err().endsWith("start the program with LC_ALL=C.UTF-8\n"), result.err());
    }
  }

  @Test
  void helpAndVersion() throws Exception {
    final CommandLine.Result help = program.run("--help");
    assertEquals(0, help.status());
    assertTrue(help.out().startsWith("Usage: UPNaTRay [SCENE.xml ...]"));
    assertTrue(help.out().lines().allMatch(line -> line.length() <= 100));
    assertTrue(program.with("-Duser.language=es").run("-h").out().startsWith("Uso: UPNaTRay"));
    assertTrue(program.run("--version").out().startsWith("UPNaTRay "));
  }

  @Test
  void wrongUsage() throws Exception {
    final CommandLine.Result result = program.run("--widht", "3");
    final String message = "UPNaTRay: unknown option --widht; --help shows them all. Did you mean `--width`?\n";
    assertEquals(new CommandLine.Result(2, "", message), result);
  }

  @Test
  void spanishWhereTheLocaleIs() throws Exception {
    final CommandLine.Result result = program.with("-Duser.language=es", "-Dfile.encoding=UTF-8",
        "-Dstderr.encoding=UTF-8").run("bad.xml");
    assertEquals("bad.xml:2:14: `W` está fuera de rango: se encontró `0`, se esperaba un número entero, W >= 1\n",
        result.err());
  }

  @Test
  void withoutArgumentsADefaultSceneIsRendered() throws Exception {
    Files.createDirectories(folder.resolve("scenes"));
    Files.writeString(folder.resolve("scenes/shapes.xml"), SCENE);
    assertEquals(Path.of("scenes", "shapes.xml") + " -> " + Path.of("images", "shapes.png") + "\n", program.run().out());
  }

  @Test
  void tooLargeAnImageIsOneSentence() throws Exception {
    final CommandLine.Result heap = program.with("-Xmx64m").run("ball.xml", "--width", "30000", "--height", "30000");
    assertEquals(1, heap.status());
    assertTrue(heap.err().startsWith("ball.xml: an image of 30000 x 30000 pixels needs 3434 MB of memory"), heap.err());
    assertEquals(1, heap.err().lines().count());
    final CommandLine.Result array = program.run("ball.xml", "--width", "60000", "--height", "60000");
    assertEquals(1, array.status());
    assertEquals(1, array.err().lines().count());
    final StringBuilder mesh = new StringBuilder();
    for (int i = 0; i < 1_500_000; i++) {
      mesh.append("v 1 2 3\n");
    }
    Files.writeString(folder.resolve("m.obj"), mesh);
    Files.writeString(folder.resolve("mesh.xml"),
        SCENE.replace("sphere", "mesh").replace("<radius>1</radius>", "<objFile>m.obj</objFile>"));
    final CommandLine.Result full = program.with("-Xmx16m").run("mesh.xml");
    assertEquals(1, full.status());
    assertTrue(full.err().startsWith("mesh.xml: memory is full: Java may use 16 MB"), full.err());
    assertEquals(1, full.err().lines().count());
  }
}
