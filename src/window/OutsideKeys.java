package window;

import java.awt.event.ActionEvent;

import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/** The keys of the scene from outside: arrows turn it, + and − change its size. */
final class OutsideKeys extends AbstractAction {

  private static final long serialVersionUID = 1L;

  private static final double DEGREES = 5;
  private static final double STEP = 1.25;

  private final transient Runnable job;

  private OutsideKeys(final Runnable job) {
    this.job = job;
  }

  static void bind(final OutsideView view) {
    bind(view, "LEFT", () -> view.turn(-DEGREES, 0));
    bind(view, "RIGHT", () -> view.turn(DEGREES, 0));
    bind(view, "UP", () -> view.turn(0, -DEGREES));
    bind(view, "DOWN", () -> view.turn(0, DEGREES));
    bind(view, "typed +", () -> view.zoomBy(STEP));
    bind(view, "typed -", () -> view.zoomBy(1 / STEP));
  }

  private static void bind(final OutsideView view, final String key, final Runnable job) {
    view.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke(key), key);
    view.getActionMap().put(key, new OutsideKeys(job));
  }

  @Override
  public void actionPerformed(final ActionEvent event) {
    job.run();
  }
}
