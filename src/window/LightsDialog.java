package window;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

import javax.swing.BorderFactory;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSlider;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;

import arguments.Messages;
import inspection.Numbers;
import lights.Light;
import scenes.SceneFile;
import upnatray.RenderJob;

/** Switches the lights of the picture on and off, and limits the depth of recursion; what was rendered once is kept. */
final class LightsDialog {

  private final RenderWindow window;
  private final RenderJob job;
  private final LightMixer mixer;
  private final JDialog dialog;
  private final List<JCheckBox> boxes = new ArrayList<>();
  private final Map<SelectiveSum.Effect, JCheckBox> effects = new EnumMap<>(SelectiveSum.Effect.class);
  private final JSlider depth;
  private final LatestOnlyExecutor background = new LatestOnlyExecutor("lights");
  private volatile Object request;

  /**
   * Opens for the lit picture that a window shows.
   *
   * @param names names of its lights
   */
  LightsDialog(final RenderWindow window, final RenderJob job, final List<String> names) {
    this.window = window;
    this.job = job;
    this.mixer = new LightMixer(job.scene(), job.image().getWidth(), job.image().getHeight());
    this.dialog = new JDialog(window.frame(), Messages.text("window.lights.title"));
    this.depth = new JSlider(0, Math.max(1, job.scene().recursionDepth()), job.scene().recursionDepth());
    dialog.setName("lights");
    depth.setName("lights.depth");
    depth.setMajorTickSpacing(1);
    depth.setPaintTicks(true);
    depth.setSnapToTicks(true);
    depth.setEnabled(job.scene().recursionDepth() > 0);
    depth.addChangeListener(event -> mix());
    layOut(names);
    dialog.setLocation(window.frame().getX() + 60, window.frame().getY() + 120);
    WindowPlacement.fit(dialog);
    dialog.setVisible(true);
  }

  /** Names the lights of a scene by number, class and position. */
  static List<String> names(final SceneFile scene) {
    final List<String> names = new ArrayList<>();
    for (final Light light : scene.lights().getLights()) {
      names.add(Messages.text("window.lights.light", names.size() + 1, light.getClass().getSimpleName(),
          Numbers.text(light.getPosition())));
    }
    return names;
  }

  private void layOut(final List<String> names) {
    final JPanel all = new JPanel(new BorderLayout(4, 8));
    all.setBorder(BorderFactory.createEmptyBorder(8, 12, 6, 12));
    all.add(list(names), BorderLayout.CENTER);
    all.add(bottom(), BorderLayout.SOUTH);
    dialog.add(all);
    dialog.getRootPane().registerKeyboardAction(event -> close(), KeyStroke.getKeyStroke("ESCAPE"),
        JComponent.WHEN_IN_FOCUSED_WINDOW);
    dialog.addWindowListener(new WindowAdapter() {
      @Override
      public void windowClosing(final WindowEvent event) {
        close();
      }
    });
    dialog.pack();
  }

  private JScrollPane list(final List<String> names) {
    final JPanel list = new JPanel();
    list.setLayout(new BoxLayout(list, BoxLayout.Y_AXIS));
    for (final String name : names) {
      final JCheckBox box = checkBox(name, String.valueOf(boxes.size() + 1));
      boxes.add(box);
      list.add(box);
    }
    final JScrollPane pane = new JScrollPane(list);
    final Dimension size = list.getPreferredSize();
    pane.setPreferredSize(new Dimension(size.width + 24, Math.min(260, size.height + 8)));
    return pane;
  }

  private JCheckBox checkBox(final String text, final String name) {
    final JCheckBox box = new JCheckBox(text, true);
    box.setName("lights." + name);
    box.addActionListener(event -> mix());
    return box;
  }

  private JPanel bottom() {
    final JPanel switches = new JPanel(new FlowLayout(FlowLayout.LEADING));
    for (final SelectiveSum.Effect effect : SelectiveSum.Effect.values()) {
      final JCheckBox box = checkBox(Messages.text("window.lights." + effect), effect.name());
      effects.put(effect, box);
      switches.add(box);
    }
    final JPanel buttons = new JPanel(new FlowLayout(FlowLayout.TRAILING));
    for (final Command command : List.of(Command.of("lights.all", "", () -> setAll(true)),
        Command.of("lights.none", "", () -> setAll(false)), Command.of("lights.close", "ESCAPE", this::close))) {
      buttons.add(new JButton(command)).setName(command.key());
    }
    final JPanel bottom = new JPanel(new BorderLayout(8, 0));
    final JLabel label = new JLabel(Messages.text("window.lights.depth"));
    label.setLabelFor(depth);
    bottom.add(switches, BorderLayout.NORTH);
    bottom.add(label, BorderLayout.WEST);
    bottom.add(depth, BorderLayout.CENTER);
    bottom.add(buttons, BorderLayout.SOUTH);
    return bottom;
  }

  private void setAll(final boolean on) {
    boxes.forEach(box -> box.setSelected(on));
    mix();
  }

  /** Shows the mixture over the picture as soon as it is there. */
  private void mix() {
    if (depth.getValueIsAdjusting()) {
      return;
    }
    final BitSet on = new BitSet();
    for (int i = 0; i < boxes.size(); i++) {
      on.set(i, boxes.get(i).isSelected());
    }
    final Set<SelectiveSum.Effect> omitted = EnumSet.noneOf(SelectiveSum.Effect.class);
    effects.forEach((effect, box) -> {
      if (!box.isSelected()) {
        omitted.add(effect);
      }
    });
    final int levels = Math.min(depth.getValue(), job.scene().recursionDepth());
    final Object mine = new Object();
    request = mine;
    background.execute(() -> {
      final var picture = mixer.mix(on, levels, omitted, () -> request != mine);
      SwingUtilities.invokeLater(() -> {
        if (request == mine && picture != null && window.shows(job)) {
          window.view().setPreview(picture);
        }
      });
    });
  }

  void close() {
    request = null;
    background.stop();
    if (window.shows(job)) {
      window.view().setPreview(null);
    }
    dialog.dispose();
  }
}
