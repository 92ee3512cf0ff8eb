package scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.StringReader;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;

import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import trials.Trials;

class MarkupReaderTest {

  /** Pieces of which files are composed: valid ones often, invalid ones sometimes. */
  private static final String[] PIECES = {"<a>", "</a>", "<b c='1'>", "</b>", "<d/>", "x ", "\n", "<!-- c "
      + "-->", "&lt;", "&#65;",
    "&#x41;", "<![CDATA[<x>]]>", "<?pi data?>", "<e f=\"&amp;\" g='h'/>", "ñ", " "
        + " ", "]]>", "&", "&nope;", "<", ">", "--", "'", "<a ",
    "<!--", "-->", "<d e='1' e='2'/>", "&#0;", "<1>", "\u0001", "<?xml version='1.0'?>"};
  private static final int GOOD = 16;

  private static Problems problems(final String text) {
    return new Problems(new SourceText("f", text));
  }

  private static Element read(final String text) throws XmlSyntaxException {
    final Problems problems = problems(text);
    final Element root = new MarkupReader(problems).read();
    assertEquals("[]", problems.inFileOrder().toString());
    return root;
  }

  @Test
  void everyThingKnowsItsPlace() throws XmlSyntaxException {
    final String text = "<?xml version='1.0'?>\n<a  b = \"x&amp;y\" c='2'><!-- no --> t <d/><e>\n 5 </e></a>\n<!-- end -->";
    final Element root = read(text);
    assertEquals("a", root.name());
    assertEquals(22, root.offset());
    assertEquals("x&y", root.attribute("b").value());
    assertEquals(26, root.attribute("b").offset());
    assertEquals("2", root.attribute("c").value());
    assertEquals("t", root.text().strip());
    assertEquals(2, root.children().size());
    final Element e = root.find("e");
    assertEquals("\n 5 ", e.text());
    assertEquals('5', text.charAt(e.valueOffset()));
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', quoteCharacter = '~', value = {
    "<a>|1:1: element `a` is never closed: expected `</a>`",
    "<a></b>|1:4: found `</b>`, expected `</a>`, which closes the element of line 1",
    "<a/></a>|1:5: `</a>` closes nothing: no element is open",
    "<a/><b/>|1:5: a second document element `b`: expected one, which is `a`",
    "<a b=1/>|1:4: the value of attribute `b` must be in quotes: expected `b=\"...\"`",
    "<a b='1/>|1:4: the value of attribute `b` is not terminated: expected `'`",
    "<a b='1'c='2'/>|1:9: in the tag `<a` found `c`, expected a blank and an attribute, or `>`",
    "<a b/>|1:4: after `b` expected `=`",
    "<a|1:1: the tag `<a` is not terminated: expected `>`",
    "<a/|1:1: after `a` expected `>`",
    "<a>< /a>|1:4: `< /a>` is not a tag: expected a name right after `<` (write `&lt;` for `<`)",
    "<a><!-- |1:4: `comment` is not terminated: expected `-->`",
    "<a><![CDATA[x</a>|1:4: `CDATA` is not terminated: expected `]]>`",
    "<!ENTITY x>|1:1: `<!ENTITY` is refused: a scene file has no document type and no entities of its own",
    "<a>&nope; &b</a>|1:4: `&nope;` is not an entity: expected `&lt;`, `&gt;`, `&amp;`, `&quot;`, `&apos;` or a number such "
        + "as `&#241;` (write `&amp;` for `&`)",
    "<a>x & y</a>|1:6: `&` is not an entity: expected `&lt;`, `&gt;`, `&amp;`, `&quot;`, `&apos;` or a number such "
        + "as `&#241;` (write `&amp;` for `&`)",
    "<a b='1 &c d'/>|1:9: `&c` is not an entity: expected `&lt;`, `&gt;`, `&amp;`, `&quot;`, `&apos;` or a number such "
        + "as `&#241;` (write `&amp;` for `&`)",
    "<a b='1' b='2'/>|1:10: attribute `b` is given twice: expected once",
    "<a><!-- -- --></a>|1:9: `--` must not occur within a comment",
    "<a>]]></a>|1:4: `]]>` must not occur in text: write `]]&gt;`",
    "<a/>x|1:5: `x` is outside the document element: expected only comments before and after it",
    "<a>\u0001</a>|1:4: the character of code 1 (hexadecimal) must not occur in XML: is this a scene file?",
    "<a b='\u0002'/>|1:7: the character of code 2 (hexadecimal) must not occur in XML: is this a scene file?",
    "<a>b</a\u00b5>|1:5: found `</a\u00b5>`, expected `</a>`, which closes the element of line 1",
    "<a>b<c\u00b5/></a>|1:7: this is not well-formed XML: `\u00b5` (U+00B5 MICRO SIGN) is out of place here",
    "<?xml versio='1.0'?><a/>|1:1: the XML declaration is malformed: expected `<?xml version=\"1.0\" encoding=\"UTF-8\"?>`",
    "<!-- --><?xml version='1.0'?><a/>|1:9: the XML declaration `<?xml ...?>` must be the very first thing in the file, "
        + "without anything before it"})
  void theFirstFaultEndsTheReading(final String text, final String message) {
    final Problems problems = problems(text);
    final XmlSyntaxException malformed = assertThrows(XmlSyntaxException.class, () -> new MarkupReader(problems).read());
    assertEquals(message, problems.source().line(malformed.offset()) + ":"
        + problems.source().column(malformed.offset()) + ": "
        + malformed.getMessage());
  }

  @Test
  void depthHasALimit() throws XmlSyntaxException {
    final int depth = MarkupReader.DEEPEST;
    read("<a>".repeat(depth) + "</a>".repeat(depth));
    assertThrows(XmlSyntaxException.class, () -> read("<a>".repeat(depth + 1) + "</a>".repeat(depth + 1)));
    assertThrows(XmlSyntaxException.class, () -> read("<a>".repeat(1_000_000)));
  }

  /** The reader of the JDK is the oracle: both accept a file, and see the same in it, or neither does. */
  @Test
  void agreesWithTheReaderOfTheJdk() {
    final AtomicInteger accepted = new AtomicInteger();
    final AtomicInteger refused = new AtomicInteger();
    Trials.of(20_000, random -> {
      final String text = text(random);
      final String expected = jdk(text);
      assertEquals(expected, ours(text), text);
      (expected.equals("refused") ? refused : accepted).incrementAndGet();
    });
    assertTrue(accepted.get() > 4_000, accepted.toString());
    assertTrue(refused.get() > 4_000, refused.toString());
  }

  private static String text(final Random random) {
    final StringBuilder text = new StringBuilder("<r>");
    final StringBuilder open = new StringBuilder();
    final int length = random.nextInt(12);
    for (int i = 0; i < length; i++) {
      final String piece = PIECES[random.nextInt(random.nextInt(8) == 0 ? PIECES.length : GOOD)];
      if (piece.equals("</a>") || piece.equals("</b>")) {
        if (open.length() > 0) {
          text.append("</").append(open.charAt(open.length() - 1)).append('>');
          open.setLength(open.length() - 1);
        }
      } else {
        text.append(piece);
        open.append(piece.equals("<a>") ? "a" : piece.startsWith("<b") ? "b" : "");
      }
    }
    while (open.length() > 0) {
      text.append("</").append(open.charAt(open.length() - 1)).append('>');
      open.setLength(open.length() - 1);
    }
    return text + "</r>";
  }

  private static String jdk(final String text) {
    final StringBuilder seen = new StringBuilder();
    try {
      final XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
      factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
      final XMLStreamReader reader = factory.createXMLStreamReader(new StringReader(text));
      while (reader.hasNext()) {
        switch (reader.next()) {
          case XMLStreamReader.START_ELEMENT -> {
            seen.append('<').append(reader.getLocalName());
            for (int i = 0; i < reader.getAttributeCount(); i++) {
              seen.append(' ').append(reader.getAttributeLocalName(i)).append('=').append(reader.getAttributeValue(i));
            }
            seen.append('>');
          }
          case XMLStreamReader.END_ELEMENT -> seen.append("</>");
          default -> { }
        }
      }
      return seen.toString();
    } catch (final XMLStreamException wrong) {
      return "refused";
    }
  }

  private static String ours(final String text) {
    final Problems problems = problems(text);
    try {
      final Element root = new MarkupReader(problems).read();
      final StringBuilder seen = new StringBuilder();
      describe(root, seen);
      return problems.hasErrors() ? "refused" : seen.toString();
    } catch (final XmlSyntaxException wrong) {
      return "refused";
    }
  }

  private static void describe(final Element element, final StringBuilder seen) {
    seen.append('<').append(element.name());
    for (final Element.Attribute attribute : element.attributes()) {
      seen.append(' ').append(attribute.name()).append('=').append(attribute.value());
    }
    seen.append('>');
    for (final Element child : element.children()) {
      describe(child, seen);
    }
    seen.append("</>");
  }
}
