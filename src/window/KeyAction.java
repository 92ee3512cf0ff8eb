package window;

import java.awt.EventQueue;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;

import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/** What a key does in a component. */
final class KeyAction extends AbstractAction {

  private static final long serialVersionUID = 1L;

  private final transient Runnable job;

  private KeyAction(final Runnable job) {
    this.job = job;
  }

  /** Binds a key, as {@link KeyStroke#getKeyStroke(String)} writes it, under a condition of {@link JComponent}. */
  static void bind(final JComponent component, final int condition, final String key, final Runnable job) {
    component.getInputMap(condition).put(KeyStroke.getKeyStroke(key), key);
    component.getActionMap().put(key, new KeyAction(job));
  }

  /** A key of a menu types its character too. */
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
