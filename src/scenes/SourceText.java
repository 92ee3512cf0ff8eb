package scenes;

import java.util.Arrays;

/** The text of a file, with the line and column of each of its characters. */
final class SourceText {

  private final String file;
  private final String text;
  private final int[] lineStarts;

  /** The last place whose column was computed: in a file of one long line, the next is counted from there. */
  private int knownOffset;
  private int knownColumn = 1;

  SourceText(final String file, final String text) {
    this.file = file;
    this.text = text;
    this.lineStarts = lineStarts(text);
  }

  private static int[] lineStarts(final String text) {
    int[] starts = new int[64];
    int lines = 1;
    for (int i = 0; i < text.length(); i++) {
      if (endsLine(text, i)) {
        if (lines == starts.length) {
          starts = Arrays.copyOf(starts, 2 * lines);
        }
        starts[lines++] = i + 1;
      }
    }
    return Arrays.copyOf(starts, lines);
  }

  /** A line ends with a line feed, or with a carriage return that no line feed follows. */
  private static boolean endsLine(final String text, final int i) {
    final char c = text.charAt(i);
    return c == '\n' || c == '\r' && (i + 1 == text.length() || text.charAt(i + 1) != '\n');
  }

  String file() {
    return file;
  }

  String text() {
    return text;
  }

  int line(final int offset) {
    final int found = Arrays.binarySearch(lineStarts, offset);
    return found >= 0 ? found + 1 : -found - 1;
  }

  int column(final int offset) {
    final int start = lineStarts[line(offset) - 1], end = Math.min(offset, text.length());
    final boolean goesOn = knownOffset >= start && knownOffset <= end;
    knownColumn = (goesOn ? knownColumn : 1) + text.codePointCount(goesOn ? knownOffset : start, end);
    knownOffset = end;
    return knownColumn;
  }
}
