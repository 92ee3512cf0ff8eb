package handin;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.util.List;

import org.apache.tools.zip.ZipEntry;
import org.apache.tools.zip.ZipOutputStream;

/**
 * A zip whose bytes depend on the contents of its files only: their order is that of their names, and all have one time,
 * that of the assignment's deadline. Ant's zip classes are used because those of the JDK cannot say that a file may be
 * executed.
 */
final class Archive {

  private static final String FOLDER = "upnatray0/";
  private static final LocalDateTime TIME = LocalDateTime.of(2018, 12, 10, 8, 0);
  private static final int FILE = 0100644;
  private static final int PROGRAM = 0100755;

  private final Path project;
  private final List<String> paths;
  private final Path report;

  Archive(final Path project, final List<String> paths, final Path report) {
    this.project = project;
    this.paths = paths;
    this.report = report;
  }

  void write(final Path target) throws IOException {
    try (ZipOutputStream zip = new ZipOutputStream(target.toFile())) {
      zip.setEncoding("UTF-8");
      for (final String path : paths) {
        add(zip, FOLDER + Rules.NAME + "/" + path, project.resolve(path));
      }
      add(zip, FOLDER + "informe.pdf", report);
    }
  }

  private static void add(final ZipOutputStream zip, final String name, final Path file) throws IOException {
    final byte[] bytes = Files.readAllBytes(file);
    final ZipEntry entry = new ZipEntry(name);
    // A zip holds local time: with that of this place the bytes are the same in all places.
    entry.setTime(TIME.atZone(ZoneId.systemDefault()).toInstant().toEpochMilli());
    entry.setUnixMode(isScript(bytes) ? PROGRAM : FILE);
    zip.putNextEntry(entry);
    zip.write(bytes);
    zip.closeEntry();
  }

  /** What is executed are scripts; asking the file system would give something else on Windows. */
  private static boolean isScript(final byte[] bytes) {
    return bytes.length > 2 && bytes[0] == '#' && bytes[1] == '!';
  }
}
