package window;

import java.awt.Dimension;

import javax.swing.JComponent;
import javax.swing.JSplitPane;

/**
 * A split pane whose first component has priority: the second keeps the size given by the user as long as the first has its
 * share, then shrinks, and disappears when it would be too small to be useful.
 */
final class PrioritySplit extends JSplitPane {

  private static final long serialVersionUID = 1L;

  /** Part of the space that the first component keeps. */
  private static final double FIRST_SHARE = 0.58;

  private final int minimum;
  private int secondSize;
  private boolean adjusting;

  /**
   * Splits in a direction of {@link JSplitPane}.
   *
   * @param second the second component, whose preferred size is its initial one
   * @param minimum size below which it disappears
   */
  PrioritySplit(final int direction, final JComponent first, final JComponent second, final int minimum) {
    super(direction, first, second);
    this.minimum = minimum;
    final Dimension preferred = second.getPreferredSize();
    secondSize = direction == HORIZONTAL_SPLIT ? preferred.width : preferred.height;
    first.setMinimumSize(new Dimension());
    second.setMinimumSize(new Dimension());
    setResizeWeight(1);
    setBorder(null);
    addPropertyChangeListener(DIVIDER_LOCATION_PROPERTY, event -> {
      if (!adjusting && isValid() && getRightComponent().isVisible()) {
        secondSize = Math.max(minimum, space() - getDividerLocation());
      }
    });
  }

  private int space() {
    return (getOrientation() == HORIZONTAL_SPLIT ? getWidth() : getHeight()) - getDividerSize();
  }

  /** Size of the first component when a given space is shared out. */
  static int firstSize(final int space, final int secondSize, final int minimum) {
    final int first = Math.max(space - secondSize, (int) Math.ceil(FIRST_SHARE * space));
    return space - first < minimum ? space : first;
  }

  /** The first layout accounts for a changed size, in a way of its own; the second one places the divider. */
  @Override
  public void doLayout() {
    adjusting = true;
    super.doLayout();
    if (getRightComponent().isVisible()) {
      setDividerLocation(firstSize(space(), secondSize, minimum));
      super.doLayout();
    }
    adjusting = false;
  }
}
