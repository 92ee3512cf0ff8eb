package handin;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.logging.Level;
import java.util.logging.Logger;

/** Makes the zip of the hand-in, or reports every rule that is broken. */
public final class HandIn {

  private static final int BROKEN = 1;
  /** Warns of fonts that it can read all the same. Kept in a field, for otherwise its level would be forgotten. */
  private static final Logger PDFBOX = Logger.getLogger("org.apache.pdfbox");

  private HandIn() {
  }

  /**
   * Checks and zips.
   *
   * @param arguments the project's folder; a file with the paths in it that are handed in, a path a line; the report; the
   *     zip to be made
   * @throws IOException if a file cannot be read or written
   */
  public static void main(final String... arguments) throws IOException {
    PDFBOX.setLevel(Level.SEVERE);
    final Path project = Path.of(arguments[0]);
    final List<String> paths = Files.readAllLines(Path.of(arguments[1])).stream().filter(path -> !path.isBlank())
        .map(path -> path.replace('\\', '/')).sorted().toList();
    final Path report = Path.of(arguments[2]);
    final Path zip = Path.of(arguments[3]);
    final List<String> broken = new Rules(project, paths, report).broken();
    if (!broken.isEmpty()) {
      Files.deleteIfExists(zip);
      broken.forEach(rule -> System.err.println("Broken rule: " + rule));
      System.exit(BROKEN);
    }
    new Archive(project, paths, report).write(zip);
    System.out.println(zip.getFileName() + ": " + (paths.size() + 1) + " files, " + Files.size(zip) + " bytes");
  }
}
