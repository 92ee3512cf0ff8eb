package diagnostics;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.Normalizer;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

import arguments.Messages;

/**
 * Finds the existing file that was probably meant by the name of a missing one: one that differs in case, in the Unicode
 * normal form of accents or in its ending only, or else by a typing error.
 */
public final class SimilarFile {

  /** Larger folders are not searched. */
  private static final int MOST = 1000;

  private SimilarFile() {
  }

  /**
   * The end of a message about a missing file: a full stop and the question whether another was meant. A folder in its place
   * is not missing: whoever wrote its name meant it.
   *
   * @param missing the file
   * @param endings acceptable endings in lower case, such as {@code .xml}
   * @return the text to be appended; empty if no file is similar
   */
  public static String question(final Path missing, final String... endings) {
    final Path similar = of(missing, endings);
    if (similar == null) {
      return "";
    }
    final boolean looksEqual = nfc(similar.toString()).equals(nfc(missing.toString()));
    return ". " + Messages.text(looksEqual ? "diagnostics.otherForm" : "diagnostics.didYouMean", similar);
  }

  private static Path of(final Path missing, final String... endings) {
    final Path folder = folder(missing.getParent());
    if (folder == null || missing.getFileName() == null || Files.isDirectory(missing)) {
      return null;
    }
    final String name = missing.getFileName().toString();
    final List<String> names = names(folder);
    names.removeIf(other -> !Files.isRegularFile(folder.resolve(other)));
    String similar = sameLetters(name, names);
    names.removeIf(other -> Stream.of(endings).noneMatch(folded(other)::endsWith));
    if (similar == null) {
      similar = names.stream().filter(other -> stem(folded(other)).equals(stem(folded(name)))).findFirst().orElse(null);
    }
    if (similar == null) {
      similar = Suggestion.of(name, names);
    }
    return similar == null ? null : missing.getParent() == null ? Path.of(similar) : folder.resolve(similar);
  }

  /** A folder itself if it exists, or else one that differs only in case or normal form; null if none. */
  private static Path folder(final Path folder) {
    if (folder == null) {
      return Path.of("");
    }
    if (Files.isDirectory(folder) || folder.getFileName() == null) {
      return folder;
    }
    final Path above = folder(folder.getParent());
    final String name = above == null ? null : sameLetters(folder.getFileName().toString(), names(above));
    return name == null ? null : above.resolve(name);
  }

  private static String sameLetters(final String name, final List<String> names) {
    return names.stream().filter(other -> folded(other).equals(folded(name))).findFirst().orElse(null);
  }

  private static List<String> names(final Path folder) {
    try (Stream<Path> files = Files.list(folder)) {
      final List<String> names = new ArrayList<>();
      files.limit(MOST + 1).forEach(file -> names.add(file.getFileName().toString()));
      names.sort(null);
      return names.size() > MOST ? new ArrayList<>() : names;
    } catch (final IOException | UncheckedIOException unreadable) {
      return new ArrayList<>();
    }
  }

  private static String stem(final String name) {
    return name.lastIndexOf('.') < 1 ? name : name.substring(0, name.lastIndexOf('.'));
  }

  private static String nfc(final String name) {
    return Normalizer.normalize(name, Normalizer.Form.NFC);
  }

  private static String folded(final String name) {
    return nfc(name).toLowerCase(Locale.ROOT);
  }
}
