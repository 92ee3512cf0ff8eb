package window;

import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.Map;

import javax.swing.ButtonGroup;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.KeyStroke;

import arguments.Messages;
import rendering.RenderPass;

/** The menus, which hold every command of the window with its key. */
final class MenuBar extends JMenuBar {

  private static final long serialVersionUID = 1L;

  private static final double STEP = 2;

  private final transient RenderWindow window;
  private final JMenu recent = menu("recent");
  private final transient Map<RenderPass, JMenuItem> passes = new EnumMap<>(RenderPass.class);
  private final transient Map<Samples, JMenuItem> samples = new HashMap<>();

  MenuBar(final RenderWindow window) {
    this.window = window;
    add(fileMenu());
    add(viewMenu());
    add(pixelMenu());
    final JMenu camera = menu("camera");
    CameraMenu.fill(camera, window.camera());
    add(camera);
    CameraMenu.bindKeys(window.view(), window.camera());
    fillRecent();
    bindKeys(window.view());
  }

  private static JMenu menu(final String key) {
    final JMenu menu = new JMenu(Messages.text("window." + key + ".text"));
    menu.setName(key);
    menu.setMnemonic(Messages.text("window." + key + ".mnemonic").charAt(0));
    return menu;
  }

  private JMenu fileMenu() {
    final JMenu menu = menu("file");
    menu.add(Command.ofMenu("open", KeyEvent.VK_O, window::chooseScene));
    menu.add(recent);
    menu.addSeparator();
    menu.add(window.renderCommand());
    menu.add(window.cancelCommand());
    menu.addSeparator();
    menu.add(Command.ofMenu("save", KeyEvent.VK_S, window::choosePicture));
    menu.add(Command.ofMenu("copy", KeyEvent.VK_C, window::copyPicture));
    menu.add(Command.ofMenu("compare", KeyEvent.VK_D, window::chooseReference));
    menu.addSeparator();
    menu.add(Command.ofMenu("quit", KeyEvent.VK_Q, window::close));
    return menu;
  }

  /** Lists the recently opened scenes. */
  void fillRecent() {
    recent.removeAll();
    for (final Path path : window.settings().recent()) {
      final JMenuItem item = recent.add(path.toString());
      item.addActionListener(event -> window.open(path));
    }
    if (recent.getItemCount() == 0) {
      recent.add(Messages.text("window.recent.none")).setEnabled(false);
    }
  }

  private JMenu viewMenu() {
    final JMenu menu = menu("view");
    final ButtonGroup group = new ButtonGroup();
    for (final RenderPass pass : RenderPass.values()) {
      final JMenuItem item = new JRadioButtonMenuItem(
          Command.of("pass." + pass, "alt " + (pass.ordinal() + 1), () -> window.setPass(pass)));
      item.setSelected(pass == window.session().pass());
      group.add(item);
      passes.put(pass, menu.add(item));
    }
    menu.add(samplesMenu());
    menu.addSeparator();
    menu.add(Command.ofMenu("fit", KeyEvent.VK_0, window.view()::fit));
    menu.add(Command.ofMenu("oneToOne", KeyEvent.VK_1, window.view()::oneToOne));
    menu.add(Command.ofMenu("zoomIn", KeyEvent.VK_PLUS, () -> window.view().zoomBy(STEP)));
    menu.add(Command.ofMenu("zoomOut", KeyEvent.VK_MINUS, () -> window.view().zoomBy(1 / STEP)));
    menu.addSeparator();
    menu.add(Command.ofMenu("wireframe", KeyEvent.VK_E, window::showWireframe));
    menu.add(Command.ofMenu("lights", KeyEvent.VK_G, window::showLights));
    final JCheckBoxMenuItem dark = new JCheckBoxMenuItem(Command.ofMenu("dark", KeyEvent.VK_L, window::switchTheme));
    dark.setSelected(window.settings().isDark());
    menu.add(dark);
    return menu;
  }

  private JMenu samplesMenu() {
    final JMenu menu = menu("samples");
    final ButtonGroup group = new ButtonGroup();
    for (final Samples choice : Samples.CHOICES) {
      final JMenuItem item = new JRadioButtonMenuItem(choice.toString(), choice.equals(window.session().samples()));
      item.setAccelerator(KeyStroke.getKeyStroke(choice.key()));
      item.setToolTipText(Messages.text("window.samples.tip"));
      item.addActionListener(event -> window.setSamples(choice));
      group.add(item);
      samples.put(choice, menu.add(item));
    }
    return menu;
  }

  private JMenu pixelMenu() {
    final JMenu menu = menu("pixel");
    menu.add(Command.of("pin", "ctrl P", () -> window.view().pinNeighbour(0, 0)));
    menu.add(Command.of("unpin", "ctrl U", window::unpin));
    menu.add(Command.ofMenu("copyTest", KeyEvent.VK_T, window.inspector()::copyTest));
    return menu;
  }

  /** Marks the current pass. */
  void select(final RenderPass pass) {
    passes.get(pass).setSelected(true);
  }

  /** Marks the current number of samples. */
  void select(final Samples choice) {
    samples.get(choice).setSelected(true);
  }

  /** Binds the keys of the focused picture: arrows pin the neighbouring pixel, with shift they pan the picture. */
  private static void bindKeys(final PictureView view) {
    final int distance = 48;
    bind(view, "LEFT", () -> view.pinNeighbour(-1, 0));
    bind(view, "RIGHT", () -> view.pinNeighbour(1, 0));
    bind(view, "UP", () -> view.pinNeighbour(0, -1));
    bind(view, "DOWN", () -> view.pinNeighbour(0, 1));
    bind(view, "ENTER", () -> view.pinNeighbour(0, 0));
    bind(view, "shift LEFT", () -> view.moveBy(distance, 0));
    bind(view, "shift RIGHT", () -> view.moveBy(-distance, 0));
    bind(view, "shift UP", () -> view.moveBy(0, distance));
    bind(view, "shift DOWN", () -> view.moveBy(0, -distance));
    bind(view, "typed +", () -> view.zoomBy(STEP));
    bind(view, "typed -", () -> view.zoomBy(1 / STEP));
    for (final String plus : new String[] {"ctrl ADD", "ctrl EQUALS", "ctrl shift EQUALS"}) {
      bind(view, plus, () -> view.zoomBy(STEP));
    }
    bind(view, "ctrl SUBTRACT", () -> view.zoomBy(1 / STEP));
    bind(view, "typed 0", view::fit);
    bind(view, "typed 1", view::oneToOne);
  }

  private static void bind(final PictureView view, final String key, final Runnable job) {
    KeyAction.bind(view, JComponent.WHEN_FOCUSED, key, job);
  }
}
