package meshes;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

import arguments.Messages;
import diagnostics.Problem;
import diagnostics.SimilarFile;
import diagnostics.UnusualBlank;

/** The problems of a mesh file, in the order in which they are found. */
final class ObjProblems {

  private String file;
  private final List<Problem> found = new ArrayList<>();
  private int errors;
  private boolean blankReported;

  ObjProblems(final String file) {
    this.file = file;
  }

  /** Sets the file of the following problems. */
  void setFile(final String name) {
    file = name;
  }

  List<Problem> all() {
    return found;
  }

  int errors() {
    return errors;
  }

  boolean hasErrors() {
    return errors > 0;
  }

  /** An error at a position of the current line. */
  void error(final ObjText text, final long position, final String key, final Object... parts) {
    error(text, text.line(), position, key, parts);
  }

  /** An error of a line, at a position if it is the current line. */
  void error(final ObjText text, final int line, final long position, final String key, final Object... parts) {
    final int column = line == text.line() ? text.column(Math.max(position, text.lineStart())) : 1;
    add(new Problem(file, line, column, Problem.Severity.ERROR, message(key, parts)));
  }

  /** An error, which is not added: the word at hand is a coordinate that exceeds a limit. */
  Problem large(final ObjText text, final double limit) {
    return new Problem(file, text.line(), text.column(text.bytes.position()), Problem.Severity.ERROR,
        message("coordinateLarge", text.word(), String.format(Locale.ROOT, "%.1e", limit).replace("+", "")));
  }

  void warning(final int line, final String key, final Object... parts) {
    add(new Problem(file, line, 1, Problem.Severity.WARNING, message(key, parts)));
  }

  /** The file does not exist. */
  void missing(final Path path) {
    add(new Problem(file, 0, 0, Problem.Severity.ERROR,
        message("fileMissing") + SimilarFile.question(path, ".obj", ".zip")));
  }

  /** An error of the file as a whole. */
  void whole(final String key, final Object... parts) {
    add(new Problem(file, 1, 1, Problem.Severity.ERROR, message(key, parts)));
  }

  /**
   * A character that only looks like a blank; of the warnings only the first is kept.
   *
   * @param start the text from the current byte on
   * @param at index of the character in it
   */
  void unusualBlank(final ObjText text, final String start, final int at, final boolean warning) {
    if (!warning || !blankReported) {
      add(new Problem(file, text.line(), text.column(text.bytes.position()) + start.codePointCount(0, at),
          warning ? Problem.Severity.WARNING : Problem.Severity.ERROR,
          message("unusualBlank", UnusualBlank.name(start.codePointAt(at)))));
      blankReported |= warning;
    }
  }

  private static String message(final String key, final Object... parts) {
    return Messages.text("meshes." + key, parts);
  }

  void add(final Problem problem) {
    errors += problem.isError() ? 1 : 0;
    found.add(problem);
  }
}
