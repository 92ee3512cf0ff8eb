package window;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Insets;
import java.awt.LayoutManager;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Lays out a tool bar in one row. If it is too narrow, components that have menu items too are left out. */
final class ToolBarLayout implements LayoutManager {

  private final List<? extends Component> dispensable;

  /** A layout that leaves out these components, the first one first. */
  ToolBarLayout(final List<? extends Component> dispensable) {
    this.dispensable = List.copyOf(dispensable);
  }

  @Override
  public void layoutContainer(final Container bar) {
    final Insets insets = bar.getInsets();
    final int height = bar.getHeight() - insets.top - insets.bottom;
    final Set<Component> omitted = omitted(bar, bar.getWidth() - insets.left - insets.right);
    int x = insets.left;
    for (final Component component : bar.getComponents()) {
      final Dimension size = component.getPreferredSize();
      final int width = omitted.contains(component) ? 0 : size.width, itsHeight = Math.min(height, size.height);
      component.setBounds(x, insets.top + (height - itsHeight) / 2, width, itsHeight);
      x += width;
    }
  }

  private Set<Component> omitted(final Container bar, final int width) {
    int needed = 0;
    for (final Component component : bar.getComponents()) {
      needed += component.getPreferredSize().width;
    }
    final Set<Component> omitted = new HashSet<>();
    for (final Component component : dispensable) {
      if (needed > width) {
        omitted.add(component);
        needed -= component.getPreferredSize().width;
      }
    }
    return omitted;
  }

  @Override
  public Dimension preferredLayoutSize(final Container bar) {
    final Insets insets = bar.getInsets();
    final Dimension size = new Dimension(insets.left + insets.right, 0);
    for (final Component component : bar.getComponents()) {
      final Dimension part = component.getPreferredSize();
      size.width += part.width;
      size.height = Math.max(size.height, part.height);
    }
    size.height += insets.top + insets.bottom;
    return size;
  }

  @Override
  public Dimension minimumLayoutSize(final Container bar) {
    return new Dimension(0, preferredLayoutSize(bar).height);
  }

  @Override
  public void addLayoutComponent(final String name, final Component component) {
    // Components need no registration.
  }

  @Override
  public void removeLayoutComponent(final Component component) {
    // Components need no registration.
  }
}
