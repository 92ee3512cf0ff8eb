package window;

import java.awt.event.KeyEvent;

import javax.swing.JComponent;
import javax.swing.JMenu;

/** The commands and keys that move the camera. */
final class CameraMenu {

  private static final double STEP = 12;
  private static final double PART = 0.04;
  private static final double FACTOR = 1.1;

  private CameraMenu() {
  }

  static void fill(final JMenu menu, final CameraControl camera) {
    menu.add(Command.of("camera.home", "HOME", camera::home));
    menu.addSeparator();
    menu.add(Command.of("camera.nearer", "PAGE_UP", () -> camera.nearer(FACTOR)));
    menu.add(Command.of("camera.farther", "PAGE_DOWN", () -> camera.nearer(1 / FACTOR)));
    menu.add(Command.of("camera.wider", "shift PAGE_DOWN", () -> camera.widen(FACTOR)));
    menu.add(Command.of("camera.narrower", "shift PAGE_UP", () -> camera.widen(1 / FACTOR)));
    menu.addSeparator();
    for (final CameraPose.Optics kind : CameraPose.Optics.values()) {
      menu.add(Command.of("camera." + kind, "ctrl shift " + (kind.ordinal() + 1), () -> camera.setProjection(kind)));
    }
    menu.addSeparator();
    menu.add(Command.of("camera.copyXml", "ctrl shift X", camera::copyXml));
    menu.add(Command.of("camera.copyJava", "ctrl shift J", camera::copyJava));
    menu.add(Command.ofMenu("camera.write", KeyEvent.VK_W, camera::write));
    menu.add(Command.ofMenu("camera.undo", KeyEvent.VK_Z, camera::undo));
  }

  /** Alt and arrows turn the camera while the picture has the focus, with shift they move it. */
  static void bindKeys(final PictureView view, final CameraControl camera) {
    bind(view, "alt LEFT", () -> camera.turn(-STEP, 0));
    bind(view, "alt RIGHT", () -> camera.turn(STEP, 0));
    bind(view, "alt UP", () -> camera.turn(0, -STEP));
    bind(view, "alt DOWN", () -> camera.turn(0, STEP));
    bind(view, "shift alt LEFT", () -> camera.move(-PART, 0));
    bind(view, "shift alt RIGHT", () -> camera.move(PART, 0));
    bind(view, "shift alt UP", () -> camera.move(0, -PART));
    bind(view, "shift alt DOWN", () -> camera.move(0, PART));
  }

  private static void bind(final PictureView view, final String key, final Runnable job) {
    KeyAction.bind(view, JComponent.WHEN_FOCUSED, key, job);
  }
}
