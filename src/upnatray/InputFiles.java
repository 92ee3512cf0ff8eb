package upnatray;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** The input files of pictures, whatever names lead to them. */
final class InputFiles {

  private final Set<FileIdentity> identities = new HashSet<>();
  /** Files on file systems without file keys, as on Windows: only the system itself can compare them. */
  private final List<Path> withoutKey = new ArrayList<>();

  /** A set of files; names that lead nowhere are ignored. */
  InputFiles(final Collection<Path> files) {
    for (final Path file : files) {
      try {
        identities.add(FileIdentity.of(file));
        if (Files.readAttributes(file, BasicFileAttributes.class).fileKey() == null) {
          withoutKey.add(file);
        }
      } catch (final IOException missing) {
        continue;
      }
    }
  }

  /**
   * Whether a file is one of them.
   *
   * @throws IOException if the file's name leads nowhere, such as a link to itself
   */
  boolean contains(final Path file) throws IOException {
    if (identities.contains(FileIdentity.of(file))) {
      return true;
    }
    for (final Path input : withoutKey) {
      if (Files.exists(file) && Files.isSameFile(file, input)) {
        return true;
      }
    }
    return false;
  }
}
