package window;

import javax.swing.JComponent;

/** The keys of the wireframe view: arrows rotate it or, with shift, pan it; +, − and 0 zoom; escape closes it. */
final class WireframeKeys {

  private static final double DEGREES = 5;
  private static final double STEP = 1.25;
  private static final double DISTANCE = 24;

  private WireframeKeys() {
  }

  static void bind(final WireframeView view, final Runnable close) {
    bind(view, "LEFT", () -> view.turn(-DEGREES, 0));
    bind(view, "RIGHT", () -> view.turn(DEGREES, 0));
    bind(view, "UP", () -> view.turn(0, -DEGREES));
    bind(view, "DOWN", () -> view.turn(0, DEGREES));
    bind(view, "shift LEFT", () -> view.moveBy(-DISTANCE, 0));
    bind(view, "shift RIGHT", () -> view.moveBy(DISTANCE, 0));
    bind(view, "shift UP", () -> view.moveBy(0, -DISTANCE));
    bind(view, "shift DOWN", () -> view.moveBy(0, DISTANCE));
    bind(view, "typed 0", view::fit);
    bind(view, "ESCAPE", close);
    bind(view, "typed +", () -> view.zoomBy(STEP));
    bind(view, "typed -", () -> view.zoomBy(1 / STEP));
  }

  private static void bind(final WireframeView view, final String key, final Runnable job) {
    KeyAction.bind(view, JComponent.WHEN_IN_FOCUSED_WINDOW, key, job);
  }
}
