package upnatray;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** Runs the program as a process, as a user does. */
final class CommandLine {

  /**
   * The result of a process.
   *
   * @param status its exit status
   * @param out what it wrote to the standard output
   * @param err what it wrote to the standard error
   */
  record Result(int status, String out, String err) {
  }

  private final Path folder;
  private final List<String> flags = new ArrayList<>();
  private String locale;

  /** The program in a working directory. */
  CommandLine(final Path folder) {
    this.folder = folder;
  }

  /** The same with more flags for the virtual machine. */
  CommandLine with(final String... more) {
    final CommandLine other = new CommandLine(folder);
    other.flags.addAll(flags);
    other.flags.addAll(List.of(more));
    return other;
  }

  /** The same with a value of the environment variable LC_ALL. */
  CommandLine withLocale(final String locale) {
    final CommandLine other = with();
    other.locale = locale;
    return other;
  }

  /**
   * Starts the program so that an interruption reaches it. NetBeans ignores interruptions, as does everything that a
   * shell starts in the background, and their child processes inherit that.
   */
  Process startInterruptible(final String... args) throws IOException, InterruptedException {
    final List<String> hearing = List.of("env", "--default-signal=INT");
    return start(works(hearing, "true") ? hearing : List.of(), args);
  }

  private static boolean works(final List<String> prefix, final String program) throws InterruptedException {
    final List<String> command = new ArrayList<>(prefix);
    command.add(program);
    try {
      return new ProcessBuilder(command).start().waitFor() == 0;
    } catch (final IOException missing) {
      return false;
    }
  }

  Process start(final String... args) throws IOException {
    return start(List.of(), args);
  }

  private Process start(final List<String> prefix, final String... args) throws IOException {
    final List<String> command = new ArrayList<>(prefix);
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-Djava.awt.headless=true", "-Duser.language=en", "-Duser.country=US", "-cp", classPath()));
    command.addAll(flags);
    command.add("upnatray.Main");
    command.addAll(List.of(args));
    final ProcessBuilder builder = new ProcessBuilder(command);
    if (locale != null) {
      builder.environment().put("LC_ALL", locale);
    }
    return builder.directory(folder.toFile()).redirectOutput(folder.resolve("out.txt").toFile())
        .redirectError(folder.resolve("err.txt").toFile()).start();
  }

  /** The class path of the tests, from whatever directory. */
  private static String classPath() {
    final StringBuilder path = new StringBuilder();
    for (final String entry : System.getProperty("java.class.path").split(File.pathSeparator)) {
      path.append(path.length() == 0 ? "" : File.pathSeparator).append(Path.of(entry).toAbsolutePath());
    }
    return path.toString();
  }

  Result run(final String... args) throws IOException, InterruptedException {
    return end(start(args));
  }

  /** Waits for the end of a process. */
  Result end(final Process process) throws IOException, InterruptedException {
    if (!process.waitFor(60, TimeUnit.SECONDS)) {
      process.destroyForcibly();
      throw new AssertionError("no end after a minute");
    }
    return new Result(process.exitValue(), Files.readString(folder.resolve("out.txt")),
        Files.readString(folder.resolve("err.txt")));
  }
}
