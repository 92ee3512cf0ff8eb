package upnatray;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.jar.Attributes;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.zip.ZipEntry;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The jar of the program without the jars that it needs. */
class LibrariesTest {

  private static final Path CLASSES = Path.of("build", "classes");

  @TempDir
  private Path folder;

  private Path jar() throws IOException {
    final Path jar = Files.createDirectory(folder.resolve("dist")).resolve("UPNaTRay.jar");
    final Manifest manifest = new Manifest();
    manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
    manifest.getMainAttributes().put(Attributes.Name.MAIN_CLASS, "upnatray.Main");
    manifest.getMainAttributes().put(Attributes.Name.CLASS_PATH, "../lib/vecmath.jar ../lib/other.jar");
    try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar), manifest);
        var classes = Files.walk(CLASSES)) {
      for (final Path file : classes.filter(Files::isRegularFile).toList()) {
        out.putNextEntry(new ZipEntry(CLASSES.relativize(file).toString().replace(File.separatorChar, '/')));
        Files.copy(file, out);
      }
    }
    return jar;
  }

  private String started(final Path jar, final String... args) throws Exception {
    final List<String> command = new java.util.ArrayList<>(List.of(
        Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-Djava.awt.headless=true",
        "-Duser.language=en", "-jar", jar.toString()));
    command.addAll(List.of(args));
    final Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8) + process.waitFor();
  }

  @Test
  void oneSentenceNamesTheMissingFile() throws Exception {
    final Path jar = jar();
    final Path library = folder.toRealPath().resolve("lib").resolve("vecmath.jar");
    final String scene = Path.of("scenes", "shapes.xml").toAbsolutePath().toString();
    final String expected = "UPNaTRay: a file that the program needs is missing: " + library;
    for (final String last : List.of("--no-window", "--check", "--window")) {
      assertEquals(expected + System.lineSeparator() + "1", started(jar, scene, last));
    }
    assertTrue(started(jar, "--help").startsWith("Usage:"));
  }

  @Test
  void whatIsThereIsNotMissing() throws IOException {
    final Path jar = jar();
    final Path lib = Files.createDirectory(folder.resolve("lib"));
    Files.createFile(lib.resolve("vecmath.jar"));
    assertEquals(Optional.of(lib.resolve("other.jar")), Libraries.missing(jar));
    Files.createFile(lib.resolve("other.jar"));
    assertEquals(Optional.empty(), Libraries.missing(jar));
    assertEquals(Optional.empty(), Libraries.missing(CLASSES));
  }
}
