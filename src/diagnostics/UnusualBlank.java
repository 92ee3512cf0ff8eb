package diagnostics;

import java.util.Locale;

/**
 * Characters that look like a blank, or are invisible, but separate words neither in XML nor in OBJ files: no-break, thin
 * and ideographic spaces, zero-width characters, a byte-order mark in the middle of a text. They get into files by copying
 * from web pages and word processors.
 */
public final class UnusualBlank {

  private static final int VERTICAL_TAB = 0x0b;
  private static final int FORM_FEED = 0x0c;
  private static final int NEXT_LINE = 0x85;

  private UnusualBlank() {
  }

  /**
   * Whether a character is of this kind.
   *
   * @param codePoint the character
   * @return false for blank, tab and line ends
   */
  public static boolean is(final int codePoint) {
    if (codePoint < NEXT_LINE) {
      return codePoint == VERTICAL_TAB || codePoint == FORM_FEED;
    }
    return switch (Character.getType(codePoint)) {
      case Character.SPACE_SEPARATOR, Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR, Character.FORMAT -> true;
      default -> codePoint == NEXT_LINE;
    };
  }

  /**
   * Whether a character is a blank of any kind, an unusual one too.
   *
   * @param codePoint the character
   * @return true for blanks, tabs and line ends as well
   */
  public static boolean isBlank(final int codePoint) {
    return Character.isWhitespace(codePoint) || is(codePoint);
  }

  /**
   * Looks for the first one.
   *
   * @param text a text
   * @return its index; −1 if none
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
   * The text without blanks at its ends, unusual ones too.
   *
   * @param text a text
   * @return the part between the first and the last character that are no blanks
   */
  public static String stripped(final String text) {
    int from = 0, to = text.length();
    while (from < to && isBlank(text.charAt(from))) {
      from++;
    }
    while (to > from && isBlank(text.charAt(to - 1))) {
      to--;
    }
    return text.substring(from, to);
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
