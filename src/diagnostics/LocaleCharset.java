package diagnostics;

import java.nio.charset.Charset;
import java.nio.charset.IllegalCharsetNameException;
import java.nio.charset.UnsupportedCharsetException;

/** The encoding in which the virtual machine passes names to the system; the locale decides on it. */
public final class LocaleCharset {

  /** What stands for bytes that could not be decoded when the virtual machine read the command line. */
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
