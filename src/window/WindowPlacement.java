package window;

import java.awt.GraphicsConfiguration;
import java.awt.GraphicsDevice;
import java.awt.GraphicsEnvironment;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;
import java.util.ArrayList;
import java.util.List;

/** Places windows on the screens, so that they are usable whatever the screens' sizes and scale factors. */
final class WindowPlacement {

  /** Width and height of the part of a window that must be on a screen for its place to count as still existing. */
  private static final int REACHABLE = 64;

  private WindowPlacement() {
  }

  /**
   * The bounds closest to those wanted that lie within one screen. The first area is that of the default screen.
   *
   * @param wanted the bounds wanted
   * @param hasPlace whether the place is wanted too; if not, or if it no longer exists, the window is centred
   * @param areas the usable areas of the screens, at least one
   */
  static Rectangle place(final Rectangle wanted, final boolean hasPlace, final List<Rectangle> areas) {
    Rectangle best = null;
    long largest = 0;
    for (final Rectangle area : areas) {
      final Rectangle common = area.intersection(wanted);
      final boolean reachable = common.width >= REACHABLE && common.height >= REACHABLE;
      if (hasPlace && reachable && (long) common.width * common.height > largest) {
        largest = (long) common.width * common.height;
        best = area;
      }
    }
    final Rectangle area = best == null ? areas.get(0) : best;
    final int width = Math.min(wanted.width, area.width), height = Math.min(wanted.height, area.height);
    if (best == null) {
      return new Rectangle(area.x + (area.width - width) / 2, area.y + (area.height - height) / 2, width, height);
    }
    return new Rectangle(clamp(wanted.x, area.x, area.x + area.width - width),
        clamp(wanted.y, area.y, area.y + area.height - height), width, height);
  }

  private static int clamp(final int value, final int min, final int max) {
    return Math.max(min, Math.min(max, value));
  }

  /** Moves and shrinks a packed window so that it lies within the screen of its owner. */
  static void fit(final Window window) {
    final Window owner = window.getOwner() == null ? window : window.getOwner();
    window.setBounds(place(window.getBounds(), true, List.of(usableArea(owner.getGraphicsConfiguration()))));
  }

  /**
   * The areas that windows may use, without task bars; that of the default screen first. Screens that overlap it are left
   * out: they mirror it, or have coordinates of their own, as those of an X server without Xinerama.
   */
  static List<Rectangle> usableAreas() {
    final GraphicsEnvironment environment = GraphicsEnvironment.getLocalGraphicsEnvironment();
    final List<Rectangle> areas = new ArrayList<>();
    final GraphicsConfiguration main = environment.getDefaultScreenDevice().getDefaultConfiguration();
    areas.add(usableArea(main));
    for (final GraphicsDevice device : environment.getScreenDevices()) {
      if (!device.getDefaultConfiguration().getBounds().intersects(main.getBounds())) {
        areas.add(usableArea(device.getDefaultConfiguration()));
      }
    }
    return areas;
  }

  private static Rectangle usableArea(final GraphicsConfiguration configuration) {
    final Rectangle bounds = configuration.getBounds();
    final Insets bars = Toolkit.getDefaultToolkit().getScreenInsets(configuration);
    return new Rectangle(bounds.x + bars.left, bounds.y + bars.top, bounds.width - bars.left - bars.right,
        bounds.height - bars.top - bars.bottom);
  }
}
