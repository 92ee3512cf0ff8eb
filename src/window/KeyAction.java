package window;

import java.awt.EventQueue;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;

import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/** Binds a key of a component to an action. */
final class KeyAction extends AbstractAction {

  private static final long serialVersionUID = 1L;

  private final transient Runnable job;

  private KeyAction(final Runnable job) {
    this.job = job;
  }

  /** Binds a key, in the notation of {@link KeyStroke#getKeyStroke(String)}, under a condition of {@link JComponent}. */
  static void bind(final JComponent component, final int condition, final String key, final Runnable job) {
    component.getInputMap(condition).put(KeyStroke.getKeyStroke(key), key);
    component.getActionMap().put(key, new KeyAction(job));
  }

  /** Ignores the character that a menu shortcut also types. */
  @Override
  public boolean accept(final Object sender) {
    return !(EventQueue.getCurrentEvent() instanceof KeyEvent event && event.getID() == KeyEvent.KEY_TYPED
        && event.isControlDown());
  }

  @Override
  public void actionPerformed(final ActionEvent event) {
    job.run();
  }
}
