package meshes;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipInputStream;

/** The first file of a ZIP file, which is a mesh; what follows, such as folders that some systems add, is not looked at. */
final class ZippedMesh {

  /** More than this, in bytes, is not unpacked: a file that hides as much is more likely a trap than a mesh. */
  static final long LARGEST = 1L << 30;

  private ZippedMesh() {
  }

  /** Opens the first entry that is not a folder; null if there is none. */
  static InputStream open(final Path file) throws IOException {
    final ZipInputStream zip = new ZipInputStream(Files.newInputStream(file));
    boolean found = false;
    try {
      ZipEntry entry = zip.getNextEntry();
      while (entry != null && entry.isDirectory()) {
        entry = zip.getNextEntry();
      }
      found = entry != null;
      return found ? zip : null;
    } catch (final IllegalArgumentException badName) {
      throw new ZipException(badName.getMessage());
    } finally {
      if (!found) {
        zip.close();
      }
    }
  }
}
