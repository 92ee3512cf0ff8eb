package diagnostics;

import java.util.Locale;

/**
 * Characters that look like a blank, or are invisible, but do not separate words: no-break, thin and ideographic blanks,
 * zero-width characters, a byte-order mark in the middle of a text. They get into files by copying from word processors.
 */
public final class UnusualBlank {

  private UnusualBlank() {
  }

  /**
   * Whether a character is of this kind.
   *
   * @param codePoint the character
   * @return false for blank, tab and line ends
   */
  public static boolean is(final int codePoint) {
    return codePoint != ' ' && Character.isSpaceChar(codePoint) || codePoint == 0x0b || codePoint == 0x0c
        || codePoint == 0x85 || codePoint == 0x180e || codePoint >= 0x200b && codePoint <= 0x200f
        || codePoint == 0x2060 || codePoint == 0xfeff;
  }

  /**
   * Looks for the first one.
   *
   * @param text a text
   * @return its index; −1 if there is none
   */
  public static int indexIn(final String text) {
    for (int i = 0; i < text.length(); i++) {
      if (is(text.charAt(i))) {
        return i;
      }
    }
    return -1;
  }

  /**
   * Replaces them by ordinary blanks.
   *
   * @param text a text
   * @return a text of the same length
   */
  public static String replaced(final String text) {
    final StringBuilder replaced = new StringBuilder(text);
    for (int i = 0; i < text.length(); i++) {
      if (is(text.charAt(i))) {
        replaced.setCharAt(i, ' ');
      }
    }
    return replaced.toString();
  }

  /**
   * How a message names a character.
   *
   * @param codePoint the character
   * @return its code point, as in {@code U+00A0}, and its name in Unicode
   */
  public static String name(final int codePoint) {
    final String name = Character.getName(codePoint);
    return String.format(Locale.ROOT, "U+%04X", codePoint) + (name == null ? "" : " " + name);
  }
}
