package scenes;

import java.util.ArrayList;
import java.util.List;

import arguments.Messages;
import diagnostics.UnusualBlank;

/**
 * The values of the elements of a scene file. Each method looks for a value at any depth below an element, reports its
 * problems, and returns it; for a missing or invalid value it returns NaN, {@link #NONE} or null.
 */
final class Values {

  /** Stands for a missing or invalid whole number. */
  static final int NONE = Integer.MIN_VALUE;

  /** An element whose name the language misspells, and its correct spelling. */
  static final String AS_SPELT = "circunferenceRadius";
  static final String WELL_SPELT = "circumferenceRadius";

  /** A number of a text, with its place in the file. */
  private record Token(String text, int offset) {
  }

  private final Problems problems;
  private final List<MarkupReader.Comment> comments;

  Values(final Problems problems, final List<MarkupReader.Comment> comments) {
    this.problems = problems;
    this.comments = comments;
  }

  /** Where problems are reported. */
  Problems problems() {
    return problems;
  }

  boolean has(final Element element, final String name) {
    return named(element, name) != null;
  }

  /** The first element of a name below another; null if none. Further ones are reported. */
  Element optional(final Element element, final String name) {
    final Element first = named(element, name);
    if (first != null) {
      for (final Element other : element.findAll(first.name())) {
        if (other != first) {
          problems.warning(other.offset(), "repeated", name, element.name(), problems.source().line(first.offset()));
        }
      }
    }
    return first;
  }

  private static Element named(final Element element, final String name) {
    final Element first = element.find(name);
    return first == null && name.equals(AS_SPELT) ? element.find(WELL_SPELT) : first;
  }

  /** The first element of a name below another; if there is none, that is reported with what was expected. */
  Element required(final Element element, final String name, final Expected expected) {
    final Element found = optional(element, name);
    if (found == null) {
      missing(element, name, expected);
    }
    return found;
  }

  private void missing(final Element element, final String name, final Expected expected) {
    final int line = commentedOut(element, name);
    problems.error(element.offset(), "missing", element.name(), name, expected.text(name),
        line == 0 ? "" : " " + Messages.text("scenes.commentedOut", name, line));
  }

  /** Line of an element that is commented out within another; 0 if none. */
  private int commentedOut(final Element element, final String name) {
    if (problems.isFull()) {
      return 0;
    }
    for (int i = firstComment(element.offset()); i < comments.size() && comments.get(i).offset() < element.end(); i++) {
      final MarkupReader.Comment comment = comments.get(i);
      final int at = comment.text().indexOf('<' + name);
      final int after = at + name.length() + 1;
      if (at >= 0 && after < comment.text().length() && " \t\r\n/>".indexOf(comment.text().charAt(after)) >= 0) {
        return problems.source().line(comment.offset() + 4 + at);
      }
    }
    return 0;
  }

  /** Number of the first comment after an offset; they are in the order of the file. */
  private int firstComment(final int offset) {
    int from = 0, to = comments.size();
    while (from < to) {
      final int middle = (from + to) >>> 1;
      if (comments.get(middle).offset() > offset) {
        to = middle;
      } else {
        from = middle + 1;
      }
    }
    return from;
  }

  /** A required number; NaN if it is missing or out of range. */
  float number(final Element element, final String name, final Range range) {
    final Element found = required(element, name, Expected.number(range));
    return found == null ? Float.NaN : number(found, range);
  }

  /** An optional number, or its default; NaN if it is out of range. */
  float number(final Element element, final String name, final Range range, final float absent) {
    final Element found = optional(element, name);
    return found == null ? absent : number(found, range);
  }

  private float number(final Element value, final Range range) {
    return number(new Token(text(value).strip(), value.valueOffset()), value.name(), range);
  }

  private float number(final Token token, final String name, final Range range) {
    if (!Decimal.is(token.text)) {
      wrong(token, "notNumber", name, Expected.number(range));
      return Float.NaN;
    }
    final float number = Float.parseFloat(token.text);
    if (!Float.isFinite(number) || !range.contains(number)) {
      final float clamped = Decimal.clamped(token.text, number);
      final String key = clamped != number && range.contains(clamped) ? "beyondFloat" : "outOfRange";
      problems.error(token.offset, key, name, Messages.quote(token.text), Expected.number(range).text(name));
      return Float.NaN;
    }
    return number;
  }

  /** Reports a text that is not what was expected, or that is missing. */
  private void wrong(final Token token, final String key, final String name, final Expected expected) {
    if (token.text.isEmpty()) {
      problems.error(token.offset, "empty", name, expected.text(name));
    } else {
      problems.error(token.offset, key, name, Messages.quote(token.text), expected.text(name));
    }
  }

  /** A required whole number; {@link #NONE} if it is missing or below its minimum. */
  int integer(final Element element, final String name, final int minimum) {
    final Element found = required(element, name, Expected.integer(minimum));
    return found == null ? NONE : integer(found, minimum);
  }

  /** An optional whole number, or its default; {@link #NONE} if it is below its minimum. */
  int integer(final Element element, final String name, final int minimum, final int absent) {
    final Element found = optional(element, name);
    return found == null ? absent : integer(found, minimum);
  }

  private int integer(final Element value, final int minimum) {
    final String text = text(value).strip();
    final boolean sound = Decimal.isWhole(text);
    final double number = sound ? Double.parseDouble(text) : Double.NaN;
    if (!(number >= minimum && number <= Integer.MAX_VALUE)) {
      final String key = number > Integer.MAX_VALUE ? "beyondInteger" : sound ? "outOfRange" : "notInteger";
      wrong(new Token(text, value.valueOffset()), key, value.name(), Expected.integer(minimum));
      return NONE;
    }
    return (int) number;
  }

  /** A required truth value; false if it is missing. */
  boolean bool(final Element element, final String name) {
    final Element found = required(element, name, Expected.BOOL);
    return found != null && bool(found);
  }

  /** An optional truth value, or its default. */
  boolean bool(final Element element, final String name, final boolean absent) {
    final Element found = optional(element, name);
    return found == null ? absent : bool(found);
  }

  private boolean bool(final Element value) {
    final String text = text(value).strip();
    if (!text.equalsIgnoreCase("true") && !text.equalsIgnoreCase("false")) {
      wrong(new Token(text, value.valueOffset()), "notBool", value.name(), Expected.BOOL);
    }
    return text.equalsIgnoreCase("true");
  }

  /** Three required numbers; null if they are missing, or if one is out of range. */
  float[] triple(final Element element, final String name, final Range range) {
    final Element found = required(element, name, Expected.triple(range));
    return found == null ? null : triple(found, range);
  }

  /** Three optional numbers; null if they are missing, or if one is out of range. */
  float[] optionalTriple(final Element element, final String name, final Range range) {
    final Element found = optional(element, name);
    return found == null ? null : triple(found, range);
  }

  /** The three numbers of a value. */
  float[] triple(final Element value, final Range range) {
    final List<Token> tokens = tokens(value);
    if (tokens.size() < 3) {
      problems.error(value.valueOffset(), "tooFew", value.name(), tokens.size(), Messages.quote(value.text()),
          Expected.triple(range).text(value.name()));
      return null;
    }
    final float[] triple = new float[3];
    boolean sound = true;
    for (int i = 0; i < 3; i++) {
      triple[i] = number(tokens.get(i), value.name(), range);
      sound &= !Float.isNaN(triple[i]);
    }
    if (tokens.size() > 3) {
      problems.warning(tokens.get(3).offset, "tooMany", value.name(), Messages.quote(tokens.get(3).text));
    }
    return sound ? triple : null;
  }

  private List<Token> tokens(final Element value) {
    final String text = text(value);
    final List<Token> tokens = new ArrayList<>(4);
    int i = 0;
    while (i < text.length()) {
      final int start = i;
      while (i < text.length() && !Character.isWhitespace(text.charAt(i))) {
        i++;
      }
      if (i > start) {
        tokens.add(new Token(text.substring(start, i), value.textOffset(start)));
      }
      i++;
    }
    return tokens;
  }

  /** A required name or path; null if it is missing or blank. */
  String name(final Element element, final String name) {
    final Element found = required(element, name, Expected.NAME);
    return found == null ? null : name(found);
  }

  /** The text of a number or a truth value; a character that only looks like a blank counts as one, with a warning. */
  private String text(final Element value) {
    final String text = value.text();
    final int odd = UnusualBlank.indexIn(text);
    if (odd < 0) {
      return text;
    }
    problems.warning(value.textOffset(odd), "oddBlank", value.name(), UnusualBlank.name(text.charAt(odd)));
    return UnusualBlank.replaced(text);
  }

  /** The text of a value, without the blanks around it; null, which is an error, if there is nothing else. */
  String name(final Element value) {
    final int odd = UnusualBlank.indexIn(value.text());
    if (odd >= 0) {
      problems.warning(value.textOffset(odd), "oddBlankInName", value.name(), UnusualBlank.name(value.text().charAt(odd)));
    }
    final String text = UnusualBlank.stripped(value.text());
    if (text.isEmpty()) {
      problems.error(value.offset(), "empty", value.name(), Expected.NAME.text(value.name()));
      return null;
    }
    return text;
  }

  /** A required attribute, without the blanks around it; null if it is missing. */
  String attribute(final Element element, final String name) {
    final Element.Attribute attribute = element.attribute(name);
    final String value = attribute == null ? "" : UnusualBlank.stripped(attribute.value());
    final int odd = attribute == null ? -1 : UnusualBlank.indexIn(attribute.value());
    if (odd >= 0) {
      problems.warning(attribute.offset(), "oddBlankInName", name, UnusualBlank.name(attribute.value().charAt(odd)));
    }
    if (value.isEmpty()) {
      problems.error(element.offset(), "missingAttribute", element.name(), name);
      return null;
    }
    return value;
  }

  /** A required attribute that is one of some names; null if it is not. */
  String attribute(final Element element, final String name, final List<String> known) {
    final String value = attribute(element, name);
    if (value == null || known.contains(value)) {
      return value;
    }
    problems.error(element.attribute(name).offset(), "unknownType", element.name(), Messages.quote(value),
        String.join(", ", known), problems.didYouMean(value, known));
    return null;
  }

  /** An optional value that is one of some names, or its default; null if it is another. */
  String oneOf(final Element element, final String name, final List<String> known, final String absent) {
    final Element found = optional(element, name);
    final String value = found == null ? absent : name(found);
    if (value == null || known.contains(value)) {
      return value;
    }
    problems.error(found.valueOffset(), "unknownType", name, Messages.quote(value), String.join(", ", known),
        problems.didYouMean(value, known));
    return null;
  }
}
