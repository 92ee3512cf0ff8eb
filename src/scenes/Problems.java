package scenes;

import java.util.ArrayList;
import java.util.List;

/** The problems of one scene file and of its meshes, collected in any order and answered in that of the file. */
final class Problems {

  private final SourceText source;
  private final List<Problem> found = new ArrayList<>();
  private final List<Integer> offsets = new ArrayList<>();
  private int errors;

  Problems(final SourceText source) {
    this.source = source;
  }

  SourceText source() {
    return source;
  }

  void error(final int offset, final String key, final Object... parts) {
    add(offset, at(offset, Problem.Severity.ERROR, Messages.text(key, parts)));
  }

  void warning(final int offset, final String key, final Object... parts) {
    add(offset, at(offset, Problem.Severity.WARNING, Messages.text(key, parts)));
  }

  /** Adds a problem, perhaps one of another file, that is to be told at a place of this file. */
  void add(final int offset, final Problem problem) {
    int i = found.size();
    while (i > 0 && offsets.get(i - 1) > offset) {
      i--;
    }
    found.add(i, problem);
    offsets.add(i, offset);
    errors += problem.isError() ? 1 : 0;
  }

  private Problem at(final int offset, final Problem.Severity severity, final String message) {
    return new Problem(source.file(), source.line(offset), source.column(offset), severity, message);
  }

  boolean hasErrors() {
    return errors > 0;
  }

  int errors() {
    return errors;
  }

  List<Problem> inFileOrder() {
    return List.copyOf(found);
  }
}
