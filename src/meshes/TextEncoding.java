package meshes;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;

import diagnostics.UnicodeMark;

/**
 * The encoding of a text file of meshes or materials: that of its byte-order mark; without one, UTF-16 or UTF-32 if zeros
 * are where the first character of an English text has them. Everything else is read as bytes, in which names are UTF-8,
 * or Latin-1 if they are not valid UTF-8.
 */
final class TextEncoding {

  private TextEncoding() {
  }

  /** The bytes of a text in UTF-8, or as they are, without byte-order mark; reads a few ahead. */
  static InputStream decoded(final BufferedInputStream buffered) throws IOException {
    buffered.mark(UnicodeMark.LONGEST);
    final UnicodeMark mark = UnicodeMark.of(buffered.readNBytes(UnicodeMark.LONGEST));
    buffered.reset();
    buffered.skipNBytes(mark.length());
    return mark.charset() == null || mark.charset() == StandardCharsets.UTF_8 ? buffered
        : new Utf8Stream(new InputStreamReader(buffered, mark.charset()));
  }

  /** A piece of a text: as UTF-8 if valid, else as Latin-1. */
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
