package arguments;

import java.text.MessageFormat;
import java.util.ResourceBundle;
import java.util.regex.Pattern;

/**
 * The messages of the program, in the language of the default locale (English, Spanish). Each package keeps its own in a
 * resource bundle {@code messages}.
 */
public final class Messages {

  /** Length in characters beyond which a quotation is cut: the quoted file might not be text at all. */
  public static final int LONGEST_QUOTE = 40;

  private static final Pattern CONTROL = Pattern.compile("[\\x00-\\x1f\\x7f-\\x9f]");

  private Messages() {
  }

  /**
   * A message, on one line whatever its parts contain.
   *
   * @param key the package whose bundle holds the message, a dot, and the key in that bundle
   * @param parts the values for {@code {0}}, {@code {1}} and so on, converted by {@link String#valueOf(Object)}
   * @return the text
   * @throws java.util.MissingResourceException if there is no such message
   */
  public static String text(final String key, final Object... parts) {
    final int dot = key.indexOf('.');
    final Object[] texts = new Object[parts.length];
    for (int i = 0; i < parts.length; i++) {
      texts[i] = onOneLine(String.valueOf(parts[i]));
    }
    final ResourceBundle bundle = ResourceBundle.getBundle(key.substring(0, dot) + ".messages");
    return MessageFormat.format(bundle.getString(key.substring(dot + 1)), texts);
  }

  /**
   * A piece of a file as a message quotes it: on one line, at most {@value #LONGEST_QUOTE} characters, in backquotes.
   *
   * @param text the piece
   * @return the quotation
   */
  public static String quote(final String text) {
    final String trimmed = text.strip();
    final boolean cut = trimmed.length() > LONGEST_QUOTE;
    return "`" + onOneLine(cut ? trimmed.substring(0, LONGEST_QUOTE - 3) : trimmed) + (cut ? "...`" : "`");
  }

  /** The text with a blank for each line end and each other control character, which could move a terminal's cursor. */
  private static String onOneLine(final String text) {
    return CONTROL.matcher(text).replaceAll(" ");
  }
}
