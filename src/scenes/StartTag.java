package scenes;

import java.util.LinkedHashMap;
import java.util.Map;

/** The text of a start tag: the places of its attributes and, if it is not well-formed, its first fault. */
final class StartTag {

  private final String text;
  private final int start;
  private final String name;
  private final Map<String, Integer> offsets = new LinkedHashMap<>();
  private XmlSyntaxException fault;
  private int at;

  /**
   * Scans a tag.
   *
   * @param text the text of the file
   * @param start place of the {@code <} of the tag
   */
  StartTag(final String text, final int start) {
    this.text = text;
    this.start = start;
    this.at = start + 1;
    this.name = name(text, at);
    at += name.length();
    try {
      scan();
    } catch (final XmlSyntaxException wrong) {
      fault = wrong;
    }
  }

  /** Place of the attribute of a name; that of the tag if there is none. */
  int offset(final String attribute) {
    return offsets.getOrDefault(attribute, start);
  }

  /** The first fault in the shape of the tag; null if none. */
  XmlSyntaxException fault() {
    return fault;
  }

  /** The name at a place of a text; empty if none. */
  static String name(final String text, final int from) {
    int i = from;
    while (i < text.length() && (isNameStart(text.charAt(i)) || i > from && isNamePart(text.charAt(i)))) {
      i++;
    }
    return text.substring(from, i);
  }

  private static boolean isNameStart(final char c) {
    return c == ':' || c == '_' || Character.isLetter(c) || Character.isSurrogate(c);
  }

  private static boolean isNamePart(final char c) {
    return c == '-' || c == '.' || c == '\u00b7' || Character.isLetterOrDigit(c) || Character.isSurrogate(c);
  }

  private void scan() throws XmlSyntaxException {
    if (name.isEmpty()) {
      throw SyntaxDiagnosis.strayMark(text, start);
    }
    while (true) {
      final int before = at;
      skipBlanks();
      if (at == text.length()) {
        throw new XmlSyntaxException(start, "endlessTag", name);
      }
      if (text.charAt(at) == '>') {
        return;
      }
      if (text.charAt(at) == '/') {
        at++;
        expect('>', start, name);
        return;
      }
      if (at == before || name(text, at).isEmpty()) {
        throw new XmlSyntaxException(at, "attributeExpected", name, SyntaxDiagnosis.character(text, at));
      }
      attribute();
    }
  }

  private void attribute() throws XmlSyntaxException {
    final int from = at;
    final String attribute = name(text, from);
    at += attribute.length();
    skipBlanks();
    expect('=', from, attribute);
    at++;
    skipBlanks();
    final char quote = at < text.length() ? text.charAt(at) : 0;
    if (quote != '"' && quote != '\'') {
      throw new XmlSyntaxException(from, "unquoted", attribute);
    }
    final int close = text.indexOf(quote, at + 1);
    final int mark = text.indexOf('<', at + 1);
    if (close < 0 || mark >= 0 && mark < close) {
      throw new XmlSyntaxException(from, "endlessValue", attribute, quote);
    }
    if (offsets.putIfAbsent(attribute, from) != null) {
      throw new XmlSyntaxException(from, "repeatedAttribute", attribute);
    }
    at = close + 1;
  }

  private void expect(final char expected, final int offset, final String before) throws XmlSyntaxException {
    if (at == text.length() || text.charAt(at) != expected) {
      throw new XmlSyntaxException(offset, "markExpected", before, expected);
    }
  }

  private void skipBlanks() {
    while (at < text.length() && SyntaxDiagnosis.isBlank(text.charAt(at))) {
      at++;
    }
  }
}
