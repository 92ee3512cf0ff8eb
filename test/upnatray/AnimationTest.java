package upnatray;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;

import javax.imageio.ImageIO;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import arguments.Messages;
import rendering.Progress;
import rendering.RenderPass;
import scenes.SceneFile;
import scenes.SceneReader;
import upnatray.PngChunks.Chunk;

/** Animations around a scene: their pictures, what is kept of those that are there, and the animated picture. */
class AnimationTest {

  private static final String SCENE = """
      <image>
        <raster><W>24</W><H>16</H><backgroundColor>20 40 90</backgroundColor></raster>
        <rayTracer><wblock>32</wblock><hblock>32</hblock><showProgress>true</showProgress></rayTracer>
        <engine><illumination>false</illumination><falseLighting>true</falseLighting></engine>
        <camera><position>0 2 5</position><lookAt>0 0.5 0</lookAt><up>0 1 0</up></camera>
        <projection type="perspective"><fov>50</fov><aspect>1.5</aspect></projection>
        <models>
          <model id="m" type="mesh"><objFile>m.obj</objFile></model>
        </models>
        <scene>
          <object><modelId>m</modelId><color>255 90 0</color></object>
        </scene>
      </image>
      """;
  private static final String MESH = "v 0 0 0\nv 1.5 0 0.2\nv 0 2 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

  @TempDir
  private Path folder;
  private String output;

  @BeforeEach
  void files() throws IOException {
    Files.writeString(folder.resolve("m.obj"), MESH);
    Files.writeString(folder.resolve("a.xml"), SCENE);
  }

  /** Runs the command line with a.xml and the picture p.png. */
  private int run(final String... args) throws Exception {
    final List<String> all = new ArrayList<>(List.of(folder.resolve("a.xml").toString(), "-o", file("p.png").toString()));
    all.addAll(List.of(args));
    final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    final PrintStream stream = new PrintStream(bytes, true, StandardCharsets.UTF_8);
    final Options options = Options.of(all.toArray(new String[0]));
    final int status = new Batch(options, stream, stream).run(options.scenes());
    output = bytes.toString(StandardCharsets.UTF_8);
    return status;
  }

  private Path file(final String name) {
    return folder.resolve(name);
  }

  private List<String> pictures() throws IOException {
    try (var files = Files.list(folder)) {
      return files.map(file -> file.getFileName().toString()).filter(name -> name.startsWith("p")).sorted().toList();
    }
  }

  private static int[] pixels(final BufferedImage image) {
    return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
  }

  private int[] pixels(final String name) throws IOException {
    return pixels(ImageIO.read(file(name).toFile()));
  }

  /** Dates files back, so that it is seen whether they are written again. */
  private FileTime old(final String name) throws IOException {
    return Files.getLastModifiedTime(Files.setLastModifiedTime(file(name), FileTime.fromMillis(1_000_000_000_000L)));
  }

  private boolean isRendered(final String name) throws IOException {
    return Files.getLastModifiedTime(file(name)).toMillis() != 1_000_000_000_000L;
  }

  @Test
  void eachPictureIsThatOfACameraTurnedAboutWhatItLooksAt() throws Exception {
    assertEquals(0, run("--turntable", "5", "--samples", "2"), output);
    assertEquals(List.of("p-000.png", "p-001.png", "p-002.png", "p-003.png", "p-004.png", "p.png"), pictures());
    final SceneFile scene = SceneReader.read(file("a.xml")).scene().orElseThrow();
    for (int k = 0; k < 5; k++) {
      final double angle = 2 * Math.PI * k / 5;
      final String turned = SCENE.replace("0 2 5", 5 * Math.sin(angle) + " 2 " + 5 * Math.cos(angle));
      final SceneFile other = SceneReader.read(Files.writeString(file("turned.xml"), turned)).scene().orElseThrow();
      assertEquals(0, scene.camera().turned(360.0 * k / 5).getPosition().distance(other.camera().getPosition()), 1e-5);
      final RenderJob job = RenderJob.of(scene.withCamera(scene.camera().turned(72.0 * k)), RenderPass.COLOUR,
          new Resolution(24, 16, 2, 0, 16), 1);
      job.run(Progress.NONE);
      assertArrayEquals(pixels(job.image()), pixels("p-00" + k + ".png"), "picture " + k);
    }
    assertArrayEquals(pixels("p-000.png"), pixels("p.png"));
    assertNotEquals(Arrays.hashCode(pixels("p-001.png")), Arrays.hashCode(pixels("p-004.png")));
  }

  @Test
  void thePicturesThatAreThereAreKept() throws Exception {
    assertEquals(0, run("--turntable", "4"), output);
    final byte[] animated = Files.readAllBytes(file("p.png"));
    for (int k = 0; k < 4; k++) {
      old("p-00" + k + ".png");
    }
    Files.delete(file("p-001.png"));
    final byte[] third = Files.readAllBytes(file("p-003.png"));
    Files.write(file("p-003.png"), Arrays.copyOf(third, third.length - 1));
    Files.delete(file("p.png"));
    assertEquals(0, run("--turntable", "4"), output);
    assertTrue(isRendered("p-001.png") && isRendered("p-003.png"));
    assertFalse(isRendered("p-000.png") || isRendered("p-002.png"));
    assertArrayEquals(animated, Files.readAllBytes(file("p.png")));
    final String report = Messages.text("upnatray.frames", file("a.xml"), file("p-000.png"), "p-003.png", 4, 2);
    assertTrue(output.contains(report), output);
    assertEquals(0, run("--turntable", "4", "--again"), output);
    assertTrue(isRendered("p-000.png") && isRendered("p-002.png"));
  }

  /** Whatever a picture depends on changes, it is rendered anew; what it does not depend on leaves it alone. */
  @Test
  void aPictureOfAnotherSceneOrSizeIsNotTakenForOne() throws Exception {
    for (final String change : List.of("--width 30", "--view normals", "--samples 2", "--adaptive", "--rows 2-9", "scene",
        "mesh")) {
      assertEquals(0, run("--turntable", "3"), output);
      old("p-002.png");
      if (change.equals("scene")) {
        Files.writeString(file("a.xml"), SCENE.replace("255 90 0", "255 90 9"));
      } else if (change.equals("mesh")) {
        Files.writeString(file("m.obj"), MESH.replace("2 0", "2 1"));
      }
      final List<String> args = new ArrayList<>(List.of("--turntable", "3"));
      args.addAll(change.startsWith("-") ? List.of(change.split(" ")) : List.of());
      assertEquals(0, run(args.toArray(new String[0])), output);
      assertTrue(isRendered("p-002.png"), change);
    }
    old("p-002.png");
    assertEquals(0, run("--turntable", "3", "--threads", "1", "--seconds", "9"), output);
    assertFalse(isRendered("p-002.png"));
  }

  @Test
  void picturesOfTheUserStay() throws Exception {
    PngFile.save(new Image(24, 16, Color.RED), file("p-001.png"));
    final byte[] its = Files.readAllBytes(file("p-001.png"));
    assertEquals(2, run("--turntable", "3"), output);
    assertTrue(output.contains(Messages.text("upnatray.notOfAnimation")), output);
    assertEquals(List.of("p-001.png"), pictures());
    assertArrayEquals(its, Files.readAllBytes(file("p-001.png")));
    assertEquals(0, run("--turntable", "3", "--again"), output);
    Files.writeString(file("p-002.png"), "my notes");
    assertEquals(2, run("--turntable", "3", "--again"), output);
    assertEquals("my notes", Files.readString(file("p-002.png")));
  }

  @Test
  void partsComeTogether() throws Exception {
    assertEquals(0, run("--turntable", "5", "--frames", "3-4"), output);
    assertEquals(List.of("p-003.png", "p-004.png"), pictures());
    assertEquals(0, run("--turntable", "5", "--frames", "0-2"), output);
    assertEquals(5, pictures().size());
    for (int k = 0; k < 5; k++) {
      old("p-00" + k + ".png");
    }
    assertEquals(0, run("--turntable", "5"), output);
    for (int k = 0; k < 5; k++) {
      assertFalse(isRendered("p-00" + k + ".png"));
    }
    assertTrue(Files.exists(file("p.png")));
  }

  @Test
  void namesHaveAsManyDigitsAsTheLast() {
    final Path animated = Path.of("x", "p.PNG");
    assertEquals(Path.of("x", "p-0007.png"), new Turntable(1001, 1, 0, 1000, false).file(animated, 7));
    assertEquals(Path.of("x", "p-999.png"), new Turntable(1000, 1, 0, 999, false).file(animated, 999));
  }

  @Test
  void scenesMustNotShareAPicture() throws Exception {
    final String[] args = {"p/a.xml", "p/a-001.xml", "--turntable", "3", "-o", folder.toString()};
    assertThrows(UsageException.class, () -> Options.of(args));
    args[1] = "p/a-003.xml";
    assertEquals(4, Options.of(args).targets(Path.of("p/a.xml")).size());
  }

  /** The chunks in their order, and the pictures that a reader of animations makes of them. */
  @Test
  void theAnimatedPictureHasThePixelsOfAllPictures() throws Exception {
    assertEquals(0, run("--turntable", "7", "--seconds", "2.5", "--width", "200"), output);
    assertAnimated(7, 2.5);
  }

  /** Some pictures are opaque, so their files have no alpha; others are not. */
  @Test
  void picturesWithAlphaAndWithoutMakeOneAnimation() throws Exception {
    final List<Path> files = new ArrayList<>();
    for (int k = 0; k < 4; k++) {
      final Image image = new Image(9, 5, Color.ORANGE);
      image.setRGB(k, 2, k % 2 == 0 ? 0xff123456 : 0x30fedcba);
      files.add(file("p-00" + k + ".png"));
      PngFile.save(image, files.get(k));
    }
    PngFile.save(file("p.png"), out -> AnimatedPng.write(files, 60, out));
    assertAnimated(4, 60);
    PngFile.save(file("p.png"), out -> AnimatedPng.write(files, 200_000, out));
    assertAnimated(4, 200_000);
  }

  private void assertAnimated(final int N, final double seconds) throws IOException {
    final List<ByteArrayOutputStream> data = new ArrayList<>();
    Chunk header = null;
    int sequence = 0;
    double shown = 0;
    final PngChunks chunks = new PngChunks(new ByteArrayInputStream(Files.readAllBytes(file("p.png"))));
    final StringBuilder types = new StringBuilder();
    for (Chunk chunk = chunks.next(); chunk != null; chunk = chunks.next()) {
      types.append(types.toString().endsWith(chunk.type()) ? "" : " " + chunk.type());
      final ByteBuffer bytes = ByteBuffer.wrap(chunk.data());
      switch (chunk.type()) {
        case "IHDR" -> header = chunk;
        case "acTL" -> assertEquals(N + " 0", bytes.getInt() + " " + bytes.getInt());
        case "fcTL" -> {
          assertEquals(sequence++, bytes.getInt());
          assertEquals(ByteBuffer.wrap(header.data()).getLong(), bytes.getLong());
          assertEquals(0, bytes.getLong());
          shown += (bytes.getShort() & 0xffff) / (double) (bytes.getShort() & 0xffff);
          assertEquals(0, bytes.getShort());
          data.add(new ByteArrayOutputStream());
        }
        case "IDAT" -> data.get(data.size() - 1).write(chunk.data());
        case "fdAT" -> {
          assertEquals(sequence++, bytes.getInt());
          data.get(data.size() - 1).write(chunk.data(), 4, chunk.data().length - 4);
        }
        default -> assertEquals("IEND", chunk.type());
      }
    }
    assertEquals(" IHDR acTL fcTL IDAT" + " fcTL fdAT".repeat(N - 1) + " IEND", types.toString());
    assertEquals(seconds, shown, seconds * 1e-3);
    for (int k = 0; k < N; k++) {
      final ByteArrayOutputStream png = new ByteArrayOutputStream();
      png.write(PngChunks.SIGNATURE);
      header.writeTo(png);
      new Chunk("IDAT", data.get(k).toByteArray()).writeTo(png);
      new Chunk("IEND", new byte[0]).writeTo(png);
      assertArrayEquals(pixels("p-00" + k + ".png"), pixels(ImageIO.read(new ByteArrayInputStream(png.toByteArray()))));
    }
  }

  /** Ctrl-C leaves whole pictures; the same command goes on. */
  @Test
  void anInterruptionLeavesWholePictures() throws Exception {
    final String[] args = {"a.xml", "-o", "p.png", "--turntable", "400", "--width", "600"};
    final Process process = new CommandLine(folder).startInterruptible(args);
    for (int i = 0; i < 600 && !Files.exists(file("p-002.png")); i++) {
      TimeUnit.MILLISECONDS.sleep(50);
    }
    new ProcessBuilder("kill", "-INT", Long.toString(process.pid())).start().waitFor();
    final CommandLine.Result result = new CommandLine(folder).end(process);
    assertEquals(130, result.status(), result.err());
    final List<String> left = pictures();
    assertTrue(left.size() >= 3 && left.size() < 400, left.toString());
    for (int k = 0; k < left.size(); k++) {
      assertEquals(String.format("p-%03d.png", k), left.get(k));
      assertEquals(600, ImageIO.read(file(left.get(k)).toFile()).getWidth());
    }
    assertTrue(result.err().contains(left.size() + " of 400 pictures are complete"), result.err());
  }
}
