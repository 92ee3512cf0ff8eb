package window;

import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Component;
import java.awt.Container;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Window;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import java.util.prefs.Preferences;

import javax.swing.AbstractButton;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.SwingUtilities;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

import rendering.RenderPass;

/** A real window to be driven by tests, which shows a red ball before blue. Without a display the tests are skipped. */
abstract class WindowFixture {

  static final String SCENE = """
      <image name="a ball">
        <raster><W>80</W><H>60</H><backgroundColor>0 0 1</backgroundColor></raster>
        <rayTracer><wblock>32</wblock><hblock>32</hblock><showProgress>true</showProgress></rayTracer>
        <engine><illumination>false</illumination><falseLighting>false</falseLighting></engine>
        <camera><position>0 0 5</position><lookAt>0 0 0</lookAt><up>0 1 0</up></camera>
        <projection type="orthographic"><height>3</height><aspect>1.33333</aspect></projection>
        <models><model id="ball" type="sphere"><radius>1</radius></model></models>
        <scene><object><modelId>ball</modelId><color>255 0 0</color></object></scene>
      </image>
      """;

  static final int RED = 0xffff0000;
  static final int GREEN = 0xff00ff00;
  static final int BLUE = 0xff0000ff;

  @TempDir
  Path folder;

  Preferences preferences;
  RenderWindow window;
  Path scene;

  @BeforeAll
  static void needsADisplay() {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display");
  }

  @BeforeEach
  void openWindow() throws Exception {
    preferences = Preferences.userRoot().node("upnatray/test" + ProcessHandle.current().pid());
    preferences.clear();
    scene = Files.writeString(folder.resolve("ball.xml"), SCENE);
    on(() -> {
      Theme.install(false);
      window = new RenderWindow(new Settings(preferences), RenderPass.COLOUR, 2);
      window.open(scene);
      window.frame().setVisible(true);
      return null;
    });
    waitFor(() -> window.job() != null && !window.isRunning());
  }

  @AfterEach
  void closeWindow() throws Exception {
    if (window != null) {
      on(() -> {
        window.close();
        return null;
      });
      preferences.removeNode();
    }
  }

  static <T> T on(final Callable<T> action) throws Exception {
    final FutureTask<T> task = new FutureTask<>(action);
    if (SwingUtilities.isEventDispatchThread()) {
      task.run();
    } else {
      SwingUtilities.invokeAndWait(task);
    }
    return task.get();
  }

  final void waitFor(final Callable<Boolean> condition) throws Exception {
    final long end = System.nanoTime() + 20_000_000_000L;
    while (!on(condition)) {
      if (System.nanoTime() > end) {
        fail("the condition did not become true within 20 seconds; status: " + label("status"));
      }
      Thread.sleep(20);
    }
  }

  final int pixel(final int x, final int y) throws Exception {
    return on(() -> window.view().picture().getRGB(x, y));
  }

  final void press(final String name) throws Exception {
    final AbstractButton button = (AbstractButton) find(name);
    on(() -> {
      button.doClick();
      return null;
    });
  }

  static Component find(final String name) {
    for (final Window open : Window.getWindows()) {
      final Component found = open.isShowing() ? find(open, name) : null;
      if (found != null) {
        return found;
      }
    }
    return fail("there is no component " + name);
  }

  private static Component find(final Container container, final String name) {
    for (final Component component : container.getComponents()) {
      if (name.equals(component.getName())) {
        return component;
      }
      final Component within = component instanceof Container ? find((Container) component, name) : null;
      if (within != null) {
        return within;
      }
    }
    return null;
  }

  /** The middle of a pixel on the screen. */
  final Point onScreen(final int x, final int y) throws Exception {
    return on(() -> {
      final Rectangle at = window.view().zoom().onScreen(new Rectangle(x, y, 1, 1));
      final Point origin = window.view().getLocationOnScreen();
      return new Point(origin.x + at.x + at.width / 2, origin.y + at.y + at.height / 2);
    });
  }

  final String label(final String name) throws Exception {
    return on(() -> ((JLabel) find(name)).getText());
  }

  /** Pins a pixel and waits for its inspection. */
  final void pin(final int x, final int y) throws Exception {
    on(() -> {
      window.view().pin(new Point(x, y));
      return null;
    });
    waitFor(() -> window.inspector().selected().isPresent());
  }

  static JOptionPane complaint() {
    for (final Window open : Window.getWindows()) {
      if (open.isShowing() && open instanceof JDialog dialog
          && dialog.getContentPane().getComponent(0) instanceof JOptionPane pane) {
        return pane;
      }
    }
    return null;
  }

  static boolean isShowing(final String name) {
    for (final Window open : Window.getWindows()) {
      if (open.isShowing() && name.equals(open.getName())) {
        return true;
      }
    }
    return false;
  }
}
