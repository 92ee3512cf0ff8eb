package meshes;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.regex.Pattern;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipFile;
import java.util.zip.ZipInputStream;

/**
 * The mesh of a ZIP file: its first entry, or, if that is not a mesh, the first whose name ends in {@code .obj}. Folders
 * and the companion files that macOS adds do not count.
 *
 * @param name the name of the entry
 * @param stream its bytes
 */
record ZippedMesh(String name, InputStream stream) {

  /** Length of the signature of a ZIP file. */
  static final int MARK = 4;

  /** Limit of the unpacked size in bytes: a larger file is more likely a ZIP bomb than a mesh. */
  static final long LARGEST = 1L << 30;

  /** Number of bytes at the start of an entry of another name that show whether it is a mesh. */
  private static final int START = 1 << 16;
  private static final Pattern VERTEX = Pattern.compile("(?m)^\\s*v\\s+[-+.\\d]");

  /** Whether a file of these first bytes is a ZIP file. */
  static boolean isZip(final byte[] start) {
    return start.length == MARK && start[0] == 'P' && start[1] == 'K' && start[2] == 3 && start[3] == 4;
  }

  /** Opens the entry that is the mesh, or the first if there is none; null if there is no entry at all. */
  static ZippedMesh open(final Path file) throws IOException {
    final ZippedMesh first = first(file);
    if (first == null || isNamedMesh(first.name)) {
      return first;
    }
    boolean isMesh = false;
    try (InputStream start = first.stream) {
      isMesh = VERTEX.matcher(new String(start.readNBytes(START), StandardCharsets.ISO_8859_1)).find();
    }
    final ZippedMesh named = isMesh ? null : named(file);
    return named == null ? first(file) : named;
  }

  private static boolean isNamedMesh(final String name) {
    return name.toLowerCase(Locale.ROOT).endsWith(".obj");
  }

  private static ZippedMesh first(final Path file) throws IOException {
    final ZipInputStream zip = new ZipInputStream(Files.newInputStream(file));
    boolean found = false;
    try {
      ZipEntry entry = zip.getNextEntry();
      while (entry != null && !counts(entry)) {
        entry = zip.getNextEntry();
      }
      found = entry != null;
      return found ? new ZippedMesh(entry.getName(), zip) : null;
    } catch (final IllegalArgumentException badName) {
      throw new ZipException(badName.getMessage());
    } finally {
      if (!found) {
        zip.close();
      }
    }
  }

  /** The first entry named as a mesh, by the directory at the end of the file: nothing before it is unpacked. */
  private static ZippedMesh named(final Path file) throws IOException {
    final ZipFile zip;
    try {
      zip = new ZipFile(file.toFile());
    } catch (final IOException noDirectory) {
      return null;
    }
    final ZipEntry found = zip.stream().filter(entry -> counts(entry) && isNamedMesh(entry.getName()))
        .findFirst().orElse(null);
    final InputStream stream = found == null ? null : zip.getInputStream(found);
    if (stream == null) {
      zip.close();
      return null;
    }
    return new ZippedMesh(found.getName(), new FilterInputStream(stream) {
      @Override
      public void close() throws IOException {
        zip.close();
      }
    });
  }

  private static boolean counts(final ZipEntry entry) {
    final String name = entry.getName();
    return !entry.isDirectory() && !name.startsWith("__MACOSX/")
        && !name.substring(name.lastIndexOf('/') + 1).startsWith("._");
  }
}
