package upnatray;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The launcher in a folder where everything is built, with a Java that prints its arguments. */
class LauncherTest {

  private static final String C1_ONLY = "-XX:TieredStopAtLevel=1";

  @TempDir
  private Path folder;

  @BeforeEach
  void layOut() throws Exception {
    assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "no shell here");
    for (final String directory : List.of("src", "ant", "lib", "nbproject", "dist", "bin")) {
      Files.createDirectory(folder.resolve(directory));
    }
    for (final String file : List.of("build.xml", "ivy.xml", "lib/build.retrieved")) {
      Files.createFile(folder.resolve(file));
    }
    Files.writeString(folder.resolve("nbproject/project.properties"), "a=b\nrun.jvmargs=-Xone -Xtwo\nrun.other=c\n");
    Files.writeString(folder.resolve("small.xml"), "<W>900</W><H> 2999 </H>");
    Files.writeString(folder.resolve("large.xml"), "<W>900</W><H> 3000 </H>");
    Files.writeString(folder.resolve("bin/java"), "#!/bin/sh\nfor word; do echo \"$word\"; done\n");
    assertTrue(folder.resolve("bin/java").toFile().setExecutable(true));
    Files.copy(Path.of("UPNaTRay"), folder.resolve("UPNaTRay"));
    Files.createFile(folder.resolve("dist/UPNaTRay.jar"));
    Files.createFile(folder.resolve("dist/built"));
  }

  private List<String> started(final boolean display, final String... arguments) throws Exception {
    final List<String> command = new ArrayList<>(List.of("/bin/sh", "./UPNaTRay"));
    command.addAll(List.of(arguments));
    final ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true);
    builder.environment().put("JAVA_HOME", folder.toString());
    builder.environment().remove("DISPLAY");
    if (display) {
      builder.environment().put("DISPLAY", ":7");
    }
    final Process process = builder.start();
    final String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), output);
    return output.lines().toList();
  }

  @Test
  void theFlagsOfTheProjectAndAllArgumentsAreHandedOn() throws Exception {
    final String jar = folder.toRealPath().resolve("dist/UPNaTRay.jar").toString();
    assertEquals(List.of("-Xone", "-Xtwo", C1_ONLY, "-XX:CompileThresholdScaling=0.25", "-jar", jar, "small.xml", "-o",
        "a  b.png", ""), started(false, "small.xml", "-o", "a  b.png", ""));
    Files.createFile(folder.resolve("dist/UPNaTRay.jsa"));
    assertTrue(started(false).contains("-XX:SharedArchiveFile=" + jar.replaceFirst("jar$", "jsa")));
  }

  @ParameterizedTest
  @CsvSource({"small.xml, false", "large.xml, true", "small.xml large.xml, true", "small.xml --width 2999, false",
    "small.xml --width 3000, true", "small.xml --height=12345, true", "small.xml --samples 4, false",
    "small.xml --samples 8, true", "small.xml --samples=16, true", "small.xml --samples=1, false", "--window, true",
    "small.xml --turntable=36, true", "small.xml --frames 9, true", "small.xml --rows 1-20, false",
    "--help, false", "'', false"})
  void onlyLongRunsGetTheOptimisingCompiler(final String arguments, final boolean isLong) throws Exception {
    final String[] words = arguments.isEmpty() ? new String[0] : arguments.split(" ");
    assertEquals(isLong, !started(false, words).contains(C1_ONLY));
  }

  @ParameterizedTest
  @CsvSource({"'', true", "small.xml, true", "small.xml -o b.png, false", "small.xml --no-window, false",
    "--check small.xml, false", "small.xml --output=b.png, false"})
  void aWindowIsALongRun(final String arguments, final boolean isLong) throws Exception {
    assumeTrue(!System.getProperty("os.name").contains("Mac"));
    final String[] words = arguments.isEmpty() ? new String[0] : arguments.split(" ");
    assertEquals(isLong, !started(true, words).contains(C1_ONLY));
  }
}
