package diagnostics;

import java.nio.charset.Charset;
import java.nio.charset.IllegalCharsetNameException;
import java.nio.charset.UnsupportedCharsetException;

/** The encoding in which the virtual machine passes names to the system; it depends on the locale. */
public final class LocaleCharset {

  /** Replacement character for bytes of the command line that the virtual machine could not decode. */
  private static final char UNDECODED = '\ufffd';

  private static final String NAME = System.getProperty("sun.jnu.encoding", Charset.defaultCharset().name());

  private LocaleCharset() {
  }

  /**
   * Whether a name can be passed to the system.
   *
   * @param name the name of a file
   * @return false if it has characters that the locale cannot express
   */
  public static boolean canExpress(final String name) {
    try {
      return name.indexOf(UNDECODED) < 0 && Charset.forName(NAME).newEncoder().canEncode(name);
    } catch (final IllegalCharsetNameException | UnsupportedCharsetException | UnsupportedOperationException unknown) {
      return true;
    }
  }

  /**
   * The name of the encoding.
   *
   * @return the name, such as {@code ANSI_X3.4-1968} for the locale C
   */
  public static String name() {
    return NAME;
  }
}
