package window;

import java.awt.BorderLayout;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;

import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSplitPane;

/** The layout of the window: the picture takes all the space that the other parts leave, and most of a small window. */
final class WindowLayout {

  /** Width below which the inspector is illegible. */
  private static final int MIN_INSPECTOR = 140;

  /** Height of the header and one row of problems. */
  private static final int MIN_PROBLEMS = 48;

  private WindowLayout() {
  }

  /** Lays out the picture with its legend, the problems below it and the inspector beside them. */
  static JComponent of(final PictureView view, final LegendView legend, final ProblemTable problems,
      final InspectorPanel inspector) {
    final JPanel picture = new JPanel(new BorderLayout());
    picture.add(view, BorderLayout.CENTER);
    picture.add(legend, BorderLayout.EAST);
    return new PrioritySplit(JSplitPane.HORIZONTAL_SPLIT, withProblems(picture, problems), inspector, MIN_INSPECTOR);
  }

  /** Shows the problems below the picture only while there are any. */
  private static JSplitPane withProblems(final JComponent picture, final JComponent problems) {
    final JSplitPane split = new PrioritySplit(JSplitPane.VERTICAL_SPLIT, picture, problems, MIN_PROBLEMS);
    final int divider = split.getDividerSize();
    split.setDividerSize(0);
    problems.addComponentListener(new ComponentAdapter() {
      @Override
      public void componentShown(final ComponentEvent event) {
        split.setDividerSize(divider);
      }

      @Override
      public void componentHidden(final ComponentEvent event) {
        split.setDividerSize(0);
      }
    });
    return split;
  }
}
