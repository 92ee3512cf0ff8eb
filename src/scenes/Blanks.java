package scenes;

/**
 * Characters that look like a blank, or like nothing, but are no blanks of XML: no-break, thin and ideographic spaces,
 * zero-width ones, a byte-order mark in the middle of a file. They come from web pages and word processors.
 */
final class Blanks {

  private static final char NEXT_LINE = '\u0085';

  private Blanks() {
  }

  /** Whether a character is a blank, an odd one too. */
  static boolean isBlank(final char c) {
    return Character.isWhitespace(c) || isOdd(c);
  }

  /** Whether a character only looks like a blank. */
  static boolean isOdd(final char c) {
    if (c < NEXT_LINE) {
      return false;
    }
    return switch (Character.getType(c)) {
      case Character.SPACE_SEPARATOR, Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR, Character.FORMAT -> true;
      default -> c == NEXT_LINE;
    };
  }

  /** Place of the first odd blank in a text; −1 if there is none. */
  static int firstOdd(final String text) {
    for (int i = 0; i < text.length(); i++) {
      if (isOdd(text.charAt(i))) {
        return i;
      }
    }
    return -1;
  }

  /** The text with a blank for each odd one. */
  static String plain(final String text) {
    final StringBuilder plain = new StringBuilder(text);
    for (int i = 0; i < text.length(); i++) {
      if (isOdd(text.charAt(i))) {
        plain.setCharAt(i, ' ');
      }
    }
    return plain.toString();
  }

  /** The text without blanks at its ends, odd ones too. */
  static String stripped(final String text) {
    int from = 0, to = text.length();
    while (from < to && isBlank(text.charAt(from))) {
      from++;
    }
    while (to > from && isBlank(text.charAt(to - 1))) {
      to--;
    }
    return text.substring(from, to);
  }

  /** Code point and name of a character, {@code U+00A0 NO-BREAK SPACE}. */
  static String name(final int c) {
    final String name = Character.getName(c);
    return String.format("U+%04X", c) + (name == null ? "" : " " + name);
  }
}
