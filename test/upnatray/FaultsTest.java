package upnatray;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import javax.imageio.ImageIO;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Real faults: a picture appears whole or not at all. */
class FaultsTest {

  /** An old picture, to judge by its first bytes. */
  private static final byte[] OLD = "\u0089PNG\r\n\u001a\nthe old picture".getBytes(StandardCharsets.ISO_8859_1);

  private static final String SCENE = """
      <image>
        <raster><W>300</W><H>300</H><backgroundColor>1 1 1</backgroundColor></raster>
        <rayTracer><wblock>32</wblock><hblock>32</hblock><showProgress>true</showProgress></rayTracer>
        <engine><illumination>false</illumination></engine>
        <camera><position>0 0 5</position><lookAt>0 0 0</lookAt><up>0 1 0</up></camera>
        <projection type="perspective"><fov>40</fov></projection>
        <models><model id="t" type="torus"><rotationalRadius>1</rotationalRadius>
          <circunferenceRadius>0.4</circunferenceRadius></model></models>
        <scene><object><modelId>t</modelId><color>255 0 0</color></object></scene>
      </image>
      """;

  @TempDir
  Path folder;

  private CommandLine program;

  @BeforeEach
  void start() throws IOException {
    program = new CommandLine(folder);
    Files.writeString(folder.resolve("t.xml"), SCENE);
  }

  private static List<Path> leftOver(final Path directory) throws IOException {
    try (Stream<Path> files = Files.list(directory)) {
      return files.filter(file -> file.toString().endsWith(".tmp")).collect(Collectors.toList());
    }
  }

  private void assertFails(final String target, final String reason) throws Exception {
    final CommandLine.Result result = program.run("t.xml", "-o", target);
    assertEquals(1, result.status());
    assertEquals("", result.out());
    assertTrue(result.err().startsWith(target + ": the picture cannot be saved: " + reason), result.err());
    assertEquals(1, result.err().lines().count(), result.err());
  }

  @Test
  void aTargetThatIsNoFile() throws Exception {
    Files.createDirectories(folder.resolve("images/t.png"));
    final CommandLine.Result result = program.run("t.xml");
    assertEquals(1, result.status());
    assertEquals(Path.of("images", "t.png") + ": the picture cannot be saved: there is a folder of this name\n",
        result.err());
    Files.writeString(folder.resolve("file"), "");
    assertFails("file/t.png", "file is not a folder");
    assumeTrue(Files.exists(Path.of("/dev/null")));
    assertFails("/dev/null", "this name belongs to something that is not a regular file");
  }

  @Test
  void aFolderThatMustNotBeWrittenTo() throws Exception {
    final Path readOnly = Files.createDirectory(folder.resolve("r"));
    assumeTrue(readOnly.toFile().setWritable(false) && !Files.isWritable(readOnly), "root may write everywhere");
    assertFails("r/t.png", "no permission to write to r");
  }

  @Test
  void aFileSystemThatIsReadOnlyOrFull() throws Exception {
    final Path disk = Files.createDirectory(folder.resolve("disk"));
    assumeTrue(mount("-t", "tmpfs", "-o", "size=64k", "tmpfs", disk.toString()), "nothing can be mounted here");
    try {
      Files.write(disk.resolve("t.png"), OLD);
      Files.writeString(folder.resolve("large.xml"), SCENE.replace("300", "2000"));
      final CommandLine.Result full = program.run("large.xml", "-o", "disk/t.png");
      assertEquals(1, full.status());
      assertTrue(full.err().startsWith("disk/t.png: the picture cannot be saved: "), full.err());
      assertEquals(1, full.err().lines().count());
      assertArrayEquals(OLD, Files.readAllBytes(disk.resolve("t.png")));
      assertEquals(List.of(), leftOver(disk));
      assertTrue(mount("-o", "remount,ro", disk.toString()));
      assertFails("disk/t.png", "");
      assertArrayEquals(OLD, Files.readAllBytes(disk.resolve("t.png")));
    } finally {
      new ProcessBuilder("umount", disk.toString()).start().waitFor();
    }
  }

  private static boolean mount(final String... args) throws InterruptedException {
    try {
      final List<String> command = Stream.concat(Stream.of("mount"), Stream.of(args)).collect(Collectors.toList());
      return new ProcessBuilder(command).redirectErrorStream(true).start().waitFor() == 0;
    } catch (final IOException noSuchCommand) {
      return false;
    }
  }

  /** Killed at any moment while it overwrites pictures again and again, the program leaves a whole one. */
  @Test
  void killedAtAnyMomentItLeavesAWholePicture() throws Exception {
    assertEquals(0, program.run("t.xml", "-o", "t.png").status());
    final BufferedImage whole = ImageIO.read(folder.resolve("t.png").toFile());
    final String[] again = new String[200];
    Arrays.fill(again, folder.resolve("t.xml").toString());
    final Path out = folder.resolve("images");
    Files.createDirectories(out);
    final Random random = new Random(3);
    for (int i = 0; i < 50; i++) {
      Files.write(out.resolve("t.png"), OLD);
      final Process process = program.with("-XX:TieredStopAtLevel=1").start(again);
      Thread.sleep(250 + random.nextInt(400));
      process.destroyForcibly().waitFor();
      final byte[] left = Files.readAllBytes(out.resolve("t.png"));
      if (!Arrays.equals(OLD, left)) {
        final BufferedImage picture = ImageIO.read(out.resolve("t.png").toFile());
        assertNotNull(picture);
        assertArrayEquals(pixels(whole), pixels(picture));
      }
    }
  }

  private static int[] pixels(final BufferedImage picture) {
    return picture.getRGB(0, 0, picture.getWidth(), picture.getHeight(), null, 0, picture.getWidth());
  }

  @Test
  void interruptedItKeepsWhatIsDone() throws Exception {
    assumeTrue(Files.exists(Path.of("/bin/kill")) || Files.exists(Path.of("/usr/bin/kill")), "no kill here");
    final String object = SCENE.substring(SCENE.indexOf("<object>"), SCENE.indexOf("</scene>"));
    Files.writeString(folder.resolve("slow.xml"), SCENE.replace("300", "1200").replace(object, object.repeat(300)));
    final Process process = program.startInterruptible("slow.xml", "-o", "t.png", "--threads", "1");
    awaitCpu(process, 3);
    final long start = System.nanoTime();
    assertEquals(0, new ProcessBuilder("sh", "-c", "kill -INT " + process.pid()).start().waitFor());
    assertTrue(process.waitFor(30, TimeUnit.SECONDS));
    final double seconds = (System.nanoTime() - start) * 1e-9;
    final CommandLine.Result result = program.end(process);
    assertEquals(130, result.status());
    assertEquals("interrupted: the finished part is in t.partial.png\n", result.err());
    assertFalse(Files.exists(folder.resolve("t.png")));
    assertEquals(List.of(), leftOver(folder));
    final BufferedImage partial = ImageIO.read(folder.resolve("t.partial.png").toFile());
    assertEquals(1200, partial.getWidth());
    assertEquals(0, partial.getRGB(0, 0), "corners are done last");
    assertEquals(0xffff0000, partial.getRGB(600, 600), "the middle is done first");
    assertTrue(seconds < 5, seconds + " s");
  }

  /** Waits until a process has computed for some seconds, however busy the machine is. */
  private static void awaitCpu(final Process process, final int seconds) throws InterruptedException {
    while (process.isAlive() && process.info().totalCpuDuration().orElseThrow().toSeconds() < seconds) {
      Thread.sleep(50);
    }
    assertTrue(process.isAlive(), "it was too fast to be interrupted");
  }

  @Test
  void interruptedBetweenPicturesItJustEnds() throws Exception {
    assumeTrue(Files.exists(Path.of("/bin/kill")) || Files.exists(Path.of("/usr/bin/kill")), "no kill here");
    final String[] many = new String[2000];
    Arrays.fill(many, "t.xml");
    final Process process = program.startInterruptible(many);
    awaitCpu(process, 2);
    assertEquals(0, new ProcessBuilder("sh", "-c", "kill -INT " + process.pid()).start().waitFor());
    final CommandLine.Result result = program.end(process);
    assertEquals(130, result.status());
    assertEquals(List.of(), leftOver(folder.resolve("images")));
    assertNotNull(ImageIO.read(folder.resolve("images/t.png").toFile()));
  }
}
