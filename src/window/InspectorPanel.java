package window;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.datatransfer.StringSelection;
import java.awt.event.MouseEvent;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTree;
import javax.swing.ToolTipManager;
import javax.swing.tree.DefaultMutableTreeNode;
import javax.swing.tree.DefaultTreeCellRenderer;
import javax.swing.tree.DefaultTreeModel;
import javax.swing.tree.TreePath;

import arguments.Messages;
import inspection.Inspection;
import inspection.Intersection;
import inspection.JUnitTestWriter;
import inspection.LitPixelTestWriter;
import inspection.Wireframe;

/** Shows the inspection of the pinned pixel. */
final class InspectorPanel extends JPanel {

  private static final long serialVersionUID = 1L;

  /** Depth of the rays up to which the tree of light is expanded at first. */
  private static final int EXPANDED_DEPTH = 2;

  private final JLabel heading = new JLabel();
  private final JLabel swatch = new JLabel("      ");
  private final JTree tree = new JTree(new DefaultMutableTreeNode()) {
    private static final long serialVersionUID = 1L;

    /** The whole line, which may be wider than the panel. */
    @Override
    public String getToolTipText(final MouseEvent event) {
      final TreePath path = getPathForLocation(event.getX(), event.getY());
      return path == null ? null : path.getLastPathComponent().toString();
    }
  };
  private final SphereTracePlot plot = new SphereTracePlot();
  private final JButton copy = new JButton(Messages.text("window.copyTest.text"));
  private final PolarPlot polar = new PolarPlot();
  private final transient ClipboardCopy copying;
  private transient Consumer<List<Wireframe.Line>> rayListener = rays -> { };
  private transient Inspection inspection;
  private transient Path file;

  InspectorPanel(final ClipboardCopy copying) {
    super(new BorderLayout(0, 4));
    this.copying = copying;
    setName("inspector");
    setPreferredSize(new Dimension(420, 400));
    setBorder(BorderFactory.createEmptyBorder(6, 8, 6, 8));
    final JPanel top = new JPanel(new BorderLayout(8, 0));
    heading.setName("heading");
    swatch.setOpaque(true);
    swatch.setVisible(false);
    top.add(heading, BorderLayout.CENTER);
    top.add(swatch, BorderLayout.EAST);
    add(top, BorderLayout.NORTH);
    add(new JScrollPane(tree), BorderLayout.CENTER);
    final JPanel bottom = new JPanel(new BorderLayout(0, 4));
    bottom.add(polar, BorderLayout.NORTH);
    bottom.add(plot, BorderLayout.CENTER);
    bottom.add(copy, BorderLayout.SOUTH);
    add(bottom, BorderLayout.SOUTH);
    prepareTree();
    copy.setName("copyTest");
    copy.setToolTipText(Messages.text("window.copyTest.tip"));
    copy.addActionListener(event -> copyTest());
    clear();
  }

  /** In a low window the plot leaves most of the height to the tree. */
  @Override
  public void doLayout() {
    polar.setPreferredSize(new Dimension(200, Math.min(150, getHeight() / 3)));
    plot.setPreferredSize(new Dimension(200, Math.min(150, getHeight() / 3)));
    super.doLayout();
  }

  private void prepareTree() {
    tree.setName("inspection");
    ToolTipManager.sharedInstance().registerComponent(tree);
    tree.setRootVisible(false);
    tree.setShowsRootHandles(true);
    tree.getAccessibleContext().setAccessibleName(Messages.text("window.inspector.name"));
    final DefaultTreeCellRenderer plain = new DefaultTreeCellRenderer();
    plain.setLeafIcon(null);
    plain.setOpenIcon(null);
    plain.setClosedIcon(null);
    tree.setCellRenderer(plain);
    tree.addTreeSelectionListener(event -> {
      showTrace();
      showLight();
    });
  }

  /** Shows only how to begin. */
  void clear() {
    inspection = null;
    heading.setText(Messages.text("window.inspector.empty"));
    swatch.setVisible(false);
    tree.setModel(new DefaultTreeModel(new DefaultMutableTreeNode()));
    copy.setEnabled(false);
    plot.setTrace(null);
    polar.clear();
    rayListener.accept(List.of());
  }

  /** Shows why there is no inspection. */
  void showNothing(final String why) {
    clear();
    heading.setText(why);
  }

  /**
   * Shows an inspection.
   *
   * @param root its lines
   * @param sceneFile the file of the scene; null if it has none
   */
  void show(final Inspection next, final DefaultMutableTreeNode root, final Path sceneFile) {
    inspection = next;
    file = sceneFile;
    heading.setText(root.toString());
    swatch.setBackground(new Color(next.argb()));
    swatch.setToolTipText(InspectionTree.colour(next.argb()));
    swatch.setVisible(true);
    tree.setModel(new DefaultTreeModel(root));
    expand(root);
    copy.setEnabled(selected().isPresent());
    showTrace();
  }

  /** Expands the sections, the closest intersection and those that violate the contract. */
  private void expand(final DefaultMutableTreeNode root) {
    for (int i = 0; i < root.getChildCount(); i++) {
      final DefaultMutableTreeNode section = (DefaultMutableTreeNode) root.getChildAt(i);
      tree.expandPath(new TreePath(section.getPath()));
      for (int k = 0; k < section.getChildCount(); k++) {
        final DefaultMutableTreeNode line = (DefaultMutableTreeNode) section.getChildAt(k);
        if (line.getUserObject() instanceof InspectionTree.IntersectionLine entry
            && (entry.intersection().winner() || !entry.intersection().violations().isEmpty())) {
          tree.expandPath(new TreePath(line.getPath()));
        }
        expandLight(line);
      }
    }
  }

  /** Expands the first surfaces in the tree of light, but not the numbers of each light there. */
  private void expandLight(final DefaultMutableTreeNode line) {
    if (line.getUserObject() instanceof LightLines.RayLine ray && ray.lamp().isEmpty()
        && ray.node().surface().depth() <= EXPANDED_DEPTH) {
      tree.expandPath(new TreePath(line.getPath()));
      for (int i = 0; i < line.getChildCount(); i++) {
        expandLight((DefaultMutableTreeNode) line.getChildAt(i));
      }
    }
  }

  /** The intersection selected in the tree; failing that the closest, failing that the first listed. */
  Optional<Intersection> selected() {
    final TreePath path = tree.getSelectionPath();
    if (path != null) {
      for (final Object node : path.getPath()) {
        if (((DefaultMutableTreeNode) node).getUserObject() instanceof InspectionTree.IntersectionLine line) {
          return Optional.of(line.intersection());
        }
      }
    }
    if (inspection == null) {
      return Optional.empty();
    }
    return inspection.winner().or(() -> inspection.intersections().stream().findFirst());
  }

  private void showTrace() {
    plot.setTrace(selected().flatMap(Intersection::trace).orElse(null));
    copy.setEnabled(selected().isPresent());
  }

  /** Sets the listener for the rays that the selected line is about. */
  void setRayListener(final Consumer<List<Wireframe.Line>> listener) {
    rayListener = listener;
  }

  /** The line about light that is selected, or that contains the selected one. */
  private Optional<LightLines.RayLine> selectedRay() {
    final TreePath path = tree.getSelectionPath();
    for (int i = path == null ? -1 : path.getPathCount() - 1; i >= 0; i--) {
      if (((DefaultMutableTreeNode) path.getPathComponent(i)).getUserObject() instanceof LightLines.RayLine line) {
        return Optional.of(line);
      }
    }
    return Optional.empty();
  }

  private void showLight() {
    final Optional<LightLines.RayLine> line = selectedRay();
    rayListener.accept(line.map(LightLines.RayLine::rays).orElse(List.of()));
    line.flatMap(LightLines.RayLine::lamp).filter(lamp -> lamp.contribution().distance() > 0)
        .ifPresentOrElse(lamp -> polar.show(line.get().node().surface(), lamp.contribution()), polar::clear);
    revalidate();
  }

  /** Whether an intersection, or something below it, is selected. */
  private boolean isIntersectionSelected() {
    return tree.getSelectionPath() != null && Arrays.stream(tree.getSelectionPath().getPath())
        .anyMatch(node -> ((DefaultMutableTreeNode) node).getUserObject() instanceof InspectionTree.IntersectionLine);
  }

  /** Puts a test on the clipboard: of the selected intersection, or of the light of a lit pixel of a scene file. */
  void copyTest() {
    final Inspection shown = inspection;
    final Path scene = file;
    final String message = Messages.text("window.status.testCopied");
    if (shown != null && shown.light().isPresent() && scene != null && !isIntersectionSelected()) {
      copying.copy(() -> new StringSelection(LitPixelTestWriter.of(shown, scene)), message);
      return;
    }
    selected().ifPresent(intersection -> copying.copy(
        () -> new StringSelection(JUnitTestWriter.of(shown, intersection)), message));
  }
}
