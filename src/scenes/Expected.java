package scenes;

import arguments.Messages;

/**
 * What was expected of a value; converted to text only when needed, as most files are valid.
 *
 * @param key key of the message
 * @param range the numbers allowed; null if it is not a number
 */
record Expected(String key, Range range) {

  static final Expected SECTION = new Expected("expectedSection", null);
  static final Expected BOOL = new Expected("expectedBool", null);
  static final Expected NAME = new Expected("expectedName", null);
  static final Expected COLOUR = new Expected("expectedColour", null);

  static Expected number(final Range range) {
    return new Expected("expectedNumber", range);
  }

  static Expected integer(final int minimum) {
    return new Expected("expectedInteger", new Range(minimum, true, Double.POSITIVE_INFINITY, false));
  }

  static Expected triple(final Range range) {
    return new Expected("expectedTriple", range);
  }

  /** The text, for the value of a name. */
  String text(final String name) {
    if (range == null) {
      return Messages.text("scenes." + key, name);
    }
    final String number = "expectedTriple".equals(key) ? "x" : name;
    return range.hasEnd() ? Messages.text("scenes." + key, range.about(number), range.example())
        : Messages.text("scenes." + key + "Any");
  }
}
