package upnatray;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Color;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

import javax.imageio.ImageIO;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import arguments.Messages;

/** No file of the user is overwritten by mistake. */
class TargetsTest {

  private static final String SCENE = """
      <image>
        <raster><W>20</W><H>10</H><backgroundColor>0 0 1</backgroundColor></raster>
        <rayTracer><wblock>32</wblock><hblock>32</hblock><showProgress>true</showProgress></rayTracer>
        <engine><illumination>false</illumination><falseLighting>false</falseLighting></engine>
        <camera><position>0 0 5</position><lookAt>0 0 0</lookAt><up>0 1 0</up></camera>
        <projection type="orthographic"><height>3</height><aspect>2</aspect></projection>
        <models><model id="m" type="mesh"><objFile>MESH</objFile></model></models>
        <scene><object><modelId>m</modelId><color>255 0 0</color></object></scene>
      </image>
      """;
  private static final String MESH = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

  @TempDir
  private Path folder;
  private String output;

  @BeforeEach
  void files() throws IOException {
    Files.writeString(folder.resolve("m.obj"), MESH);
    Files.writeString(folder.resolve("a.xml"), SCENE.replace("MESH", "m.obj"));
    Files.writeString(folder.resolve("b.xml"), SCENE.replace("MESH", "m.obj"));
  }

  /** Runs the command line; each argument that begins with ./ lies in the folder. */
  private int run(final String... args) throws Exception {
    for (int i = 0; i < args.length; i++) {
      args[i] = args[i].startsWith("./") ? folder.resolve(args[i].substring(2)).toString() : args[i];
    }
    final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    final PrintStream stream = new PrintStream(bytes, true, StandardCharsets.UTF_8);
    final Options options = Options.of(args);
    final int status = new Batch(options, stream, stream).run(options.scenes());
    output = bytes.toString(StandardCharsets.UTF_8);
    return status;
  }

  /** The command is refused with this reason, the file stays as it is, and no picture appears. */
  private void assertRefused(final String name, final String key, final String... args) throws Exception {
    final Path file = folder.resolve(name);
    final byte[] before = Files.exists(file) ? Files.readAllBytes(file) : null;
    final List<Path> files = all();
    assertEquals(2, run(args), output);
    final String reason = Messages.text("upnatray." + key, folder.resolve(name.replaceAll("\\.\\w+$", ".png")));
    assertTrue(output.contains(reason), output);
    assertEquals(before == null, !Files.exists(file));
    assertArrayEquals(before, before == null ? null : Files.readAllBytes(file));
    assertEquals(files, all());
  }

  private List<Path> all() throws IOException {
    try (var files = Files.walk(folder)) {
      return files.sorted().toList();
    }
  }

  @Test
  void aFileThatIsNoPngWhateverItsName() throws Exception {
    Files.writeString(folder.resolve("notes.png"), "my notes");
    assertRefused("notes.png", "notPng", "./a.xml", "-o", "./notes.png");
    Files.writeString(folder.resolve("notes"), "my notes");
    assertRefused("notes", "notPng", "./a.xml", "-o", "./notes");
    Files.writeString(folder.resolve("short.png"), "\u0089PNG", StandardCharsets.ISO_8859_1);
    assertRefused("short.png", "notPng", "./a.xml", "-o", "./short.png");
    Files.createFile(folder.resolve("empty.txt"));
    assertRefused("empty.txt", "notPng", "./a.xml", "-o", "./empty.txt");
  }

  @ParameterizedTest
  @ValueSource(strings = {"First.java", "work.xml", "other.obj"})
  void aSourceThatIsThere(final String name) throws Exception {
    Files.writeString(folder.resolve(name), "the work of a week");
    assertRefused(name, "otherFormat", "./a.xml", "-o", "./" + name);
  }

  @Test
  void theSceneItself() throws Exception {
    assertRefused("a.xml", "otherFormat", "./a.xml", "-o", "./a.xml");
    assertRefused("a.xml", "otherFormat", "-o", "./a.xml", "./b.xml");
    Files.move(folder.resolve("a.xml"), folder.resolve("scene"));
    assertRefused("scene", "isInput", "./scene", "-o", "./scene");
    assertThrows(UsageException.class, () -> run("-o", "./a.xml"));
  }

  @Test
  void theSceneThroughALink() throws Exception {
    link("same.png", "a.xml");
    assertRefused("same.png", "isInput", "./a.xml", "-o", "./same.png");
    try {
      Files.createLink(folder.resolve("hard.png"), folder.resolve("a.xml"));
    } catch (final FileSystemException noHardLinks) {
      assumeTrue(false, noHardLinks.toString());
    }
    assertRefused("hard.png", "isInput", "./a.xml", "-o", "./hard.png");
  }

  private void link(final String name, final String target) throws IOException {
    try {
      Files.createSymbolicLink(folder.resolve(name), Path.of(target));
    } catch (final UnsupportedOperationException | FileSystemException noLinks) {
      assumeTrue(false, noLinks.toString());
    }
  }

  /** A ZIP file gives the files in it no keys, as Windows does. */
  @Test
  void filesWithoutKeysAreComparedByTheSystem() throws Exception {
    final java.net.URI zip = java.net.URI.create("jar:" + folder.resolve("files.zip").toUri());
    try (var files = java.nio.file.FileSystems.newFileSystem(zip, java.util.Map.of("create", "true"))) {
      final Path input = Files.writeString(files.getPath("/a.xml"), SCENE), other = files.getPath("/b.xml");
      Files.writeString(other, SCENE);
      final InputFiles inputs = new InputFiles(List.of(input, files.getPath("/missing.xml")));
      assertTrue(inputs.contains(files.getPath("/x/../a.xml").normalize()));
      assertTrue(inputs.contains(input));
      assertFalse(inputs.contains(other));
    }
  }

  /** A mesh that begins as a PNG does can only be one of a test; a texture does so always. */
  @Test
  void aMeshOfTheScene() throws Exception {
    final byte[] mesh = ("\u0089PNG\r\n\u001a\n\n" + MESH).getBytes(StandardCharsets.ISO_8859_1);
    Files.write(folder.resolve("mesh.png"), mesh);
    Files.writeString(folder.resolve("a.xml"), SCENE.replace("MESH", "mesh.png"));
    assertRefused("mesh.png", "isInput", "./a.xml", "-o", "./mesh.png");
    link("link.png", "mesh.png");
    assertRefused("link.png", "isInput", "./a.xml", "-o", "./link.png");
  }

  @Test
  void aMeshOfALaterScene() throws Exception {
    final Path out = Files.createDirectory(folder.resolve("out"));
    Files.write(out.resolve("a.png"), ("\u0089PNG\r\n\u001a\n\n" + MESH).getBytes(StandardCharsets.ISO_8859_1));
    Files.writeString(folder.resolve("b.xml"), SCENE.replace("MESH", "out/a.png"));
    assertRefused("out/a.png", "isInput", "./a.xml", "./b.xml", "-o", "./out");
  }

  @ParameterizedTest
  @ValueSource(strings = {"p.jpg", "p.JPEG", "p.gif", "p.bmp", "p.tif", "p.tiff", "p.webp", "p.ppm", "p.pgm", "p.tga",
      "p.exr", "p.svg", "p.avif"})
  void anotherFormat(final String name) throws Exception {
    assertRefused(name, "otherFormat", "./a.xml", "-o", "./" + name);
  }

  @Test
  void aPngOrNothingIsReplaced() throws Exception {
    for (final String name : List.of("p.png", "p", "p.v2", "P.PNG", "jpg")) {
      assertEquals(0, run("./a.xml", "-o", "./" + name), output);
      assertEquals(0, run("./a.xml", "-o", "./" + name), output);
      assertEquals(20, ImageIO.read(folder.resolve(name).toFile()).getWidth());
    }
    Files.createFile(folder.resolve("empty.png"));
    assertEquals(0, run("./a.xml", "-o", "./empty.png"), output);
  }

  @Test
  void aLinkStaysALink() throws Exception {
    final Path real = Files.createDirectory(folder.resolve("real")).resolve("p.png");
    link("second.png", "real/p.png");
    link("first.png", "second.png");
    for (int i = 0; i < 2; i++) {
      assertEquals(0, run("./a.xml", "-o", "./first.png"), output);
      assertTrue(Files.isSymbolicLink(folder.resolve("first.png")));
      assertTrue(Files.isSymbolicLink(folder.resolve("second.png")));
      assertEquals(20, ImageIO.read(real.toFile()).getWidth());
      assertFalse(Files.isSymbolicLink(real));
    }
    link("loop.png", "loop.png");
    assertEquals(1, run("./a.xml", "-o", "./loop.png"));
    assertTrue(output.contains(Messages.text("upnatray.linkLoop")), output);
  }

  @Test
  void twoScenesForOneFile() throws Exception {
    Files.createDirectory(folder.resolve("q"));
    Files.writeString(folder.resolve("q/a.xml"), SCENE);
    assertThrows(UsageException.class, () -> run("./a.xml", "./q/a.xml", "-o", "./out"));
    Files.createDirectory(folder.resolve("out"));
    link("out/b.png", "a.png");
    assertThrows(UsageException.class, () -> run("./a.xml", "./b.xml", "-o", "./out"));
    assertFalse(Files.exists(folder.resolve("out/a.png")));
    Files.delete(folder.resolve("out/b.png"));
    link("again.xml", "a.xml");
    assertEquals(0, run("./a.xml", "./q/../a.xml", "./again.xml", "-o", "./out"), output);
  }

  @Test
  void oneRefusalStopsAllBeforeTheFirst() throws Exception {
    Files.createDirectory(folder.resolve("out"));
    Files.writeString(folder.resolve("out/b.png"), "my notes");
    assertRefused("out/b.png", "notPng", "./a.xml", "./b.xml", "-o", "./out");
    assertFalse(Files.exists(folder.resolve("out/a.png")));
  }

  @ParameterizedTest
  @ValueSource(strings = {"NUL", "nul.png", "Con.png", "com1.png", "LPT9", "aux.tar.png"})
  void devicesOfWindows(final String name) throws Exception {
    assertThrows(RefusedTargetException.class, () -> new PngTarget(Path.of(name)).checkName(true));
    new PngTarget(Path.of(name)).checkName(false);
    new PngTarget(Path.of("x" + name)).checkName(true);
  }

  /** Below a folder in which nothing can be made, as /proc on Linux is, the message names the folder. */
  @Test
  void aFolderThatTakesNoFileIsNamed() throws Exception {
    final Path system = Path.of("/proc");
    assumeTrue(Files.isDirectory(system) && Files.isWritable(system));
    final Path target = system.resolve("x.png");
    final String message = assertThrows(SaveException.class, () -> PngFile.save(new Image(2, 2, Color.RED), target))
        .getMessage();
    assertEquals(Messages.text("upnatray.notSaved", target, Messages.text("upnatray.noNewFile", system)), message);
  }

  @Test
  void lightWithoutLightsWarns() throws Exception {
    assertEquals(0, run("./a.xml", "-o", "./p.png", "--view", "light"), output);
    assertTrue(output.contains(Messages.text("upnatray.noLight", folder.resolve("a.xml"))), output);
    assertEquals(0, run("./a.xml", "-o", "./p.png"), output);
    assertFalse(output.contains(Messages.text("upnatray.noLight", folder.resolve("a.xml"))), output);
  }

  @Test
  void savingRefusesToo() throws Exception {
    final Path notes = Files.writeString(folder.resolve("notes.png"), "my notes");
    assertThrows(SaveException.class, () -> PngFile.save(new Image(2, 2, Color.RED), notes));
    assertEquals("my notes", Files.readString(notes));
  }
}
