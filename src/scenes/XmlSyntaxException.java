package scenes;

import arguments.Messages;

/** A file is not well-formed XML: what follows cannot be interpreted. */
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
