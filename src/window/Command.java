package window;

import java.awt.Toolkit;
import java.awt.event.ActionEvent;

import javax.swing.AbstractAction;
import javax.swing.KeyStroke;

import arguments.Messages;

/** An action of the window: its name and tooltip come from the message bundle. */
final class Command extends AbstractAction {

  private static final long serialVersionUID = 1L;

  private final transient Runnable job;

  private Command(final String key, final KeyStroke stroke, final Runnable job) {
    super(Messages.text("window." + key + ".text"));
    this.job = job;
    final String tip = Messages.text("window." + key + ".tip");
    putValue(ACTION_COMMAND_KEY, key);
    putValue(SHORT_DESCRIPTION, tip);
    putValue(ACCELERATOR_KEY, stroke);
  }

  /** An action with a key stroke in the notation of {@link KeyStroke#getKeyStroke(String)}; empty for none. */
  static Command of(final String key, final String stroke, final Runnable job) {
    return new Command(key, stroke.isEmpty() ? null : KeyStroke.getKeyStroke(stroke), job);
  }

  /** An action whose key is combined with the platform's menu shortcut key (Ctrl, or Command on a Mac). */
  static Command ofMenu(final String key, final int code, final Runnable job) {
    return new Command(key, KeyStroke.getKeyStroke(code, Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx()), job);
  }

  /** Its key in the message bundle. */
  String key() {
    return (String) getValue(ACTION_COMMAND_KEY);
  }

  @Override
  public void actionPerformed(final ActionEvent event) {
    job.run();
  }
}
