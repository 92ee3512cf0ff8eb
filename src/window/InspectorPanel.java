package window;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.awt.event.MouseEvent;
import java.util.Optional;

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

/** Shows the inspection of the pinned pixel. */
final class InspectorPanel extends JPanel {

  private static final long serialVersionUID = 1L;

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
  private transient Inspection inspection;

  InspectorPanel() {
    super(new BorderLayout(0, 4));
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
    tree.addTreeSelectionListener(event -> showTrace());
  }

  /** Shows only how to begin. */
  void clear() {
    inspection = null;
    heading.setText(Messages.text("window.inspector.empty"));
    swatch.setVisible(false);
    tree.setModel(new DefaultTreeModel(new DefaultMutableTreeNode()));
    copy.setEnabled(false);
    plot.setTrace(null);
  }

  /** Shows why there is no inspection. */
  void showNothing(final String why) {
    clear();
    heading.setText(why);
  }

  void show(final Inspection next) {
    inspection = next;
    final DefaultMutableTreeNode root = InspectionTree.of(next);
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

  /** Puts a test of the selected intersection on the clipboard. */
  void copyTest() {
    selected().ifPresent(intersection -> Toolkit.getDefaultToolkit().getSystemClipboard()
        .setContents(new StringSelection(JUnitTestWriter.of(inspection, intersection)), null));
  }
}
