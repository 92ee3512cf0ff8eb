package window;

import javax.swing.JComponent;

/** The keys of the scene from outside: arrows turn it or, with shift, move it; +, − and 0 set its size; escape closes it. */
final class WireframeKeys {

  private static final double DEGREES = 5;
  private static final double STEP = 1.25;
  private static final double FAR = 24;

  private WireframeKeys() {
  }

  static void bind(final WireframeView view, final Runnable close) {
    bind(view, "LEFT", () -> view.turn(-DEGREES, 0));
    bind(view, "RIGHT", () -> view.turn(DEGREES, 0));
    bind(view, "UP", () -> view.turn(0, -DEGREES));
    bind(view, "DOWN", () -> view.turn(0, DEGREES));
    bind(view, "shift LEFT", () -> view.moveBy(-FAR, 0));
    bind(view, "shift RIGHT", () -> view.moveBy(FAR, 0));
    bind(view, "shift UP", () -> view.moveBy(0, -FAR));
    bind(view, "shift DOWN", () -> view.moveBy(0, FAR));
    bind(view, "typed 0", view::fit);
    bind(view, "ESCAPE", close);
    bind(view, "typed +", () -> view.zoomBy(STEP));
    bind(view, "typed -", () -> view.zoomBy(1 / STEP));
  }

  private static void bind(final WireframeView view, final String key, final Runnable job) {
    KeyAction.bind(view, JComponent.WHEN_IN_FOCUSED_WINDOW, key, job);
  }
}
