package scenes;

import java.io.StringReader;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;

import org.codehaus.stax2.XMLStreamReader2;

import com.ctc.wstx.api.ReaderConfig;
import com.ctc.wstx.stax.WstxInputFactory;

import arguments.Messages;

/**
 * Reads the markup of a scene file into a tree of elements with their places.
 *
 * <p>Woodstox reads the XML: it gives the exact start and end of each tag, comment and text. Its factory is instantiated
 * directly, because the service loader takes time. A DOCTYPE is refused, so that there are no entities but the five of
 * XML, and nothing outside the file is ever read. Reading ends at the first fault, which {@link SyntaxDiagnosis}
 * explains.
 */
final class MarkupReader {

  /** A comment: its text, without the delimiters, and its place. */
  record Comment(String text, int offset) {
  }

  /** Deepest nesting of elements; a limit keeps recursion over the tree shallow. */
  static final int DEEPEST = 200;

  private static final int COMMENT_MARK = "<!--".length();
  private static final int CDATA_MARK = "<![CDATA[".length();
  private static final int CDATA_END = "]]>".length();

  private final String text;
  private final Problems problems;
  private final List<Comment> comments = new ArrayList<>();
  private final Deque<Element> open = new ArrayDeque<>();
  private Element root;
  /** End of what has been read without a fault. */
  private int end;

  MarkupReader(final Problems problems) {
    this.text = problems.source().text();
    this.problems = problems;
  }

  /** The comments, in the order of the file; complete once it has been read. */
  List<Comment> comments() {
    return comments;
  }

  /** Reads the whole file and returns its document element. */
  Element read() throws XmlSyntaxException {
    try {
      final XMLStreamReader2 reader = (XMLStreamReader2) factory().createXMLStreamReader(new StringReader(text));
      end = text.startsWith("<?xml") ? text.indexOf("?>") + 2 : 0;
      while (reader.hasNext()) {
        take(reader, reader.next());
        end = offset(reader.getLocationInfo().getEndingCharOffset());
      }
      reader.close();
      return root;
    } catch (final XMLStreamException fault) {
      throw new SyntaxDiagnosis(problems, open, root).of(end, fault);
    }
  }

  private static WstxInputFactory factory() {
    final WstxInputFactory factory = new WstxInputFactory();
    final ReaderConfig config = factory.getConfig();
    config.doSupportNamespaces(false);
    config.doSupportDTDs(false);
    config.doParseLazily(false);
    return factory;
  }

  private static int offset(final long characters) {
    return Math.toIntExact(characters);
  }

  private void take(final XMLStreamReader2 reader, final int event) throws XMLStreamException, XmlSyntaxException {
    final int start = offset(reader.getLocationInfo().getStartingCharOffset());
    final int after = offset(reader.getLocationInfo().getEndingCharOffset());
    switch (event) {
      case XMLStreamConstants.START_ELEMENT -> startTag(reader, start);
      case XMLStreamConstants.END_ELEMENT -> open.pop().close(after);
      case XMLStreamConstants.COMMENT -> comments.add(new Comment(text.substring(start + COMMENT_MARK,
          after - "-->".length()), start));
      case XMLStreamConstants.CDATA -> open.peek().addText(text.substring(start + CDATA_MARK, after - CDATA_END),
          start + CDATA_MARK, true);
      case XMLStreamConstants.CHARACTERS, XMLStreamConstants.SPACE -> characters(reader, start, after);
      case XMLStreamConstants.DTD -> throw new XmlSyntaxException(start, "doctype",
          Messages.quote(text.substring(start, start + "<!DOCTYPE".length())));
      default -> { }
    }
  }

  private void startTag(final XMLStreamReader2 reader, final int start) throws XmlSyntaxException {
    final Element element = new Element(reader.getLocalName(), start, open.peek());
    if (element.depth() > DEEPEST) {
      throw new XmlSyntaxException(start, "deep", DEEPEST);
    }
    if (reader.getAttributeCount() > 0) {
      final StartTag tag = new StartTag(text, start);
      for (int i = 0; i < reader.getAttributeCount(); i++) {
        final String name = reader.getAttributeLocalName(i);
        element.attributes().add(new Element.Attribute(name, reader.getAttributeValue(i), tag.offset(name)));
      }
    }
    if (open.isEmpty()) {
      root = element;
    } else {
      open.peek().children().add(element);
    }
    open.push(element);
  }

  /** Adds text as the file has it, with its line ends, unless it contains references. */
  private void characters(final XMLStreamReader2 reader, final int start, final int after) {
    if (open.isEmpty()) {
      return;
    }
    final String run = text.substring(start, after);
    if (run.indexOf('&') < 0) {
      open.peek().addText(run, start, true);
    } else {
      final int blanks = run.length() - run.stripLeading().length();
      open.peek().addText(run.substring(0, blanks), start, true);
      open.peek().addText(reader.getText().stripLeading(), start + blanks, false);
    }
  }
}
