package meshes;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;

/**
 * The encoding of a text file of meshes or materials: that of its byte-order mark; without one, UTF-16 or UTF-32 if zeros
 * stand where the first character of an English text has them. Everything else stays as it is: bytes, in which names are
 * UTF-8, or Latin-1 if they are not.
 */
final class TextEncoding {

  private static final int LONGEST_MARK = 4;

  private TextEncoding() {
  }

  /** The bytes of a text in UTF-8, or as they are, without byte-order mark; reads a few ahead. */
  static InputStream decoded(final BufferedInputStream buffered) throws IOException {
    buffered.mark(LONGEST_MARK);
    final byte[] start = buffered.readNBytes(LONGEST_MARK);
    buffered.reset();
    final Charset charset = charset(start);
    final int mark = mark(start, charset);
    buffered.skipNBytes(mark);
    return charset == null || charset == StandardCharsets.UTF_8 ? buffered
        : new Utf8Stream(new InputStreamReader(buffered, charset));
  }

  private static Charset charset(final byte[] start) {
    final int first = at(start, 0), second = at(start, 1), third = at(start, 2), fourth = at(start, 3);
    if (first == 0xef && second == 0xbb && third == 0xbf) {
      return StandardCharsets.UTF_8;
    }
    if (first == 0 && second == 0 && (third != 0 || fourth != 0)) {
      return Charset.forName("UTF-32BE");
    }
    if (second == 0 && third == 0 && fourth == 0 && first != 0 || isMark(first, second, 0xff) && third == 0 && fourth == 0) {
      return Charset.forName("UTF-32LE");
    }
    if (isMark(first, second, 0xfe) || first == 0) {
      return StandardCharsets.UTF_16BE;
    }
    return isMark(first, second, 0xff) || second == 0 ? StandardCharsets.UTF_16LE : null;
  }

  private static boolean isMark(final int first, final int second, final int expected) {
    return first == expected && first + second == 0xfe + 0xff;
  }

  /** A byte of the start, −1 after the end of the file. */
  private static int at(final byte[] start, final int i) {
    return i < start.length ? start[i] & 0xff : -1;
  }

  /** Length of the byte-order mark. */
  private static int mark(final byte[] start, final Charset charset) {
    if (charset == null) {
      return 0;
    }
    final byte[] mark = "\ufeff".getBytes(charset);
    for (int i = 0; i < mark.length; i++) {
      if (i >= start.length || start[i] != mark[i]) {
        return 0;
      }
    }
    return mark.length;
  }

  /** A piece of a text: UTF-8 if it is, else Latin-1. */
  static String text(final byte[] bytes, final int from, final int length) {
    try {
      return StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes, from, length)).toString();
    } catch (final CharacterCodingException notUtf8) {
      return new String(bytes, from, length, StandardCharsets.ISO_8859_1);
    }
  }

  /** Characters, encoded in UTF-8. */
  private static final class Utf8Stream extends InputStream {

    private final Reader reader;
    private final char[] characters = new char[1 << 12];
    private byte[] bytes = new byte[0];
    private int at;

    Utf8Stream(final Reader reader) {
      this.reader = reader;
    }

    /** Encodes the next characters, never half of a surrogate pair; false at the end. */
    private boolean fill() throws IOException {
      int count = reader.read(characters, 0, characters.length - 1);
      if (count > 0 && Character.isHighSurrogate(characters[count - 1])) {
        count += Math.max(0, reader.read(characters, count, 1));
      }
      bytes = count <= 0 ? new byte[0] : new String(characters, 0, count).getBytes(StandardCharsets.UTF_8);
      at = 0;
      return count > 0;
    }

    @Override
    public int read() throws IOException {
      return at < bytes.length || fill() ? bytes[at++] & 0xff : -1;
    }

    @Override
    public int read(final byte[] to, final int offset, final int length) throws IOException {
      if (length > 0 && at == bytes.length && !fill()) {
        return -1;
      }
      final int count = Math.min(length, bytes.length - at);
      System.arraycopy(bytes, at, to, offset, count);
      at += count;
      return count;
    }

    @Override
    public void close() throws IOException {
      reader.close();
    }
  }
}
