package upnatray;

import java.io.Console;
import java.lang.reflect.InvocationTargetException;

/** A line on the terminal that shows how much of a picture is done; nothing where the output is not a terminal. */
final class ProgressLine {

  private static final long NANOSECONDS_BETWEEN = 100_000_000;

  private final boolean shown = isTerminal();
  private final String name;
  private final long total;
  private long done;
  private long last = System.nanoTime();
  private int length;

  ProgressLine(final String name, final long total) {
    this.name = name;
    this.total = total;
  }

  /** From JDK 22 on there may be a console that is not a terminal, which a newer method reports. */
  private static boolean isTerminal() {
    final Console console = System.console();
    try {
      return console != null && (boolean) Console.class.getMethod("isTerminal").invoke(console);
    } catch (final NoSuchMethodException older) {
      return true;
    } catch (final IllegalAccessException | InvocationTargetException unknown) {
      return false;
    }
  }

  /** Counts finished pixels, and shows their number every tenth of a second. */
  synchronized void add(final int pixels) {
    done += pixels;
    if (shown && System.nanoTime() - last > NANOSECONDS_BETWEEN) {
      last = System.nanoTime();
      final String text = name + "  " + 100 * done / total + " %";
      length = text.length();
      System.err.print("\r" + text);
      System.err.flush();
    }
  }

  /** Clears the line for other output. */
  synchronized void clear() {
    if (length > 0) {
      System.err.print("\r" + " ".repeat(length) + "\r");
      System.err.flush();
    }
  }
}
