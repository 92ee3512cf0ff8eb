package window;

import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.util.function.Consumer;
import java.util.function.Supplier;

import javax.swing.SwingUtilities;

/** Copies to the clipboard what takes time to make, without keeping the event dispatch thread waiting. */
final class ClipboardCopy {

  private final LatestOnlyExecutor background = new LatestOnlyExecutor("clipboard");
  private final Consumer<String> status;

  /** Shows messages by the given method, which is called on the event dispatch thread. */
  ClipboardCopy(final Consumer<String> status) {
    this.status = status;
  }

  /**
   * Copies a content made in the background. Of several that wait only the last is copied.
   *
   * @param content makes it
   * @param message shown once it is on the clipboard
   */
  void copy(final Supplier<Transferable> content, final String message) {
    background.execute(() -> {
      try {
        final Transferable made = content.get();
        SwingUtilities.invokeLater(() -> {
          put(made);
          status.accept(message);
        });
      } catch (final RuntimeException | Error failure) {
        SwingUtilities.invokeLater(() -> status.accept(Failure.problem(failure).toString()));
      }
    });
  }

  static void put(final String text) {
    put(new StringSelection(text));
  }

  private static void put(final Transferable content) {
    Toolkit.getDefaultToolkit().getSystemClipboard().setContents(content, null);
  }
}
