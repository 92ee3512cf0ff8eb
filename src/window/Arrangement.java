package window;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;

import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JSplitPane;

/** The layout of the window: the picture takes all the space that the other parts leave. */
final class Arrangement {

  private Arrangement() {
  }

  /** Lays out the picture with its legend, the problems below it and the inspector beside them. */
  static JComponent of(final PictureView view, final LegendView legend, final ProblemTable problems,
      final InspectorPanel inspector) {
    final JPanel picture = new JPanel(new BorderLayout());
    picture.add(view, BorderLayout.CENTER);
    picture.add(legend, BorderLayout.EAST);
    picture.setMinimumSize(new Dimension(200, 150));
    return split(JSplitPane.HORIZONTAL_SPLIT, withProblems(picture, problems), inspector);
  }

  /** Shows the problems below the picture only while there are any. */
  private static JSplitPane withProblems(final JComponent picture, final JComponent problems) {
    final JSplitPane split = split(JSplitPane.VERTICAL_SPLIT, picture, problems);
    final int divider = split.getDividerSize();
    split.setDividerSize(0);
    problems.addComponentListener(new ComponentAdapter() {
      @Override
      public void componentShown(final ComponentEvent event) {
        split.setDividerSize(divider);
        split.setDividerLocation(split.getHeight() - divider - problems.getPreferredSize().height);
      }

      @Override
      public void componentHidden(final ComponentEvent event) {
        split.setDividerSize(0);
      }
    });
    return split;
  }

  private static JSplitPane split(final int direction, final JComponent one, final JComponent other) {
    final JSplitPane split = new JSplitPane(direction, one, other);
    split.setResizeWeight(1);
    split.setBorder(null);
    return split;
  }

  /** Restores the previous bounds of the frame, or centres it if they are no longer on the screen. */
  static void place(final JFrame frame, final Rectangle bounds) {
    frame.setSize(bounds.getSize());
    if (bounds.x >= 0 && frame.getGraphicsConfiguration().getBounds().intersects(bounds)) {
      frame.setLocation(bounds.getLocation());
    } else {
      frame.setLocationRelativeTo(null);
    }
  }
}
