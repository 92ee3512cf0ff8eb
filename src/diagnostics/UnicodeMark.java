package diagnostics;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;

/**
 * What the first bytes of a text file say about its encoding: a byte-order mark, or, without one, zeros where the first
 * character of UTF-16 or UTF-32 has them if it is one of ASCII (Extensible Markup Language 1.0, appendix F).
 *
 * @param charset the encoding; null if the bytes do not show it, as in UTF-8 without a mark
 * @param length number of bytes of the mark; 0 if none
 */
public record UnicodeMark(Charset charset, int length) {

  /** Number of bytes that are examined. */
  public static final int LONGEST = 4;

  /** Encodings and their marks, the bytes of which are written as characters of Latin-1. */
  private static final String[][] MARKS = {{"UTF-8", "\u00ef\u00bb\u00bf"}, {"UTF-32LE", "\u00ff\u00fe\0\0"},
      {"UTF-32BE", "\0\0\u00fe\u00ff"}, {"UTF-16LE", "\u00ff\u00fe"}, {"UTF-16BE", "\u00fe\u00ff"}};

  /**
   * The mark of a file.
   *
   * @param bytes its first bytes, at least {@value #LONGEST} unless the file is shorter
   * @return the mark
   */
  public static UnicodeMark of(final byte[] bytes) {
    final String start = new String(bytes, 0, Math.min(LONGEST, bytes.length), StandardCharsets.ISO_8859_1);
    for (final String[] mark : MARKS) {
      if (start.startsWith(mark[1])) {
        return new UnicodeMark(Charset.forName(mark[0]), mark[1].length());
      }
    }
    return new UnicodeMark(byZeros(start), 0);
  }

  private static Charset byZeros(final String start) {
    final String pattern = start.replaceAll("[^\0]", "x").replace('\0', '0');
    return pattern.equals("000x") ? Charset.forName("UTF-32BE") : pattern.equals("x000") ? Charset.forName("UTF-32LE")
        : pattern.startsWith("0") ? StandardCharsets.UTF_16BE : pattern.startsWith("x0") ? StandardCharsets.UTF_16LE : null;
  }
}
