package window;

import java.awt.Toolkit;
import java.awt.event.ActionEvent;

import javax.swing.AbstractAction;
import javax.swing.KeyStroke;

import arguments.Messages;

/** Something the user can do, with its name and its explanation from the bundle, and a key. */
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

  /** With a key of its own, as {@link KeyStroke#getKeyStroke(String)} writes it; empty for none. */
  static Command of(final String key, final String stroke, final Runnable job) {
    return new Command(key, stroke.isEmpty() ? null : KeyStroke.getKeyStroke(stroke), job);
  }

  /** With a key that goes together with the system's key for menus. */
  static Command ofMenu(final String key, final int code, final Runnable job) {
    return new Command(key, KeyStroke.getKeyStroke(code, Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx()), job);
  }

  /** Its name in the bundle. */
  String key() {
    return (String) getValue(ACTION_COMMAND_KEY);
  }

  @Override
  public void actionPerformed(final ActionEvent event) {
    job.run();
  }
}
