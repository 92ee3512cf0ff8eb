package meshes;

import java.io.ByteArrayOutputStream;
import java.io.IOException;

import arguments.Messages;

/**
 * The text of an OBJ or MTL file as lines of words. A backslash at the end of a line continues it; a comment goes from
 * {@code #} to the end of the line. Lines and columns are counted.
 */
final class ObjText {

  /** A name longer than this, in bytes, is cut. */
  private static final int LONGEST_NAME = 4096;

  final ByteReader bytes;
  private int line = 1;
  private long lineStart;

  ObjText(final ByteReader bytes) {
    this.bytes = bytes;
  }

  /** Number of the line, from 1. */
  int line() {
    return line;
  }

  boolean isAtEnd() {
    return bytes.isAtEnd();
  }

  /** Advances to the next word of the statement, over blanks and continued line ends; false if none. */
  boolean toWord() throws IOException {
    while (true) {
      bytes.reserve();
      final byte[] window = bytes.window;
      final int last = bytes.at + ByteReader.LONGEST - 2;
      int i = bytes.at;
      while (i < last && (window[i] == ' ' || window[i] == '\t')) {
        i++;
      }
      bytes.at = i;
      if (window[i] == '\\' && continues(i)) {
        bytes.at++;
        endLine();
      } else if (i < last) {
        return window[i] != '\n' && window[i] != '\r' && window[i] != '#';
      }
    }
  }

  /** Whether a byte is a backslash at the end of its line. */
  boolean continues(final int i) {
    final byte next = bytes.window[i + 1];
    return bytes.window[i] == '\\' && (next == '\n' || next == '\r') && !bytes.isAtEnd();
  }

  private static boolean isBlank(final byte b) {
    return b == ' ' || b == '\t' || b == '\n' || b == '\r';
  }

  /** Whether a word ends before a byte. */
  boolean endsWord(final int i) {
    return isBlank(bytes.window[i]) && !bytes.isCut(i) || bytes.window[i] == '#' || continues(i);
  }

  /** Whether the word that begins here is a given one; if so, skips it. */
  boolean takeWord(final String word) {
    for (int i = 0; i < word.length(); i++) {
      if (bytes.window[bytes.at + i] != word.charAt(i)) {
        return false;
      }
    }
    final int end = bytes.at + word.length();
    if (!isBlank(bytes.window[end]) && !continues(end)) {
      return false;
    }
    bytes.at = end;
    return true;
  }

  /** Passes over what is left of a word. */
  void skipWord() throws IOException {
    while (!endsWord(bytes.at) && !isAtEnd()) {
      bytes.at++;
      bytes.reserve();
    }
  }

  /** Skips the rest of a line, and optionally the lines that continue it. */
  void skipLine(final boolean continued) throws IOException {
    while (!bytes.isAtEnd()) {
      bytes.reserve();
      final byte[] window = bytes.window;
      final int last = bytes.at + ByteReader.LONGEST - 2;
      int i = bytes.at;
      while (i < last && window[i] != '\n' && window[i] != '\r') {
        i++;
      }
      bytes.at = i;
      if (i < last) {
        final boolean more = continued && i > 0 && window[i - 1] == '\\' && !bytes.isAtEnd();
        endLine();
        if (!more) {
          return;
        }
      }
    }
  }

  /** Skips the end of a line: a line feed, a carriage return, or both in this order. */
  void endLine() throws IOException {
    if (bytes.isAtEnd()) {
      return;
    }
    if (bytes.window[bytes.at] == '#') {
      skipLine(false);
      return;
    }
    bytes.at += bytes.window[bytes.at] == '\r' && bytes.window[bytes.at + 1] == '\n' ? 2 : 1;
    line++;
    lineStart = bytes.position();
  }

  /** The rest of the line without surrounding blanks: a name of any characters. */
  String name() throws IOException {
    final ByteArrayOutputStream name = new ByteArrayOutputStream();
    while (!bytes.isAtEnd()) {
      bytes.reserve();
      final byte next = bytes.window[bytes.at];
      if (next == '\n' || next == '\r') {
        break;
      }
      if (continues(bytes.at)) {
        bytes.at++;
        endLine();
        name.write(' ');
      } else {
        if (name.size() < LONGEST_NAME) {
          name.write(next);
        }
        bytes.at++;
      }
    }
    final byte[] found = name.toByteArray();
    return TextEncoding.text(found, 0, found.length).strip();
  }

  /** The word that begins here, quoted for a message. */
  String word() {
    return Messages.quote(rawWord());
  }

  /** The word that begins here, or as much of it as a message quotes. */
  String rawWord() {
    return TextEncoding.text(bytes.window, bytes.at, wordEnd() - bytes.at);
  }

  /** The line from here on, up to a limit. */
  String rawLine() {
    int end = bytes.at;
    while (end < bytes.at + 2 * Messages.LONGEST_QUOTE && bytes.window[end] != '\n' && bytes.window[end] != '\r') {
      end++;
    }
    return TextEncoding.text(bytes.window, bytes.at, end - bytes.at);
  }

  private int wordEnd() {
    int end = bytes.at;
    while (end < bytes.at + 2 * Messages.LONGEST_QUOTE && !isBlank(bytes.window[end])) {
      end++;
    }
    return end;
  }

  /** Column of a byte of this line, from 1, in characters as far as the line is still in the window. */
  int column(final long position) {
    final long start = Math.max(lineStart, bytes.windowStart());
    final int from = (int) (start - bytes.windowStart()), length = (int) Math.max(0, position - start);
    final String before = TextEncoding.text(bytes.window, from, length);
    return (int) Math.min(start - lineStart + before.codePointCount(0, before.length()) + 1, Integer.MAX_VALUE);
  }

  /** Position of the first byte of this line. */
  long lineStart() {
    return lineStart;
  }
}
