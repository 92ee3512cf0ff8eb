package window;

import java.awt.Component;
import java.awt.event.ActionListener;
import java.util.List;
import java.util.Optional;

import javax.swing.DefaultListCellRenderer;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JToolBar;

import arguments.Messages;
import rendering.RenderPass;

/** The tool bar with the most frequent commands, the size of the picture and the pass. */
final class ToolBar extends JToolBar {

  private static final long serialVersionUID = 1L;

  private final transient RenderWindow window;
  private final JComboBox<String> size = new JComboBox<>(new String[] {"25 %", "50 %", "100 %", "200 %", "640 x 480",
      "1920 x 1080"});
  private final JComboBox<Samples> samples = new JComboBox<>(Samples.CHOICES.toArray(new Samples[0]));
  private final JComboBox<RenderPass> pass = new JComboBox<>(RenderPass.values());
  private boolean selecting;

  ToolBar(final RenderWindow window) {
    this.window = window;
    setName("tools");
    setFloatable(false);
    final JButton open = addButton("open", window::chooseScene), render = new JButton(window.renderCommand());
    add(render).setName("render");
    final JButton save = addButton("save", window::choosePicture);
    addSeparator();
    size.setName("size");
    size.setEditable(true);
    size.setSelectedItem(PictureSize.OWN.toString());
    size.setMaximumSize(size.getPreferredSize());
    addLabelled("size", size, event -> applySize());
    addSeparator();
    samples.setName("samples");
    samples.setMaximumSize(samples.getPreferredSize());
    addLabelled("samples", samples, event -> applySamples());
    addSeparator();
    pass.setName("pass");
    pass.setSelectedItem(window.session().pass());
    pass.setRenderer(new PassNames());
    pass.setMaximumSize(pass.getPreferredSize());
    addLabelled("pass", pass, event -> applyPass());
    addSeparator();
    final JButton fit = addButton("fit", () -> window.view().fit());
    final JButton oneToOne = addButton("oneToOne", () -> window.view().oneToOne());
    final JButton wireframe = addButton("wireframe", window::showWireframe);
    final JButton compare = addButton("compare", window::chooseReference);
    setLayout(new ToolBarLayout(List.of(compare, save, open, oneToOne, wireframe, fit, render)));
  }

  private JButton addButton(final String key, final Runnable job) {
    final JButton button = new JButton(Command.of(key, "", job));
    button.setName(key);
    add(button);
    return button;
  }

  private void addLabelled(final String key, final JComboBox<?> box, final ActionListener listener) {
    final JLabel label = new JLabel(Messages.text("window." + key + ".label") + " ");
    label.setLabelFor(box);
    box.setToolTipText(Messages.text("window." + key + ".tip"));
    box.getAccessibleContext().setAccessibleName(Messages.text("window." + key + ".label"));
    box.addActionListener(listener);
    add(label);
    add(box);
  }

  /** Applies the size chosen or typed; an invalid size restores the previous one. */
  private void applySize() {
    final Optional<PictureSize> wanted = PictureSize.of(String.valueOf(size.getSelectedItem()));
    if (wanted.isPresent()) {
      window.setPictureSize(wanted.get());
    } else {
      select(window.session().size());
    }
  }

  private void applyPass() {
    if (!selecting && pass.getSelectedItem() instanceof RenderPass next && next != window.session().pass()) {
      window.setPass(next);
    }
  }

  private void applySamples() {
    if (!selecting && samples.getSelectedItem() instanceof Samples next && !next.equals(window.session().samples())) {
      window.setSamples(next);
    }
  }

  void select(final RenderPass next) {
    select(pass, next);
  }

  void select(final Samples next) {
    select(samples, next);
  }

  private void select(final JComboBox<?> box, final Object next) {
    selecting = true;
    box.setSelectedItem(next);
    selecting = false;
  }

  void select(final PictureSize wanted) {
    size.setSelectedItem(wanted.toString());
  }

  /** Shows the passes by their names. */
  private static final class PassNames extends DefaultListCellRenderer {

    private static final long serialVersionUID = 1L;

    @Override
    public Component getListCellRendererComponent(final JList<?> list, final Object value, final int index,
        final boolean isSelected, final boolean cellHasFocus) {
      final String name = value == null ? "" : Messages.text("window.pass." + value + ".text");
      return super.getListCellRendererComponent(list, name, index, isSelected, cellHasFocus);
    }
  }
}
