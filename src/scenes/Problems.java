package scenes;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;

import arguments.Messages;
import diagnostics.Problem;
import diagnostics.Suggestion;

/** The problems of one scene file and of its meshes, collected in any order and answered in that of the file. */
final class Problems {

  /** More than that nobody reads; and of a file that is made of problems each would cost some time. */
  static final int MOST = 1000;

  private record Placed(int offset, Problem problem) {
  }

  private final SourceText source;
  private final List<Placed> found = new ArrayList<>();
  private int errors;
  private int untold;
  private int firstUntold;

  Problems(final SourceText source) {
    this.source = source;
  }

  SourceText source() {
    return source;
  }

  void error(final int offset, final String key, final Object... parts) {
    add(offset, Problem.Severity.ERROR, key, parts);
  }

  void warning(final int offset, final String key, final Object... parts) {
    add(offset, Problem.Severity.WARNING, key, parts);
  }

  private void add(final int offset, final Problem.Severity severity, final String key, final Object... parts) {
    if (isFull()) {
      count(offset, severity == Problem.Severity.ERROR);
    } else {
      add(offset, at(offset, severity, Messages.text("scenes." + key, parts)));
    }
  }

  /** Adds a problem, perhaps one of another file, that is to be told at a place of this file. */
  void add(final int offset, final Problem problem) {
    if (isFull()) {
      count(offset, problem.isError());
    } else {
      found.add(new Placed(offset, problem));
      errors += problem.isError() ? 1 : 0;
    }
  }

  private void count(final int offset, final boolean isError) {
    firstUntold = untold == 0 ? offset : firstUntold;
    untold++;
    errors += isError ? 1 : 0;
  }

  private Problem at(final int offset, final Problem.Severity severity, final String message) {
    return new Problem(source.file(), source.line(offset), source.column(offset), severity, message);
  }

  /** Whether no more problems are told. */
  boolean isFull() {
    return found.size() >= MOST;
  }

  /** The question whether one of the known names was meant, as long as problems are told. */
  String didYouMean(final String name, final Collection<String> known) {
    return isFull() ? "" : Suggestion.question(name, known);
  }

  boolean hasErrors() {
    return errors > 0;
  }

  int errors() {
    return errors;
  }

  /** The problems; those that are too many are told in one more, the last. */
  List<Problem> inFileOrder() {
    final List<Problem> problems = found.stream().sorted(Comparator.comparingInt(Placed::offset)).map(Placed::problem)
        .collect(Collectors.toList());
    if (untold > 0) {
      problems.add(at(firstUntold, hasErrors() ? Problem.Severity.ERROR : Problem.Severity.WARNING,
          Messages.text("scenes.untold", untold)));
    }
    return problems;
  }
}
