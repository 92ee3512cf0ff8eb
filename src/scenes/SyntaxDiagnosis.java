package scenes;

import java.util.Deque;

import javax.xml.stream.Location;
import javax.xml.stream.XMLStreamException;

import arguments.Messages;
import diagnostics.UnusualBlank;

/**
 * Explains what is wrong with a file that is not well-formed XML. Woodstox finds the first fault; the text after the last
 * well-formed part shows what was being read. Frequent kinds of faults have messages of their own, in both languages, at
 * the place where an author would look for them; for others the place is that which Woodstox reports.
 */
final class SyntaxDiagnosis {

  private static final String CDATA_START = "<![CDATA[";
  private static final String CDATA_END = "]]>";

  private final Problems problems;
  private final String text;
  private final Deque<Element> open;
  private final Element root;

  /**
   * A diagnosis of what has been read so far.
   *
   * @param problems problems of the file
   * @param open the elements that are open, the innermost first
   * @param root the document element; null before it
   */
  SyntaxDiagnosis(final Problems problems, final Deque<Element> open, final Element root) {
    this.problems = problems;
    this.text = problems.source().text();
    this.open = open;
    this.root = root;
  }

  /** The fault that Woodstox found somewhere after a place. */
  XmlSyntaxException of(final int sound, final XMLStreamException fault) {
    final int from = open.isEmpty() ? afterBlanks(sound) : sound;
    final int at = place(from, fault.getLocation());
    // Woodstox hands out the text before a fault in it first, and counts the faulty characters to it.
    final int illegal = illegalCharacter(Math.max(0, sound - 1), root == null ? text.length() : at + 1);
    if (illegal >= 0) {
      return new XmlSyntaxException(illegal, "character", Integer.toHexString(text.codePointAt(illegal)));
    }
    if (sound >= CDATA_END.length() && text.startsWith(CDATA_END, sound - CDATA_END.length())
        && text.lastIndexOf(CDATA_START, sound) <= text.lastIndexOf(CDATA_END, sound - CDATA_END.length() - 1)) {
      return new XmlSyntaxException(sound - CDATA_END.length(), "cdataEnd");
    }
    final XmlSyntaxException known = from < text.length() && text.charAt(from) == '<' ? ofMarkup(from, at)
        : ofCharacters(from, at);
    return known != null ? known : malformed(at);
  }

  private XmlSyntaxException malformed(final int at) {
    return at == text.length() ? new XmlSyntaxException(at, "endsEarly")
        : new XmlSyntaxException(at, "malformed", character(text, at));
  }

  private int afterBlanks(final int from) {
    int i = from;
    while (i < text.length() && isBlank(text.charAt(i))) {
      i++;
    }
    return i;
  }

  private int place(final int from, final Location location) {
    final int offset = location == null ? from : location.getCharacterOffset();
    return Math.min(Math.max(from, offset), text.length());
  }

  /** The first illegal character of XML in a range; -1 if none. */
  private int illegalCharacter(final int from, final int to) {
    for (int i = from; i < Math.min(to, text.length()); i++) {
      final char c = text.charAt(i);
      if (c < ' ' && !isBlank(c) || c >= '\ufffe') {
        return i;
      }
    }
    return -1;
  }

  private XmlSyntaxException ofMarkup(final int from, final int at) {
    if (text.startsWith("<!--", from)) {
      return ofComment(from);
    }
    if (text.startsWith(CDATA_START, from)) {
      return text.indexOf(CDATA_END, from) < 0 ? new XmlSyntaxException(from, "endless", "CDATA", CDATA_END) : outside(from);
    }
    if (text.startsWith("<!", from)) {
      return new XmlSyntaxException(from, "doctype", Messages.quote(text.substring(from,
          Math.min(from + "<!DOCTYPE".length(), text.length()))));
    }
    if (text.startsWith("<?", from)) {
      return ofInstruction(from);
    }
    return text.startsWith("</", from) ? ofEndTag(from) : ofStartTag(from, at);
  }

  private XmlSyntaxException ofComment(final int from) {
    final int dashes = text.indexOf("--", from + "<!--".length());
    return text.indexOf("-->", from + "<!--".length()) < 0 ? new XmlSyntaxException(from, "endless", "comment", "-->")
        : new XmlSyntaxException(dashes, "dashes");
  }

  private XmlSyntaxException ofInstruction(final int from) {
    final String target = StartTag.name(text, from + 2);
    final int end = text.indexOf("?>", from + 2);
    if (end < 0) {
      return new XmlSyntaxException(from, "endless", "<?", "?>");
    }
    if (target.equalsIgnoreCase("xml")) {
      return new XmlSyntaxException(from, from == 0 && target.equals("xml") ? "declarationWrong" : "declaration");
    }
    return new XmlSyntaxException(from, "instruction", Messages.quote(text.substring(from + 2, end)));
  }

  private XmlSyntaxException ofEndTag(final int from) {
    final String name = StartTag.name(text, from + 2);
    if (name.isEmpty()) {
      return strayMark(text, from);
    }
    final int after = afterBlanks(from + 2 + name.length());
    if (after == text.length() || text.charAt(after) != '>') {
      return new XmlSyntaxException(from, "markExpected", name, '>');
    }
    if (open.isEmpty()) {
      return new XmlSyntaxException(from, "closesNothing", name);
    }
    final Element element = open.peek();
    return element.name().equals(name) ? null : new XmlSyntaxException(from, "closesOther", name, element.name(),
        problems.source().line(element.offset()));
  }

  private XmlSyntaxException ofStartTag(final int from, final int at) {
    final StartTag tag = new StartTag(text, from);
    if (tag.fault() != null) {
      final XmlSyntaxException entity = tag.fault().offset() > at ? ofReference(from, at) : null;
      return entity != null ? entity : tag.fault();
    }
    if (open.isEmpty() && root != null) {
      return new XmlSyntaxException(from, "secondRoot", StartTag.name(text, from + 1), root.name());
    }
    return ofReference(from, at);
  }

  private XmlSyntaxException ofCharacters(final int from, final int at) {
    if (open.isEmpty()) {
      return outside(from);
    }
    final int mark = text.indexOf('<', from);
    final int end = mark < 0 ? text.length() : mark;
    final int cdataEnd = text.substring(from, end).indexOf(CDATA_END);
    if (cdataEnd >= 0 && from + cdataEnd <= at) {
      return new XmlSyntaxException(from + cdataEnd, "cdataEnd");
    }
    final XmlSyntaxException entity = ofReference(from, Math.min(at, end));
    if (text.lastIndexOf(CDATA_START) > text.lastIndexOf(CDATA_END)) {
      return new XmlSyntaxException(text.lastIndexOf(CDATA_START), "endless", "CDATA", CDATA_END);
    }
    return entity != null || mark >= 0 ? entity : new XmlSyntaxException(open.peek().offset(), "unclosed",
        open.peek().name());
  }

  /** Text where only comments may be; a file without any markup is reported as such. */
  private XmlSyntaxException outside(final int from) {
    if (text.isBlank()) {
      return new XmlSyntaxException(0, "emptyFile");
    }
    final int mark = text.indexOf('<', from + 1);
    final String stray = Messages.quote(text.substring(from, mark < 0 ? text.length() : mark));
    if (root != null || mark >= 0) {
      return new XmlSyntaxException(from, "outside", stray);
    }
    if (from < text.length()) {
      problems.error(from, "outside", stray);
    }
    return new XmlSyntaxException(0, "noElement", Messages.quote(text));
  }

  /** The last reference that begins in a range, if it is invalid; else null. */
  private XmlSyntaxException ofReference(final int from, final int to) {
    final int start = text.lastIndexOf('&', to);
    if (start < from) {
      return null;
    }
    int end = start + 1;
    while (end < text.length() && (Character.isLetterOrDigit(text.charAt(end)) || text.charAt(end) == '#')) {
      end++;
    }
    final boolean closed = end < text.length() && text.charAt(end) == ';';
    return new XmlSyntaxException(start, "entity", Messages.quote(text.substring(start, closed ? end + 1 : end)));
  }

  static XmlSyntaxException strayMark(final String text, final int from) {
    return new XmlSyntaxException(from, "strayMark", Messages.quote(text.substring(from,
        Math.min(from + 12, text.length()))));
  }

  /** The character at a place, for a message: one that is not ASCII is named, as it might be invisible. */
  static String character(final String text, final int at) {
    final int c = at < text.length() ? text.codePointAt(at) : ' ';
    return Messages.quote(Character.toString(c)) + (c > '~' ? " (" + UnusualBlank.name(c) + ")" : "");
  }

  static boolean isBlank(final char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
  }
}
