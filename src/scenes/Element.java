package scenes;

import java.util.ArrayList;
import java.util.List;

import diagnostics.UnusualBlank;

/** An element of a scene file, with the places of its contents, counted in characters from the start of the file. */
final class Element {

  /** An attribute: its name, its value, and the place of its name. */
  record Attribute(String name, String value, int offset) {
  }

  private final String name;
  private final int offset;
  private final Element parent;
  private final int depth;
  private final List<Attribute> attributes = new ArrayList<>(2);
  private final List<Element> children = new ArrayList<>();
  private final StringBuilder text = new StringBuilder();
  private int textOffset;
  private int leadingBlanks;
  private boolean oneRun = true;
  private int end;

  Element(final String name, final int offset, final Element parent) {
    this.name = name;
    this.offset = offset;
    this.parent = parent;
    this.depth = parent == null ? 1 : parent.depth + 1;
    this.textOffset = offset;
  }

  String name() {
    return name;
  }

  /** Place of its {@code <}. */
  int offset() {
    return offset;
  }

  /** Place after its end tag. */
  int end() {
    return end;
  }

  Element parent() {
    return parent;
  }

  int depth() {
    return depth;
  }

  List<Attribute> attributes() {
    return attributes;
  }

  List<Element> children() {
    return children;
  }

  /** The text directly inside, without that of its children and without comments. */
  String text() {
    return text.toString();
  }

  /** Place of the i-th character of its text; where the text is in pieces, that of its first one that is not blank. */
  int textOffset(final int i) {
    return textOffset + (oneRun ? i : leadingBlanks);
  }

  /** Place of the first character of its text that is not blank; that of the element if there is none. */
  int valueOffset() {
    int i = 0;
    while (i < text.length() && UnusualBlank.isBlank(text.charAt(i))) {
      i++;
    }
    return i < text.length() ? textOffset(i) : offset;
  }

  /** Adds a piece of text; a piece that differs from the text of the file (an entity) ends the run. */
  void addText(final CharSequence piece, final int pieceOffset, final boolean verbatim) {
    final boolean first = blanks() == text.length();
    oneRun = verbatim && (first || oneRun && pieceOffset == textOffset + text.length());
    if (first) {
      text.setLength(0);
      textOffset = pieceOffset;
    }
    text.append(piece);
    leadingBlanks = first ? blanks() : leadingBlanks;
  }

  /** Number of blanks at the start of the text. */
  private int blanks() {
    int i = 0;
    while (i < text.length() && text.charAt(i) <= ' ') {
      i++;
    }
    return i;
  }

  void close(final int endOffset) {
    end = endOffset;
  }

  /** The attribute of a name, or null. */
  Attribute attribute(final String attributeName) {
    for (final Attribute attribute : attributes) {
      if (attribute.name().equals(attributeName)) {
        return attribute;
      }
    }
    return null;
  }

  /** The first element of a name at any depth below this one, in the order of the file; null if none. */
  Element find(final String elementName) {
    for (final Element child : children) {
      final Element found = child.name.equals(elementName) ? child : child.find(elementName);
      if (found != null) {
        return found;
      }
    }
    return null;
  }

  /** All elements of a name at any depth below this one, in the order of the file. */
  List<Element> findAll(final String elementName) {
    final List<Element> found = new ArrayList<>();
    collect(elementName, found);
    return found;
  }

  private void collect(final String elementName, final List<Element> found) {
    for (final Element child : children) {
      if (child.name.equals(elementName)) {
        found.add(child);
      }
      child.collect(elementName, found);
    }
  }
}
