package window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Component;
import java.awt.Container;
import java.awt.Robot;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.BitSet;
import java.util.Map;
import java.util.Set;

import javax.swing.AbstractButton;
import javax.swing.JCheckBox;
import javax.swing.JDialog;
import javax.swing.JSlider;

import org.junit.jupiter.api.Test;

import inspection.Difference;
import lights.LightGroup;
import lights.Omnidirectional;
import materials.IdealConductor;
import models.Group3D;
import models.Sphere;
import primitives.Point3D;
import primitives.Vector3D;
import radiometry.ReflectanceRGB;
import radiometry.SpectrumRGB;
import scenes.Lighting;
import scenes.SceneFile;
import view.Camera;
import view.Perspective;

class LightsDialogTest extends WindowFixture {

  private static final int W = 60;
  private static final int H = 45;
  private static final int DEPTH = 3;

  private final SceneFile lit = lit();

  private static SceneFile lit() {
    final Group3D objects = new Group3D();
    objects.addObject(new Sphere(new Point3D(-1, 0, 0), 1, Color.ORANGE));
    objects.addObject(new Sphere(new Point3D(1, 0, 0), 1, new IdealConductor(new ReflectanceRGB(0.9f, 0.9f, 0.9f))));
    final Camera camera = new Camera(new Point3D(0, 1, 5), new Point3D(), new Vector3D(0, 1, 0));
    camera.setProjection(new Perspective(50, 4f / 3));
    final LightGroup lights = new LightGroup(
        new Omnidirectional(new Point3D(4, 4, 4), new SpectrumRGB(0.5f, 0.3f, 0.2f), 40),
        new Omnidirectional(new Point3D(-4, 2, 4), new SpectrumRGB(0.2f, 0.3f, 0.5f), 30));
    return new SceneFile("lit", W, H, Color.BLUE, new Lighting(true, false, lights, DEPTH, 0), camera, objects, Map.of(),
        Set.of());
  }

  private void openLights() throws Exception {
    on(() -> {
      window.open(lit);
      return null;
    });
    waitFor(() -> !window.isRunning() && window.job() != null && window.job().scene() == lit);
    on(() -> {
      window.showLights();
      return null;
    });
    waitFor(() -> isShowing("lights"));
  }

  private static BufferedImage mixed(final int depth, final Set<SelectiveSum.Effect> omitted, final int... lights) {
    final BitSet on = new BitSet();
    for (final int light : lights) {
      on.set(light);
    }
    return new LightMixer(lit(), W, H).mix(on, depth, omitted, () -> false);
  }

  private void waitForPreview(final BufferedImage expected) throws Exception {
    waitFor(() -> window.view().preview() != null
        && Difference.between(expected, window.view().preview()).orElseThrow().differing() == 0);
  }

  @Test
  void everySwitchShowsThePictureThatItSays() throws Exception {
    openLights();
    assertNull(on(() -> window.view().preview()));
    press("lights.1");
    waitForPreview(mixed(DEPTH, Set.of(), 1));
    press("lights.MIRRORS");
    waitForPreview(mixed(DEPTH, Set.of(SelectiveSum.Effect.MIRRORS), 1));
    press("lights.all");
    press("lights.MIRRORS");
    on(() -> {
      ((JSlider) find("lights.depth")).setValue(0);
      return null;
    });
    waitForPreview(mixed(0, Set.of(), 0, 1));
    press("lights.none");
    waitForPreview(mixed(0, Set.of()));
    press("lights.close");
    assertNull(on(() -> window.view().preview()));
    assertFalse(on(() -> isShowing("lights")));
  }

  @Test
  void theMixtureStaysWhileThePictureIsRefined() throws Exception {
    openLights();
    press("lights.2");
    waitForPreview(mixed(DEPTH, Set.of(), 0));
    on(() -> {
      window.view().refine(new BufferedImage(W, H, BufferedImage.TYPE_INT_ARGB));
      return null;
    });
    waitForPreview(mixed(DEPTH, Set.of(), 0));
  }

  /** Ctrl+G opens it, Tab goes from switch to switch, the space bar switches, Escape closes. */
  @Test
  void itIsOperatedByKeys() throws Exception {
    on(() -> {
      window.open(lit);
      return null;
    });
    waitFor(() -> !window.isRunning() && window.job() != null && window.job().scene() == lit);
    final Robot robot = new Robot();
    robot.setAutoDelay(20);
    robot.setAutoWaitForIdle(true);
    on(() -> window.view().requestFocusInWindow());
    waitFor(() -> window.view().isFocusOwner());
    robot.keyPress(KeyEvent.VK_CONTROL);
    type(robot, KeyEvent.VK_G);
    robot.keyRelease(KeyEvent.VK_CONTROL);
    waitFor(() -> isShowing("lights") && find("lights.1").isFocusOwner());
    type(robot, KeyEvent.VK_TAB);
    waitFor(() -> find("lights.2").isFocusOwner());
    type(robot, KeyEvent.VK_SPACE);
    assertFalse(on(() -> ((JCheckBox) find("lights.2")).isSelected()));
    waitForPreview(mixed(DEPTH, Set.of(), 0));
    type(robot, KeyEvent.VK_ESCAPE);
    waitFor(() -> !isShowing("lights"));
  }

  private static void type(final Robot robot, final int key) {
    robot.keyPress(key);
    robot.keyRelease(key);
  }

  @Test
  void everySwitchHasAnAccessibleName() throws Exception {
    openLights();
    int named = 0;
    for (final Window open : Window.getWindows()) {
      if (open.isShowing() && open instanceof JDialog dialog && "lights".equals(dialog.getName())) {
        named += on(() -> assertNamed(dialog.getContentPane()));
      }
    }
    assertEquals(2 + SelectiveSum.Effect.values().length + 1 + 3, named);
  }

  private static int assertNamed(final Container container) {
    int named = 0;
    for (final Component component : container.getComponents()) {
      if (component instanceof JSlider || component instanceof AbstractButton && component.getName() != null
          && component.getName().startsWith("lights.")) {
        final String name = component.getAccessibleContext().getAccessibleName();
        assertTrue(name != null && !name.isEmpty(), component::toString);
        named++;
      } else if (component instanceof Container within) {
        named += assertNamed(within);
      }
    }
    return named;
  }

  @Test
  void anUnlitPictureHasNoLightsToSwitch() throws Exception {
    on(() -> {
      window.showLights();
      return null;
    });
    waitFor(() -> label("status").equals("this picture has no lights to switch"));
    assertFalse(on(() -> isShowing("lights")));
  }
}
