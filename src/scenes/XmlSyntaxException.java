package scenes;

import arguments.Messages;

/** The end of the reading of a file: it is no well-formed XML, and what follows cannot be told apart. */
final class XmlSyntaxException extends Exception {

  private static final long serialVersionUID = 1L;

  private final int offset;

  XmlSyntaxException(final int offset, final String key, final Object... parts) {
    super(Messages.text("scenes." + key, parts));
    this.offset = offset;
  }

  int offset() {
    return offset;
  }
}
