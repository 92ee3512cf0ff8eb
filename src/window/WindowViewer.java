package window;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;

import javax.swing.SwingUtilities;

import upnatray.Viewer;

/** Opens windows on behalf of the command line. */
public final class WindowViewer implements Viewer {

  /** Called by the service loader. */
  public WindowViewer() {
  }

  /** False if the display cannot be reached, or if the Java runtime has no support for one. */
  @Override
  public boolean isAvailable() {
    try {
      return !GraphicsEnvironment.isHeadless()
          && GraphicsEnvironment.getLocalGraphicsEnvironment().getDefaultScreenDevice() != null;
    } catch (final HeadlessException | AWTError | LinkageError unreachable) {
      return false;
    }
  }

  @Override
  public void show(final Request request) {
    SwingUtilities.invokeLater(() -> {
      final Settings settings = Settings.ofUser();
      Theme.install(settings.isDark());
      final RenderWindow window = new RenderWindow(settings, request.view(), request.threads());
      if (request.width() > 0 || request.height() > 0) {
        window.startWithSize(new PictureSize(0, request.width(), request.height()));
      }
      window.open(request.scene());
      window.frame().setVisible(true);
    });
  }
}
