package scenes;

import static arguments.Arguments.notNull;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

import arguments.Messages;
import diagnostics.Problem;
import diagnostics.SimilarFile;

/**
 * Reads scene files. All problems of a file and of its meshes are found in one run, including values out of range, so
 * that a scene without errors can be rendered. Only a file that is not well-formed XML is read no farther than its first
 * fault.
 *
 * <p>Where readers of the language differ, this one does as follows: values are found at any depth below their section;
 * of repeated values the first counts, of repeated ids the last; names and numbers may have blanks around them; aiming
 * takes the model's axes to the vectors given.
 */
public final class SceneReader {

  /** Size in bytes beyond which a file is not a scene file. */
  static final long LARGEST = 64L << 20;

  private final Path file;
  private final Problems problems;

  private SceneReader(final Path file, final SourceText source) {
    this.file = file;
    this.problems = new Problems(source);
  }

  /**
   * Reads a scene file. Its meshes are looked for in its own directory, then in {@code scenes} under the working
   * directory.
   *
   * @param file the file
   * @return the scene, if it can be rendered, and all problems
   * @throws IllegalArgumentException if the file is null
   */
  public static ReadResult read(final Path file) {
    notNull("file", file);
    try {
      final byte[] bytes = bytes(file);
      if (bytes.length > LARGEST) {
        return unreadable(file, "tooLarge", LARGEST >> 20);
      }
      final Decoding decoding = Decoding.of(bytes);
      final SceneReader reader = new SceneReader(file, new SourceText(file.toString(), decoding.text()));
      if (decoding.warning() != null) {
        reader.problems.warning(0, decoding.warning(), Messages.quote(decoding.encoding()));
      }
      return new ReadResult(Optional.ofNullable(reader.markup()), reader.problems.inFileOrder());
    } catch (final NoSuchFileException missing) {
      final String text = Messages.text("scenes.fileMissing") + SimilarFile.question(file, ".xml");
      return new ReadResult(Optional.empty(), List.of(new Problem(file.toString(), 0, 0, Problem.Severity.ERROR, text)));
    } catch (final AccessDeniedException denied) {
      return unreadable(file, Files.isDirectory(file) ? "fileIsFolder" : "fileDenied");
    } catch (final IOException failure) {
      final String reason = failure.getClass().getSimpleName() + ": " + failure.getMessage();
      return Files.isDirectory(file) ? unreadable(file, "fileIsFolder") : unreadable(file, "unreadable", reason);
    }
  }

  /** The bytes of a file, at most one more than the limit: some files, such as devices, never end. */
  private static byte[] bytes(final Path file) throws IOException {
    try (InputStream in = Files.newInputStream(file)) {
      return in.readNBytes((int) LARGEST + 1);
    }
  }

  private static ReadResult unreadable(final Path file, final String key, final Object... parts) {
    final Problem.Severity severity = Problem.Severity.ERROR;
    final Problem problem = new Problem(file.toString(), 0, 0, severity, Messages.text("scenes." + key, parts));
    return new ReadResult(Optional.empty(), List.of(problem));
  }

  /** Reads the markup, and from it the scene; null if there is an error. */
  private SceneFile markup() {
    final MarkupReader markup = new MarkupReader(problems);
    try {
      final Element root = markup.read();
      final Element image = root.name().equals("image") ? root : root.find("image");
      if (image == null) {
        problems.error(root.offset(), "noImage", Messages.quote(root.name()),
            problems.didYouMean(root.name(), List.of("image")));
        return null;
      }
      final SceneGrammar grammar = new SceneGrammar(problems);
      grammar.check(root);
      return new SceneBuilder(file, image, grammar, new Values(problems, markup.comments())).scene();
    } catch (final XmlSyntaxException fault) {
      problems.add(fault.offset(), new Problem(file.toString(), problems.source().line(fault.offset()),
          problems.source().column(fault.offset()), Problem.Severity.ERROR, fault.getMessage()));
      return null;
    }
  }
}
