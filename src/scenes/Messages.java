package scenes;

import java.text.MessageFormat;
import java.util.ResourceBundle;

/** The messages of this package, in the language of the default locale (English, Spanish). */
final class Messages {

  /** More of a file than this is never quoted: it might not be a scene at all. */
  static final int LONGEST_QUOTE = 40;

  private Messages() {
  }

  static String text(final String key, final Object... parts) {
    final Object[] texts = new Object[parts.length];
    for (int i = 0; i < parts.length; i++) {
      texts[i] = String.valueOf(parts[i]);
    }
    return MessageFormat.format(ResourceBundle.getBundle("scenes.messages").getString(key), texts);
  }

  /** A piece of a file, fit for a message: on one line, no longer than forty characters, in backquotes. */
  static String quote(final String text) {
    final StringBuilder quoted = new StringBuilder("`");
    final String trimmed = text.strip();
    final boolean cut = trimmed.length() > LONGEST_QUOTE;
    final int end = cut ? LONGEST_QUOTE - 3 : trimmed.length();
    for (int i = 0; i < end; i++) {
      final char c = trimmed.charAt(i);
      quoted.append(Character.isISOControl(c) ? ' ' : c);
    }
    return quoted.append(cut ? "...`" : "`").toString();
  }
}
