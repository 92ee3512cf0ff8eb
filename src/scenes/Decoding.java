package scenes;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.IllegalCharsetNameException;
import java.nio.charset.StandardCharsets;
import java.nio.charset.UnsupportedCharsetException;

import diagnostics.UnicodeMark;

/**
 * The text of a scene file from its bytes: by the byte-order mark, or by the zeros of UTF-16 and UTF-32, else by the
 * encoding that its XML declaration names, else UTF-8. A file that is not valid UTF-8 is decoded as Latin-1, so that an
 * old comment does not make it unreadable.
 *
 * @param text the text, without byte-order mark
 * @param warning key of the message if the encoding had to be guessed, or null
 * @param encoding the encoding that was declared, or null
 */
record Decoding(String text, String warning, String encoding) {

  static Decoding of(final byte[] bytes) {
    final UnicodeMark mark = UnicodeMark.of(bytes);
    final int start = mark.length();
    if (mark.charset() != null && mark.charset() != StandardCharsets.UTF_8) {
      return new Decoding(new String(bytes, start, bytes.length - start, mark.charset()), null, null);
    }
    final String encoding = declared(bytes, start);
    if (encoding == null || start > 0) {
      return decoded(bytes, start, StandardCharsets.UTF_8, null, encoding);
    }
    try {
      final Charset charset = Charset.forName(encoding);
      return isWide(charset) ? decoded(bytes, start, StandardCharsets.UTF_8, "encodingNarrow", encoding)
          : decoded(bytes, start, charset, null, encoding);
    } catch (final IllegalCharsetNameException | UnsupportedCharsetException unknown) {
      return decoded(bytes, start, StandardCharsets.UTF_8, "encodingUnknown", encoding);
    }
  }

  /** Whether letters take more than a byte each, so that no declaration could have been found as it was. */
  private static boolean isWide(final Charset charset) {
    return charset.canEncode() && "<?".getBytes(charset).length > 2;
  }

  private static Decoding decoded(final byte[] bytes, final int start, final Charset charset, final String warning,
      final String encoding) {
    final ByteBuffer rest = ByteBuffer.wrap(bytes, start, bytes.length - start);
    try {
      return new Decoding(charset.newDecoder().decode(rest).toString(), warning, encoding);
    } catch (final CharacterCodingException notThis) {
      final String latin1 = new String(bytes, start, bytes.length - start, StandardCharsets.ISO_8859_1);
      return new Decoding(latin1, warning == null ? "encodingWrong" : warning, charset.name());
    }
  }

  /** The encoding that the XML declaration names; null if none. */
  private static String declared(final byte[] bytes, final int start) {
    final String head = new String(bytes, start, Math.min(bytes.length - start, 200), StandardCharsets.ISO_8859_1);
    final int end = head.startsWith("<?xml") ? head.indexOf("?>") : -1;
    final int name = end < 0 ? -1 : head.indexOf("encoding");
    final int open = name < 0 || name > end ? -1 : quote(head, name);
    final int close = open < 0 ? -1 : head.indexOf(head.charAt(open), open + 1);
    return close < 0 || close > end ? null : head.substring(open + 1, close);
  }

  private static int quote(final String head, final int from) {
    for (int i = from; i < head.length(); i++) {
      if (head.charAt(i) == '"' || head.charAt(i) == '\'') {
        return i;
      }
    }
    return -1;
  }
}
