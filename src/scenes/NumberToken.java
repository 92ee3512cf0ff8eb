package scenes;

import java.util.ArrayList;
import java.util.List;

/**
 * A token of the text of an element, with its place in the file.
 *
 * @param text the token as the file has it
 * @param start offset of its first character
 */
record NumberToken(String text, int start) {

  /** The tokens directly within an element, in order; comments, sections and child elements separate them. */
  static List<NumberToken> within(final Element element, final String source) {
    final List<NumberToken> tokens = new ArrayList<>();
    final int end = source.lastIndexOf("</", element.end() - 1);
    int i = afterTag(source, element.offset());
    while (i < end) {
      final char c = source.charAt(i);
      if (source.startsWith("<![CDATA[", i)) {
        i += "<![CDATA[".length();
      } else if (source.startsWith("]]>", i)) {
        i += "]]>".length();
      } else if (c == '<') {
        i = afterMarkup(element, source, i);
      } else if (Character.isWhitespace(c)) {
        i++;
      } else {
        final int start = i;
        while (i < end && !isEnd(source, i)) {
          i++;
        }
        tokens.add(new NumberToken(source.substring(start, i), start));
      }
    }
    return tokens;
  }

  private static boolean isEnd(final String source, final int i) {
    final char c = source.charAt(i);
    return c == '<' || Character.isWhitespace(c) || source.startsWith("]]>", i);
  }

  /** The place after a start tag; a quoted value may contain its end mark. */
  private static int afterTag(final String source, final int start) {
    char quote = 0;
    for (int i = start; i < source.length(); i++) {
      final char c = source.charAt(i);
      if (quote == 0 && c == '>') {
        return i + 1;
      }
      if (quote == 0 && (c == '"' || c == '\'')) {
        quote = c;
      } else if (c == quote) {
        quote = 0;
      }
    }
    return source.length();
  }

  /** The place after a comment, a processing instruction or a child element. */
  private static int afterMarkup(final Element element, final String source, final int start) {
    for (final Element child : element.children()) {
      if (child.offset() == start) {
        return child.end();
      }
    }
    final String mark = source.startsWith("<!--", start) ? "-->" : "?>";
    return source.indexOf(mark, start) + mark.length();
  }

  /** Whether this token and another number are the same float, so that they differ at most in spelling. */
  boolean hasValueOf(final String number) {
    return Decimal.is(text) && Decimal.is(number) && Float.parseFloat(text) == Float.parseFloat(number);
  }
}
