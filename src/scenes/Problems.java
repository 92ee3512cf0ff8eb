package scenes;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

import arguments.Messages;
import diagnostics.Problem;
import diagnostics.Suggestion;

/**
 * The problems of one scene file and of its meshes, collected in any order and returned in that of the file. A warning that
 * repeats is given a few times; the rest are counted.
 */
final class Problems {

  /** Reporting stops here: nobody reads more, and in a file full of problems each one would cost time. */
  static final int MOST = 1000;

  /** How many warnings of one kind are reported. */
  static final int LIKE_WARNINGS = 10;

  /** Kinds of warnings whose first part quotes the file and does not distinguish kinds. */
  private static final Set<String> OF_ONE_KIND = Set.of("strayText", "backslash");

  private record Placed(int offset, Problem problem) {
  }

  /** Warnings of one kind: their number, and the first that was not reported. */
  private static final class Kind {
    private int count;
    private int offset;
    private String message;
  }

  private final SourceText source;
  private final List<Placed> found = new ArrayList<>();
  private final Map<String, Kind> kinds = new HashMap<>();
  private int errors;
  private int omitted;
  private int firstOmitted;

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
    if (isFull()) {
      omit(offset);
      return;
    }
    final Kind kind = kinds.computeIfAbsent(parts.length == 0 || OF_ONE_KIND.contains(key) ? key : key + ' ' + parts[0],
        name -> new Kind());
    kind.count++;
    if (kind.count <= LIKE_WARNINGS) {
      add(offset, Problem.Severity.WARNING, key, parts);
    } else if (kind.count == LIKE_WARNINGS + 1) {
      kind.offset = offset;
      kind.message = Messages.text("scenes." + key, parts);
    }
  }

  private void add(final int offset, final Problem.Severity severity, final String key, final Object... parts) {
    if (isFull()) {
      errors += severity == Problem.Severity.ERROR ? 1 : 0;
      omit(offset);
    } else {
      add(offset, at(offset, severity, Messages.text("scenes." + key, parts)));
    }
  }

  /** Adds a problem, possibly of another file, to be reported at a place of this file. */
  void add(final int offset, final Problem problem) {
    errors += problem.isError() ? 1 : 0;
    if (isFull()) {
      omit(offset);
    } else {
      found.add(new Placed(offset, problem));
    }
  }

  private void omit(final int offset) {
    firstOmitted = omitted == 0 ? offset : firstOmitted;
    omitted++;
  }

  private Problem at(final int offset, final Problem.Severity severity, final String message) {
    return new Problem(source.file(), source.line(offset), source.column(offset), severity, message);
  }

  /** Whether the limit is reached. */
  boolean isFull() {
    return found.size() >= MOST;
  }

  /** The question whether one of the known names was meant; empty if none is near, or if the limit is reached. */
  String didYouMean(final String name, final Collection<String> known) {
    return isFull() ? "" : Suggestion.question(name, known);
  }

  boolean hasErrors() {
    return errors > 0;
  }

  int errors() {
    return errors;
  }

  /**
   * The problems in the order of the file. Of the warnings that are only counted, there is one for each kind, at the place
   * of the first of them; if the limit of all problems was exceeded, a last one gives the number left out.
   */
  List<Problem> inFileOrder() {
    final List<Problem> problems = new ArrayList<>();
    if (found.isEmpty()) {
      return problems;
    }
    final List<Placed> all = new ArrayList<>(found);
    int left = omitted;
    for (final Kind kind : kinds.values()) {
      final int more = kind.count - LIKE_WARNINGS;
      if (omitted > 0) {
        left += Math.max(0, more);
      } else if (more > 0) {
        all.add(new Placed(kind.offset, at(kind.offset, Problem.Severity.WARNING,
            Messages.text("scenes.moreLikeThis", kind.message, more))));
      }
    }
    all.sort(Comparator.comparingInt(Placed::offset));
    for (final Placed placed : all) {
      problems.add(placed.problem());
    }
    if (omitted > 0) {
      problems.add(at(firstOmitted, hasErrors() ? Problem.Severity.ERROR : Problem.Severity.WARNING,
          Messages.text("scenes.omitted", left)));
    }
    return problems;
  }
}
