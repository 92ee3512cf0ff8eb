package scenes;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

import arguments.Messages;

/**
 * Reads the markup of a scene file, the part of XML 1.0 that is left without document type definitions, into a
 * tree that knows where each thing stands.
 *
 * <p>Why not the reader of the JDK: it tells only where things end, in messages of its own that are not to be had
 * in Spanish, and starting it costs twice the time that the virtual machine itself needs. A DOCTYPE is refused, so
 * that there are no entities but the five of XML, and nothing outside the file is ever read. Slips that leave the
 * structure clear (an unknown entity, a repeated attribute) are told and passed over; others end the reading.
 */
final class MarkupReader {

  /** A comment: its text, without the marks about it, and its place. */
  record Comment(String text, int offset) {
  }

  /** More than this in one another, and the file is no scene; it keeps recursion over the tree shallow. */
  static final int DEEPEST = 200;

  /** With the & and without the semicolon: &#1114111 and some more. */
  private static final int LONGEST_REFERENCE = 13;

  private final String text;
  private final Problems problems;
  private final List<Comment> comments = new ArrayList<>();
  private final Deque<Element> open = new ArrayDeque<>();
  private Element root;
  private int at;

  MarkupReader(final Problems problems) {
    this.text = problems.source().text();
    this.problems = problems;
  }

  /** The comments of the file, in its order; complete once it has been read. */
  List<Comment> comments() {
    return comments;
  }

  /** Reads the whole file and answers its document element. */
  Element read() throws XmlSyntaxException {
    checkCharacters();
    while (at < text.length()) {
      if (text.charAt(at) == '<') {
        markup();
      } else {
        characters();
      }
    }
    if (!open.isEmpty()) {
      throw new XmlSyntaxException(open.peek().offset(), "unclosed", open.peek().name());
    }
    if (root == null) {
      throw new XmlSyntaxException(0, "noElement", Messages.quote(text));
    }
    return root;
  }

  private void checkCharacters() throws XmlSyntaxException {
    for (int i = 0; i < text.length(); i++) {
      final char c = text.charAt(i);
      if (c < ' ' && c != '\t' && c != '\n' && c != '\r' || c >= '\ufffe') {
        throw new XmlSyntaxException(i, "character", Integer.toHexString(c));
      }
    }
  }

  private void markup() throws XmlSyntaxException {
    if (text.startsWith("<!--", at)) {
      comment();
    } else if (text.startsWith("<![CDATA[", at)) {
      characterData();
    } else if (text.startsWith("<!", at)) {
      throw new XmlSyntaxException(at, "doctype", Messages.quote(text.substring(at, Math.min(at + 9, text.length()))));
    } else if (text.startsWith("<?", at)) {
      instruction();
    } else if (text.startsWith("</", at)) {
      endTag();
    } else {
      startTag();
    }
  }

  private void comment() throws XmlSyntaxException {
    final int start = at;
    final String inside = upTo("-->", start + 4, "comment");
    final int dashes = (inside + '-').indexOf("--");
    if (dashes >= 0) {
      problems.error(start + 4 + dashes, "dashes");
    }
    comments.add(new Comment(inside, start));
  }

  private void characterData() throws XmlSyntaxException {
    final int start = at;
    final String inside = upTo("]]>", start + 9, "CDATA");
    if (open.isEmpty()) {
      problems.error(start, "outside", Messages.quote(inside));
    } else {
      open.peek().addText(inside, start + 9, true);
    }
  }

  private void instruction() throws XmlSyntaxException {
    final int start = at;
    final String inside = upTo("?>", start + 2, "<?");
    final int length = nameLength(start + 2);
    final String target = text.substring(start + 2, start + 2 + length);
    if (length == 0 || length < inside.length() && !isBlank(inside.charAt(length))) {
      throw new XmlSyntaxException(start, "instruction", Messages.quote(inside));
    }
    if (target.equalsIgnoreCase("xml") && !(start == 0 && target.equals("xml"))) {
      problems.error(start, "declaration");
    }
  }

  /** What stands between a place and a mark, past which the reading goes on. */
  private String upTo(final String mark, final int from, final String what) throws XmlSyntaxException {
    final int end = text.indexOf(mark, from);
    if (end < 0) {
      throw new XmlSyntaxException(at, "endless", what, mark);
    }
    at = end + mark.length();
    return text.substring(from, end);
  }

  private void characters() {
    final int start = at;
    while (at < text.length() && text.charAt(at) != '<' && text.charAt(at) != '&') {
      at++;
    }
    if (at == start) {
      final String replacement = reference();
      if (open.isEmpty()) {
        problems.error(start, "outside", Messages.quote(replacement));
      } else {
        open.peek().addText(replacement, start, false);
      }
      return;
    }
    final String run = text.substring(start, at);
    final int cdataEnd = run.indexOf("]]>");
    if (cdataEnd >= 0) {
      problems.error(start + cdataEnd, "cdataEnd");
    }
    if (!open.isEmpty()) {
      open.peek().addText(run, start, true);
    } else if (!run.isBlank()) {
      problems.error(start + run.indexOf(run.strip()), "outside", Messages.quote(run));
    }
  }

  /** Reads a reference to an entity or to a character; one that means nothing is told and stands for itself. */
  private String reference() {
    final int start = at++;
    final int limit = Math.min(start + LONGEST_REFERENCE, text.length());
    int semicolon = at;
    while (semicolon < limit && text.charAt(semicolon) != ';') {
      semicolon++;
    }
    final String name = semicolon == limit ? "" : text.substring(start + 1, semicolon);
    final String meaning = Reference.meaning(name);
    if (meaning == null) {
      problems.error(start, "entity", Messages.quote(text.substring(start, Math.min(semicolon + 1, limit))));
      return "&";
    }
    at = semicolon + 1;
    return meaning;
  }

  private void startTag() throws XmlSyntaxException {
    final int start = at++;
    final Element element = new Element(name(start), start, open.peek());
    if (element.depth() > DEEPEST) {
      throw new XmlSyntaxException(start, "deep", DEEPEST);
    }
    attributes(element);
    if (open.isEmpty() && root != null) {
      throw new XmlSyntaxException(start, "secondRoot", element.name(), root.name());
    }
    if (open.isEmpty()) {
      root = element;
    } else {
      open.peek().children().add(element);
    }
    if (text.charAt(at) == '/') {
      at++;
      expect('>', start, element.name());
      element.close(at);
    } else {
      at++;
      open.push(element);
    }
  }

  /** Reads attributes up to the {@code >} or {@code />} of the tag. */
  private void attributes(final Element element) throws XmlSyntaxException {
    while (true) {
      final int before = at;
      skipBlanks();
      if (at == text.length()) {
        throw new XmlSyntaxException(element.offset(), "endlessTag", element.name());
      }
      if (text.charAt(at) == '>' || text.charAt(at) == '/') {
        return;
      }
      if (at == before || nameLength(at) == 0) {
        throw new XmlSyntaxException(at, "attributeExpected", element.name(), Messages.quote(text.substring(at, at + 1)));
      }
      attribute(element);
    }
  }

  private void attribute(final Element element) throws XmlSyntaxException {
    final int start = at;
    final String name = name(start);
    skipBlanks();
    expect('=', start, name);
    skipBlanks();
    final char quote = at < text.length() ? text.charAt(at) : 0;
    if (quote != '"' && quote != '\'') {
      throw new XmlSyntaxException(start, "unquoted", name);
    }
    at++;
    final String value = attributeValue(start, name, quote);
    if (element.attribute(name) == null) {
      element.attributes().add(new Element.Attribute(name, value, start));
    } else {
      problems.error(start, "repeatedAttribute", name);
    }
  }

  private String attributeValue(final int start, final String name, final char quote) throws XmlSyntaxException {
    final StringBuilder value = new StringBuilder();
    while (true) {
      final char c = at < text.length() ? text.charAt(at) : '<';
      if (c == '<') {
        throw new XmlSyntaxException(start, "endlessValue", name, quote);
      }
      if (c == quote) {
        at++;
        return value.toString();
      }
      if (c == '&') {
        value.append(reference());
      } else {
        value.append(isBlank(c) ? ' ' : c);
        at++;
      }
    }
  }

  private void endTag() throws XmlSyntaxException {
    final int start = at;
    at += 2;
    final String name = name(start);
    skipBlanks();
    expect('>', start, name);
    if (open.isEmpty()) {
      throw new XmlSyntaxException(start, "closesNothing", name);
    }
    final Element element = open.pop();
    if (!element.name().equals(name)) {
      final int line = problems.source().line(element.offset());
      throw new XmlSyntaxException(start, "closesOther", name, element.name(), line);
    }
    element.close(at);
  }

  private void expect(final char expected, final int start, final String name) throws XmlSyntaxException {
    if (at == text.length() || text.charAt(at) != expected) {
      throw new XmlSyntaxException(start, "markExpected", name, expected);
    }
    at++;
  }

  private String name(final int start) throws XmlSyntaxException {
    final int length = nameLength(at);
    if (length == 0) {
      throw new XmlSyntaxException(start, "strayMark", Messages.quote(text.substring(start, Math.min(start + 12,
          text.length()))));
    }
    at += length;
    return text.substring(at - length, at);
  }

  private int nameLength(final int from) {
    int i = from;
    while (i < text.length() && (isNameStart(text.charAt(i)) || i > from && isNamePart(text.charAt(i)))) {
      i++;
    }
    return i - from;
  }

  private static boolean isNameStart(final char c) {
    return c == ':' || c == '_' || Character.isLetter(c);
  }

  private static boolean isNamePart(final char c) {
    return c == '-' || c == '.' || c == '\u00b7' || Character.isLetterOrDigit(c);
  }

  private void skipBlanks() {
    while (at < text.length() && isBlank(text.charAt(at))) {
      at++;
    }
  }

  private static boolean isBlank(final char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
  }
}
