package documentation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;

/** Sources of examples, compiled as strictly as those of the project, against its classes and tests. */
final class Compilation {

  private static final String CLASS_PATH = Stream.of(System.getProperty("java.class.path").split(File.pathSeparator))
      .map(entry -> Path.of(entry).toAbsolutePath().toString()).collect(Collectors.joining(File.pathSeparator));

  private final Path folder;
  private final List<Path> sources = new ArrayList<>();

  /** The sources and the classes are written into a folder. */
  Compilation(final Path folder) {
    this.folder = folder;
  }

  Compilation add(final String file, final String source) throws IOException {
    final Path path = folder.resolve(file);
    Files.createDirectories(path.getParent());
    sources.add(Files.writeString(path, source));
    return this;
  }

  void succeeds() {
    final JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    final StringWriter messages = new StringWriter();
    final boolean compiled = compiler.getTask(messages, null, null,
        List.of("-Xlint:all", "-Werror", "-proc:none", "--release", "17", "-cp", CLASS_PATH, "-d", folder.toString()), null,
        compiler.getStandardFileManager(null, null, null).getJavaFileObjectsFromPaths(sources)).call();
    assertTrue(compiled, messages::toString);
  }

  /** Runs a class of it in the folder, in a virtual machine of its own, and returns what it printed. */
  String run(final String... classAndArguments) throws IOException, InterruptedException {
    final Path output = folder.resolve("output");
    final List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
        "-ea", "-Djava.awt.headless=true", "-cp", folder + File.pathSeparator + CLASS_PATH));
    command.addAll(List.of(classAndArguments));
    final Process program = new ProcessBuilder(command)
        .directory(folder.toFile()).redirectErrorStream(true).redirectOutput(output.toFile()).start();
    try {
      assertTrue(program.waitFor(2, TimeUnit.MINUTES), "it does not end");
    } finally {
      program.destroyForcibly();
    }
    final String printed = Files.readString(output);
    assertEquals(0, program.exitValue(), printed);
    return printed;
  }
}
