package window;

import java.text.MessageFormat;
import java.util.ResourceBundle;

/** The texts of the window, in the language of the default locale (English, Spanish). */
final class Messages {

  private Messages() {
  }

  static String text(final String key, final Object... parts) {
    final Object[] texts = new Object[parts.length];
    for (int i = 0; i < parts.length; i++) {
      texts[i] = String.valueOf(parts[i]);
    }
    return MessageFormat.format(ResourceBundle.getBundle("window.messages").getString(key), texts);
  }
}
