package upnatray;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.text.Normalizer;
import java.util.Locale;

/**
 * The file that a name leads to, through symbolic links and whatever its spelling: two names lead to the same file if and
 * only if their identities are equal. The file need not exist.
 */
record FileIdentity(Object key) {

  /** More links in a row than any file system follows. */
  private static final int MOST_LINKS = 40;

  /** Written out, as is hashCode: the generated ones of a record take 50 ms when first called. */
  @Override
  public boolean equals(final Object other) {
    return other instanceof FileIdentity identity && key.equals(identity.key);
  }

  @Override
  public int hashCode() {
    return key.hashCode();
  }

  /**
   * The identity of a file.
   *
   * @throws IOException if the name leads nowhere, such as a link to itself
   */
  static FileIdentity of(final Path file) throws IOException {
    final Path place = place(file);
    try {
      final Object key = Files.readAttributes(place, BasicFileAttributes.class).fileKey();
      return new FileIdentity(key == null ? place.toRealPath() : key);
    } catch (final NoSuchFileException missing) {
      return new FileIdentity(missing(place));
    }
  }

  /**
   * Where a file is, or would be, once the symbolic links at the end of its name are followed.
   *
   * @throws IOException if there are too many of them
   */
  static Path place(final Path file) throws IOException {
    Path place = file;
    for (int i = 0; Files.isSymbolicLink(place); i++) {
      if (i == MOST_LINKS) {
        throw new java.nio.file.FileSystemLoopException(file.toString());
      }
      place = place.resolveSibling(Files.readSymbolicLink(place));
    }
    return place;
  }

  /** The path of a file that does not exist, below the nearest folder that does. */
  private static Path missing(final Path place) throws IOException {
    Path folder = place.toAbsolutePath().normalize();
    Path rest = place.getFileSystem().getPath("");
    while (folder.getParent() != null && !Files.exists(folder)) {
      rest = folder.getFileName().resolve(rest);
      folder = folder.getParent();
    }
    final Path real = folder.toRealPath();
    return ignoresCase(real) ? real.resolve(folded(rest.toString())) : real.resolve(rest);
  }

  /** Whether a folder is found under its name in other case, as on Windows and macOS. */
  private static boolean ignoresCase(final Path folder) throws IOException {
    final String name = folder.toString();
    final Path upper = folder.getFileSystem().getPath(name.toUpperCase(Locale.ROOT));
    final Path lower = folder.getFileSystem().getPath(name.toLowerCase(Locale.ROOT));
    return !upper.toString().equals(lower.toString()) && Files.exists(upper) && Files.exists(lower)
        && Files.isSameFile(upper, lower);
  }

  private static String folded(final String name) {
    return Normalizer.normalize(name, Normalizer.Form.NFC).toLowerCase(Locale.ROOT);
  }
}
