package scenes;

import java.text.MessageFormat;
import java.util.ResourceBundle;
import java.util.regex.Pattern;

/** The messages of this package, in the language of the default locale (English, Spanish). */
final class Messages {

  /** More of a file than this is never quoted: it might not be a scene at all. */
  static final int LONGEST_QUOTE = 40;

  private static final Pattern CONTROL = Pattern.compile("[\\x00-\\x1f\\x7f-\\x9f]");

  private Messages() {
  }

  /** A message: one line, whatever stands in its parts. */
  static String text(final String key, final Object... parts) {
    final Object[] texts = new Object[parts.length];
    for (int i = 0; i < parts.length; i++) {
      texts[i] = onOneLine(String.valueOf(parts[i]));
    }
    return MessageFormat.format(ResourceBundle.getBundle("scenes.messages").getString(key), texts);
  }

  /** A piece of a file, fit for a message: on one line, no longer than forty characters, in backquotes. */
  static String quote(final String text) {
    final String trimmed = text.strip();
    final boolean cut = trimmed.length() > LONGEST_QUOTE;
    return "`" + onOneLine(cut ? trimmed.substring(0, LONGEST_QUOTE - 3) : trimmed) + (cut ? "...`" : "`");
  }

  /** A text with blanks for line ends and all else that moves the cursor of a terminal. */
  private static String onOneLine(final String text) {
    return CONTROL.matcher(text).replaceAll(" ");
  }
}
