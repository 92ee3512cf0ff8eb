package window;

import java.awt.Window;

import javax.swing.SwingUtilities;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLightLaf;

/** The look and feel: FlatLaf, light or dark, as in NetBeans. */
final class Theme {

  private Theme() {
  }

  static void install(final boolean dark) {
    if (dark) {
      FlatDarkLaf.setup();
    } else {
      FlatLightLaf.setup();
    }
  }

  /** Applies the installed look and feel to all open windows. */
  static void update() {
    for (final Window window : Window.getWindows()) {
      SwingUtilities.updateComponentTreeUI(window);
    }
  }
}
