package meshes;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;

/**
 * The bytes of a text file, through a window in which no word is ever cut: before each word, {@link #reserve} ensures
 * that the next {@link #LONGEST} bytes are in the window, or the end of the file followed by line feeds. So the loops
 * over the bytes of a word need no test for the end. The byte before the next one stays in the window too.
 */
final class ByteReader {

  /** A word longer than this is not a number. */
  static final int LONGEST = 512;

  private static final int SIZE = 1 << 16;

  /** The window, read by parsers; only {@link #reserve} changes it. */
  final byte[] window = new byte[SIZE + LONGEST];
  /** The next byte of the window. */
  int at;

  private final InputStream in;
  private final long most;
  private int end;
  private long before;
  private boolean ended;

  /** The bytes of a stream, up to a limit. */
  ByteReader(final InputStream in, final long most) {
    this.in = in;
    this.most = most;
  }

  /** Ensures that the window extends {@link #LONGEST} bytes beyond {@link #at}. */
  void reserve() throws IOException {
    if (end - at < LONGEST && !ended) {
      refill();
    }
  }

  private void refill() throws IOException {
    final int passed = Math.max(at - 1, 0);
    System.arraycopy(window, passed, window, 0, end - passed);
    before += passed;
    end -= passed;
    at -= passed;
    while (end < SIZE && !ended) {
      final int count = in.read(window, end, SIZE - end);
      ended = count < 0;
      end += Math.max(count, 0);
    }
    if (before + end > most) {
      throw new TooLongException();
    }
    Arrays.fill(window, end, end + LONGEST, (byte) '\n');
  }

  /** Whether no byte of the file is left. */
  boolean isAtEnd() {
    return ended && at >= end;
  }

  /** Whether the window ends at an index although the file does not: a word that extends to there is too long. */
  boolean isCut(final int i) {
    return i >= end && !ended;
  }

  /** Number of bytes of the file before {@link #at}. */
  long position() {
    return before + at;
  }

  /** Number of bytes of the file before the window. */
  long windowStart() {
    return before;
  }

  /** A file is longer than the limit. */
  static final class TooLongException extends IOException {
    private static final long serialVersionUID = 1L;
  }
}
