package window;

import java.awt.Window;

import javax.swing.SwingUtilities;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLightLaf;

/** The look: FlatLaf, light or dark, as in NetBeans. */
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

  /** Gives all open windows the look installed last. */
  static void update() {
    for (final Window window : Window.getWindows()) {
      SwingUtilities.updateComponentTreeUI(window);
    }
  }
}
