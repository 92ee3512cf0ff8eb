package window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Component;
import java.awt.Container;
import java.awt.Graphics;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.datatransfer.DataFlavor;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.stream.Stream;

import javax.imageio.ImageIO;
import javax.swing.AbstractButton;
import javax.swing.Action;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JOptionPane;
import javax.swing.KeyStroke;
import javax.swing.MenuElement;
import javax.swing.SwingUtilities;
import javax.swing.TransferHandler;

import org.junit.jupiter.api.Test;

import inspection.SampleScenes;
import models.SphereTrace;
import models.Object3D;
import models.Sphere;
import primitives.Point3D;
import scenes.SceneFile;
import tracer.Hit;
import tracer.Ray;
import rendering.Progress;
import rendering.RenderPass;
import rendering.RenderSettings;
import upnatray.Image;
import upnatray.RenderJob;
import view.Orthographic;

/** Drives a real window. */
class RenderWindowTest extends WindowFixture {

  @Test
  void itShowsThePictureOfTheScene() throws Exception {
    assertEquals(RED, pixel(40, 30));
    assertEquals(BLUE, pixel(1, 1));
    assertTrue(label("status").contains("80 x 60"), label("status"));
    assertTrue(on(() -> window.frame().getTitle()).startsWith("ball.xml"));
    assertEquals(List.of(scene.toAbsolutePath().normalize()), on(() -> window.settings().recent()));
  }

  @Test
  void theScreenShowsWhatWasRendered() throws Exception {
    final Point middle = onScreen(40, 30);
    final Robot robot = new Robot();
    waitFor(() -> robot.getPixelColor(middle.x, middle.y).equals(Color.RED));
  }

  @Test
  void pointerShowsAndClickPinsThePixelInTheAssignmentsConvention() throws Exception {
    final Robot robot = new Robot();
    final Point place = onScreen(40, 20);
    robot.mouseMove(place.x, place.y);
    robot.mouseMove(place.x + 1, place.y);
    waitFor(() -> label("pixel").startsWith("(40, 39)   255 0 0"));
    robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
    robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    waitFor(() -> new Point(40, 20).equals(window.view().pinned()));
    waitFor(() -> window.inspector().selected().filter(found -> found.name().equals("ball")).isPresent());
    robot.waitForIdle();
    robot.keyPress(KeyEvent.VK_LEFT);
    robot.keyRelease(KeyEvent.VK_LEFT);
    waitFor(() -> new Point(39, 20).equals(window.view().pinned()));
    robot.mouseWheel(-4);
    waitFor(() -> window.view().magnification() > 12);
    assertEquals(new Point(40, 20), on(() -> {
      final Point origin = window.view().getLocationOnScreen();
      return window.view().zoom().pixelAt(new Point(place.x + 1 - origin.x, place.y - origin.y));
    }));
  }

  @Test
  void aMenuShortcutActsOnce() throws Exception {
    final Robot robot = new Robot();
    final Point place = onScreen(40, 20);
    robot.mouseMove(place.x, place.y);
    robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
    robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    waitFor(() -> window.view().isFocusOwner());
    final double before = on(() -> window.view().magnification());
    robot.keyPress(KeyEvent.VK_CONTROL);
    robot.keyPress(KeyEvent.VK_MINUS);
    robot.keyRelease(KeyEvent.VK_MINUS);
    robot.keyRelease(KeyEvent.VK_CONTROL);
    robot.keyPress(KeyEvent.VK_MINUS);
    robot.keyRelease(KeyEvent.VK_MINUS);
    robot.waitForIdle();
    assertEquals(before / 4, on(() -> window.view().magnification()), 1e-9);
  }

  @Test
  void theTestOfAPixelGoesToTheClipboard() throws Exception {
    pin(40, 30);
    press("copyTest");
    waitFor(() -> label("status").startsWith("test copied"));
    final Object text = Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.stringFlavor);
    assertTrue(String.valueOf(text).contains("new models.Sphere("), String.valueOf(text));
    on(() -> {
      window.copyPicture();
      return null;
    });
    waitFor(() -> label("status").startsWith("picture copied"));
    final BufferedImage picture = (BufferedImage) Toolkit.getDefaultToolkit().getSystemClipboard()
        .getData(DataFlavor.imageFlavor);
    assertEquals(RED, picture.getRGB(40, 30));
  }

  @Test
  void aSavedSceneIsRenderedAgainKeepingZoomAndPinnedPixel() throws Exception {
    on(() -> {
      window.view().show(new Point(40, 30));
      return null;
    });
    final double magnification = on(() -> window.view().magnification());
    Files.writeString(scene, SCENE.replace("255 0 0", "0 255 0 "));
    waitFor(() -> window.view().picture().getRGB(40, 30) == GREEN && !window.isRunning());
    assertEquals(magnification, on(() -> window.view().magnification()));
    assertEquals(new Point(40, 30), on(() -> window.view().pinned()));
    waitFor(() -> window.inspector().selected().filter(found -> found.object().getColor().equals(Color.GREEN)).isPresent());
  }

  @Test
  void errorsAreListedAndTheOldPictureStays() throws Exception {
    assertFalse(on(() -> window.problems().isVisible()));
    Files.writeString(scene, SCENE.replace("<radius>1</radius>", "<radius>x</radius>"));
    waitFor(() -> window.problems().isVisible() && window.problems().table().getVisibleRect().height > 20);
    assertEquals("7", on(() -> String.valueOf(window.problems().table().getValueAt(0, 2))));
    assertEquals("ball.xml", on(() -> window.problems().table().getValueAt(0, 1)));
    assertEquals(RED, pixel(40, 30));
    Files.writeString(scene, SCENE.replace("255 0 0", "0 255 0 "));
    waitFor(() -> window.view().picture().getRGB(40, 30) == GREEN);
    assertFalse(on(() -> window.problems().isVisible()));
  }

  @Test
  void aFileThatIsDroppedIsOpened() throws Exception {
    final Path other = Files.writeString(folder.resolve("other.xml"), SCENE.replace("255 0 0", "0 255 0"));
    on(() -> {
      final JComponent root = window.frame().getRootPane();
      return root.getTransferHandler().importData(new TransferHandler.TransferSupport(root, new DroppedFile(other)));
    });
    waitFor(() -> window.view().picture().getRGB(40, 30) == GREEN);
    assertTrue(on(() -> window.frame().getTitle()).startsWith("other.xml"));
  }

  @Test
  void aRootFolderIsListedAsAProblem() throws Exception {
    final Path root = folder.getRoot();
    on(() -> {
      window.open(root);
      return null;
    });
    waitFor(() -> window.problems().isVisible());
    assertTrue(on(() -> window.frame().getTitle()).startsWith(root.toString()));
    assertEquals(root, on(() -> window.settings().folder()));
  }

  @Test
  void passesAndSizesAreChosenInTheToolBar() throws Exception {
    on(() -> {
      ((javax.swing.JComboBox<?>) find("pass")).setSelectedItem(RenderPass.DEPTH);
      return null;
    });
    waitFor(() -> !window.isRunning() && window.job().view() == RenderPass.DEPTH);
    assertTrue(on(() -> find("legend").isVisible()));
    assertEquals(0, pixel(1, 1) >>> 24);
    on(() -> {
      ((javax.swing.JComboBox<?>) find("size")).setSelectedItem("200 %");
      return null;
    });
    waitFor(() -> !window.isRunning() && window.job().image().getWidth() == 160);
    assertEquals(120, on(() -> window.view().picture().getHeight()));
  }

  @Test
  void samplesAreChosenInTheToolBarAndInTheMenu() throws Exception {
    pin(40, 30);
    on(() -> {
      ((javax.swing.JComboBox<?>) find("samples")).setSelectedItem(new Samples(3, false));
      return null;
    });
    waitFor(() -> !window.isRunning() && window.job().samples() == 3);
    final RenderJob expected = new RenderJob(window.job().scene(), RenderPass.COLOUR, 80, 60, 1).refined(3, false);
    expected.run(Progress.NONE);
    assertEquals(0, inspection.Difference.between(expected.image(), on(() -> window.view().picture())).orElseThrow()
        .differing());
    assertTrue(label("status").startsWith("80 x 60 pixels of 3 x 3 samples in "), label("status"));
    press(Samples.CHOICES.get(5));
    waitFor(() -> !window.isRunning() && window.job().samples() == 4);
    final RenderJob atEdges = new RenderJob(window.job().scene(), RenderPass.COLOUR, 80, 60, 1).refined(4, true);
    atEdges.run(Progress.NONE);
    assertEquals(0, inspection.Difference.between(atEdges.image(), on(() -> window.view().picture())).orElseThrow()
        .differing());
    final JMenuItem one = item(window.frame().getJMenuBar(), "1");
    assertFalse(on(one::isSelected));
    on(() -> {
      one.doClick();
      return null;
    });
    waitFor(() -> !window.isRunning() && window.job().samples() == 1);
    assertEquals(Samples.ONE, on(() -> ((javax.swing.JComboBox<?>) find("samples")).getSelectedItem()));
    assertEquals(new Point(40, 30), on(() -> window.view().pinned()));
  }

  private void press(final Samples choice) throws Exception {
    final JMenuItem item = item(window.frame().getJMenuBar(), choice.toString());
    on(() -> {
      item.doClick();
      return null;
    });
  }

  private static JMenuItem item(final MenuElement menu, final String text) {
    for (final MenuElement part : menu.getSubElements()) {
      if (part instanceof JMenuItem item && item.getText().equals(text)) {
        return item;
      }
      final JMenuItem within = item(part, text);
      if (within != null) {
        return within;
      }
    }
    return null;
  }

  @Test
  void everyMenuItemHasAKeyOfItsOwn() throws Exception {
    final Map<KeyStroke, String> keys = new HashMap<>();
    on(() -> {
      collectKeys(window.frame().getJMenuBar(), keys);
      return null;
    });
    assertTrue(keys.size() > 35, keys::toString);
  }

  private static void collectKeys(final MenuElement menu, final Map<KeyStroke, String> keys) {
    for (final MenuElement part : menu.getSubElements()) {
      if (part instanceof JMenu within && "recent".equals(within.getName())) {
        continue;
      }
      if (part instanceof JMenu within) {
        assertTrue(within.getMnemonic() != 0, within.getText());
      } else if (part instanceof JMenuItem item) {
        assertNotNull(item.getAccelerator(), item.getText());
        assertNull(keys.put(item.getAccelerator(), item.getText()), item.getText());
      }
      collectKeys(part, keys);
    }
  }

  @Test
  void anInvalidSizeRestoresThePreviousOne() throws Exception {
    final javax.swing.JComboBox<?> size = (javax.swing.JComboBox<?>) find("size");
    on(() -> {
      size.setSelectedItem("25 %");
      return null;
    });
    waitFor(() -> !window.isRunning() && window.job().image().getWidth() == 20);
    on(() -> {
      size.setSelectedItem("abc");
      return null;
    });
    assertEquals("25 %", on(size::getSelectedItem));
    assertEquals(new PictureSize(25, 0, 0), on(() -> window.session().size()));
  }

  /** A slow shape. */
  private static final class Slow extends Object3D {

    Slow() {
      super(Color.RED);
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      try {
        Thread.sleep(1);
        return Hit.NOHIT;
      } catch (final InterruptedException stopped) {
        throw new IllegalStateException(stopped);
      }
    }
  }

  private SceneFile slow() {
    final SceneFile sample = SampleScenes.of(new Orthographic(4, 0.8f), true, new Slow());
    return new SceneFile("slow", 400, 320, Color.GREEN, true, sample.camera(), sample.objects(), Map.of(), Set.of());
  }

  @Test
  void aRenderingIsShownWhileItRunsAndCancelled() throws Exception {
    on(() -> {
      window.open(slow());
      return null;
    });
    waitFor(() -> window.isRunning() && window.view().picture().getRGB(200, 160) == GREEN);
    assertEquals(0, pixel(2, 2));
    assertTrue(on(() -> find("progress").isVisible()));
    waitFor(() -> label("status").contains("rays/s"));
    press("cancel");
    waitFor(() -> !window.isRunning());
    assertTrue(label("status").startsWith("cancelled"), label("status"));
    assertEquals(0, pixel(2, 2));
  }

  @Test
  void anExceptionOfAShapeIsListedWithItsSourceLine() throws Exception {
    final Object3D broken = new Object3D(Color.RED) {
      @Override
      public Hit intersectionWith(final Ray ray) {
        throw new ArithmeticException("no root");
      }
    };
    on(() -> {
      window.open(SampleScenes.of(new Orthographic(4, 0.8f), true, broken));
      return null;
    });
    waitFor(() -> window.problems().isVisible());
    assertEquals("RenderWindowTest.java", on(() -> window.problems().table().getValueAt(0, 1)));
    assertTrue(on(() -> String.valueOf(window.problems().table().getValueAt(0, 4))).contains("no root"));
  }

  /** A shape whose intersection method does not return until it is released. */
  private static final class Endless extends Object3D {

    private volatile boolean ended;

    Endless() {
      super(Color.RED);
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      while (!ended) {
        Thread.onSpinWait();
      }
      return Hit.NOHIT;
    }
  }

  @Test
  void aShapeThatNeverReturnsIsNamedAndAbandoned() throws Exception {
    final Endless endless = new Endless();
    try {
      on(() -> {
        window.open(SampleScenes.of(new Orthographic(4, 0.8f), true, endless));
        return null;
      });
      waitFor(() -> label("status").contains("Endless.intersectionWith (RenderWindowTest.java:"));
      on(() -> {
        window.view().pin(new Point(1, 1));
        return null;
      });
      press("cancel");
      waitFor(() -> !window.isRunning());
      on(() -> {
        window.open(scene);
        return null;
      });
      waitFor(() -> window.view().picture().getWidth() == 80 && window.view().picture().getRGB(40, 30) == RED);
      pin(40, 30);
    } finally {
      endless.ended = true;
    }
  }

  @Test
  void aShapeThatNeverReturnsIsNamedInThePixelLoopAndWithSamplesToo() throws Exception {
    for (final boolean loop : new boolean[] {true, false}) {
      final Endless endless = new Endless();
      final SceneFile sample = SampleScenes.of(new Orthographic(4, 0.8f), true, endless);
      final RenderSettings settings = RenderSettings.STANDARD.withThreads(1);
      final Thread rendering = new Thread(() -> {
        if (loop) {
          new Image(4, 3, Color.BLUE).synthesis(sample.objects(), sample.camera(), settings.withPixelLoop());
        } else {
          new RenderJob(sample, RenderPass.COLOUR, 4, 3, 1).refined(2, false).run(Progress.NONE);
        }
      });
      rendering.start();
      try {
        final StallDetector detector = new StallDetector();
        waitFor(() -> detector.check(0.5).filter(text -> text.contains("Endless.intersectionWith (RenderWindowTest.java:"))
            .isPresent());
      } finally {
        endless.ended = true;
        rendering.join();
      }
    }
  }

  /** A ball whose colour can make an inspection fail, at once or when it is released. */
  private static final class Moody extends Sphere {

    private final CountDownLatch release = new CountDownLatch(1);
    private volatile boolean absent;
    private volatile boolean late;

    Moody() {
      super(new Point3D(), 1, Color.RED);
    }

    @Override
    public Color getColor() {
      if (late) {
        late = false;
        try {
          release.await();
        } catch (final InterruptedException stopped) {
          throw new IllegalStateException(stopped);
        }
        throw new IllegalStateException("too late");
      }
      return absent ? null : Color.RED;
    }
  }

  private void openMoody(final Moody ball) throws Exception {
    on(() -> {
      window.open(SampleScenes.of(new Orthographic(3, 0.75f), true, ball));
      return null;
    });
    waitFor(() -> !window.isRunning() && window.job() != null && window.job().image().getWidth() == 48);
  }

  @Test
  void theReasonOfAFailedInspectionStaysVisible() throws Exception {
    final Moody ball = new Moody();
    openMoody(ball);
    ball.absent = true;
    on(() -> {
      window.view().pin(new Point(24, 18));
      return null;
    });
    waitFor(() -> label("heading").contains("NullPointerException"));
    Thread.sleep(2 * PixelInspections.WAITING_DELAY_MS);
    assertTrue(label("heading").contains("NullPointerException"), label("heading"));
  }

  @Test
  void anInspectionStaysWhenAnEarlierOneFails() throws Exception {
    final Moody ball = new Moody();
    openMoody(ball);
    ball.late = true;
    on(() -> {
      window.view().pin(new Point(24, 18));
      return null;
    });
    waitFor(() -> !ball.late);
    pin(23, 18);
    final String heading = label("heading");
    ball.release.countDown();
    Thread.sleep(300);
    assertEquals(heading, label("heading"));
  }

  @Test
  void thePictureIsSavedAndComparedWithAReference() throws Exception {
    final Path file = folder.resolve("saved.png");
    on(() -> {
      window.dialogs().saveAs(window.view().picture(), file);
      return null;
    });
    waitFor(() -> label("status").startsWith("saved"));
    on(() -> {
      window.dialogs().compareWith(file);
      return null;
    });
    waitFor(() -> isShowing("comparison") && label("figures").contains("differ"));
    assertEquals(RED, ImageIO.read(file.toFile()).getRGB(40, 30));
    assertTrue(label("figures").startsWith("0 pixels differ"), label("figures"));
    Files.writeString(scene, SCENE.replace("<radius>1</radius>", "<radius>0.9</radius>"));
    waitFor(() -> !label("figures").startsWith("0 pixels") && window.view().hasOverlay());
    press("compare.worst");
    final Point worst = on(() -> window.view().pinned());
    assertNotNull(worst);
    assertNotEquals(pixel(worst.x, worst.y), ImageIO.read(file.toFile()).getRGB(worst.x, worst.y));
    press("compare.mask");
    assertFalse(on(() -> window.view().hasOverlay()));
  }

  @Test
  void aFolderIsNeverReplacedByAPicture() throws Exception {
    final Path taken = Files.createDirectory(folder.resolve("taken.png"));
    SwingUtilities.invokeLater(() -> window.dialogs().saveAs(window.view().picture(), taken));
    waitFor(() -> complaint() != null);
    assertTrue(on(() -> complaint().getMessage().toString()).endsWith("there is a folder of this name"));
    assertTrue(Files.isDirectory(taken));
    on(() -> {
      complaint().setValue(JOptionPane.OK_OPTION);
      return null;
    });
  }

  @Test
  void aPictureIsReplacedOnlyOnConfirmation() throws Exception {
    final Path taken = folder.resolve("taken.png");
    ImageIO.write(new BufferedImage(3, 2, BufferedImage.TYPE_INT_RGB), "png", taken.toFile());
    for (final int reply : new int[] {JOptionPane.NO_OPTION, JOptionPane.YES_OPTION}) {
      assertEquals(3, ImageIO.read(taken.toFile()).getWidth());
      on(() -> {
        window.dialogs().saveAs(window.view().picture(), taken);
        return null;
      });
      waitFor(() -> complaint() != null);
      on(() -> {
        complaint().setValue(reply);
        return null;
      });
      waitFor(() -> complaint() == null);
    }
    waitFor(() -> label("status").startsWith("saved"));
    assertEquals(RED, ImageIO.read(taken.toFile()).getRGB(40, 30));
  }

  @Test
  void nothingButAPictureIsReplacedAndNoInput() throws Exception {
    final Path letter = Files.writeString(folder.resolve("letter.png"), "a letter");
    final Path link = Files.createSymbolicLink(folder.resolve("link.png"), scene);
    for (final Path file : List.of(letter, link)) {
      final String before = Files.readString(file);
      on(() -> {
        window.dialogs().saveAs(window.view().picture(), file);
        return null;
      });
      waitFor(() -> complaint() != null);
      assertTrue(on(() -> complaint().getMessage().toString()).contains(file.getFileName().toString()));
      on(() -> {
        complaint().setValue(JOptionPane.OK_OPTION);
        return null;
      });
      waitFor(() -> complaint() == null);
      assertEquals(before, Files.readString(file));
    }
  }

  /** Under another name, which shows that files are compared and not names. */
  @Test
  void aMeshOfTheSceneIsNotReplaced() throws Exception {
    final Path mesh = Files.writeString(folder.resolve("mesh.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    Files.writeString(scene, SCENE.replace("<model id=\"ball\" type=\"sphere\"><radius>1</radius></model>",
        "<model id=\"ball\" type=\"mesh\"><objFile>mesh.obj</objFile></model>"));
    waitFor(() -> !window.isRunning() && window.session().inputs().size() == 2);
    final Path link = Files.createLink(folder.resolve("drawing.png"), mesh);
    on(() -> {
      window.dialogs().saveAs(window.view().picture(), link);
      return null;
    });
    waitFor(() -> complaint() != null);
    on(() -> {
      complaint().setValue(JOptionPane.OK_OPTION);
      return null;
    });
    waitFor(() -> complaint() == null);
    assertTrue(Files.readString(mesh).startsWith("v 0 0 0"));
  }

  @Test
  void anEndingOfAnotherFormatIsKeptAndPngAdded() throws Exception {
    final Path other = Files.writeString(folder.resolve("photograph.jpg"), "a photograph");
    on(() -> {
      window.dialogs().saveAs(window.view().picture(), other);
      return null;
    });
    waitFor(() -> label("status").startsWith("saved"));
    assertEquals("a photograph", Files.readString(other));
    assertEquals(RED, ImageIO.read(folder.resolve("photograph.jpg.png").toFile()).getRGB(40, 30));
  }

  /** Whatever the reference is: a picture, the scene itself, or a text. */
  @Test
  void comparingWritesNoFile() throws Exception {
    final Path reference = folder.resolve("reference.png");
    ImageIO.write(window.view().picture(), "png", reference.toFile());
    final Path text = Files.writeString(folder.resolve("text.png"), "a text");
    final Map<Path, String> before = contents();
    for (final Path file : List.of(scene, text)) {
      on(() -> {
        window.dialogs().compareWith(file);
        return null;
      });
      waitFor(() -> complaint() != null);
      on(() -> {
        complaint().setValue(JOptionPane.OK_OPTION);
        return null;
      });
      waitFor(() -> complaint() == null);
    }
    on(() -> {
      window.dialogs().compareWith(reference);
      return null;
    });
    waitFor(() -> isShowing("comparison") && label("figures").contains("differ"));
    press("compare.close");
    assertEquals(before, contents());
  }

  /** The files of the folder with their times and bytes. */
  private Map<Path, String> contents() throws IOException {
    final Map<Path, String> contents = new HashMap<>();
    try (Stream<Path> files = Files.list(folder)) {
      for (final Path file : files.toList()) {
        contents.put(file, Files.getLastModifiedTime(file) + Arrays.toString(Files.readAllBytes(file)));
      }
    }
    return contents;
  }

  @Test
  void aReferenceOfAnotherSizeIsReported() throws Exception {
    final Path file = folder.resolve("small.png");
    ImageIO.write(new BufferedImage(3, 2, BufferedImage.TYPE_INT_RGB), "png", file.toFile());
    on(() -> {
      window.dialogs().compareWith(file);
      return null;
    });
    waitFor(() -> isShowing("comparison") && !label("figures").startsWith("Comparing"));
    assertTrue(label("figures").startsWith("The reference has 3 x 2 pixels, the picture 80 x 60"), label("figures"));
    assertFalse(on(() -> window.view().hasOverlay() || find("compare.worst").isEnabled()));
    press("compare.close");
    assertFalse(on(() -> isShowing("comparison")));
  }

  @Test
  void theWireframeRotatesAndZoomsAboutThePointer() throws Exception {
    press("wireframe");
    final WireframeView wireframe = on(() -> window.dialogs().wireframe());
    final BufferedImage empty = new BufferedImage(2 * wireframe.getWidth(), 2 * wireframe.getHeight(),
        BufferedImage.TYPE_INT_RGB);
    final Graphics g = empty.getGraphics();
    g.fillRect(0, 0, empty.getWidth(), empty.getHeight());
    g.dispose();
    waitFor(() -> inspection.Difference.between(empty, wireframe.image()).orElseThrow().differing() > 100);
    final BufferedImage before = on(wireframe::image);
    pin(40, 30);
    waitFor(() -> inspection.Difference.between(before, wireframe.image()).orElseThrow().differing() > 0);
    on(() -> {
      wireframe.turn(30, 10);
      return null;
    });
    final BufferedImage turned = on(wireframe::image);
    assertTrue(inspection.Difference.between(before, turned).orElseThrow().differing() > 100);
    on(() -> {
      wireframe.zoomAbout(50, -20, 2);
      wireframe.zoomAbout(50, -20, 0.5);
      return null;
    });
    assertEquals(0, inspection.Difference.between(turned, on(wireframe::image)).orElseThrow().differing());
    on(() -> {
      wireframe.getActionMap().get("ESCAPE").actionPerformed(null);
      return null;
    });
    assertFalse(on(() -> isShowing("wireframeDialog")));
  }

  @Test
  void settingsAreKeptAndEveryCommandHasANameAndATip() throws Exception {
    on(() -> {
      window.frame().setSize(900, 650);
      window.unpin();
      return null;
    });
    assertNull(on(() -> window.view().pinned()));
    assertNamed(window.frame().getJMenuBar());
    assertNamed(window.frame().getContentPane());
    on(() -> {
      window.close();
      return null;
    });
    assertEquals(900, new Settings(preferences).bounds().width);
    assertEquals(folder.toAbsolutePath(), new Settings(preferences).folder());
  }

  @Test
  void aSmallWindowKeepsThePictureAndTheSize() throws Exception {
    on(() -> {
      window.frame().setSize(420, 300);
      return null;
    });
    waitFor(() -> window.view().getWidth() >= 230 && window.view().getWidth() < 420 && find("size").getWidth() > 50);
    assertTrue(on(() -> window.inspector().getWidth()) >= 140);
    assertEquals(0, on(() -> find("compare").getWidth()));
    on(() -> {
      window.frame().setSize(1100, 600);
      return null;
    });
    waitFor(() -> Math.abs(window.inspector().getWidth() - window.inspector().getPreferredSize().width) <= 2);
    assertTrue(on(() -> find("compare").getWidth()) > 0);
  }

  @Test
  void theWindowIsWithinTheScreenAndReturnsToItsPlace() throws Exception {
    final Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
    assertTrue(screen.contains(on(() -> window.frame().getBounds())));
    final Rectangle place = new Rectangle(screen.x + 31, screen.y + 42, 500, 400);
    on(() -> {
      window.frame().setBounds(place);
      return null;
    });
    waitFor(() -> window.frame().getBounds().equals(place));
    on(() -> {
      window.close();
      window = new RenderWindow(new Settings(preferences), RenderPass.COLOUR, 2);
      return null;
    });
    assertEquals(place, on(() -> window.frame().getBounds()));
  }

  /** The picture follows, the file changes in three values and is restored, and home is the camera of the file. */
  @Test
  void theCameraIsMovedWrittenRestoredAndSentHome() throws Exception {
    on(() -> {
      window.camera().move(0.5, 0);
      return null;
    });
    assertTrue(label("status").startsWith("V = (-1.5, 0, 5)   C = (-1.5, 0, 0)   up = (0, 1, 0)"), label("status"));
    waitFor(() -> !window.isRunning() && window.view().picture().getRGB(40, 30) == BLUE);
    assertEquals(RED, pixel(70, 30));
    on(() -> {
      window.camera().write();
      return null;
    });
    waitFor(() -> label("status").startsWith("camera written") || Files.readString(scene).contains("-1.5 0 5"));
    assertEquals(SCENE.replace("0 0 5<", "-1.5 0 5<").replace("0 0 0<", "-1.5 0 0<"), Files.readString(scene));
    waitFor(() -> !window.isRunning() && window.job().scene().camera().getPosition().x == -1.5f);
    Thread.sleep(800);
    on(() -> {
      window.camera().undo();
      return null;
    });
    waitFor(() -> Files.readString(scene).equals(SCENE));
    waitFor(() -> !window.isRunning() && window.view().picture().getRGB(40, 30) == RED);
    on(() -> {
      window.camera().nearer(2);
      window.camera().setProjection(CameraPose.Optics.PERSPECTIVE);
      return null;
    });
    waitFor(() -> !window.isRunning() && window.job().scene().camera().getPosition().z == 2.5f);
    on(() -> {
      window.camera().home();
      return null;
    });
    waitFor(() -> !window.isRunning() && window.job().scene().camera().getPosition().z == 5);
    assertEquals(RED, pixel(40, 30));
  }

  @Test
  void theMouseTurnsTheCamera() throws Exception {
    final Robot robot = new Robot();
    final Point place = onScreen(40, 30);
    robot.mouseMove(place.x, place.y);
    robot.mousePress(InputEvent.BUTTON2_DOWN_MASK);
    for (int i = 1; i <= 10; i++) {
      robot.mouseMove(place.x - 6 * i, place.y);
    }
    robot.mouseRelease(InputEvent.BUTTON2_DOWN_MASK);
    waitFor(() -> !window.isRunning() && window.job().scene().camera().getPosition().x > 0.5);
    assertNull(on(() -> window.view().pinned()));
    on(() -> {
      window.camera().copyXml();
      return null;
    });
    final Object text = Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.stringFlavor);
    assertTrue(String.valueOf(text).matches("<camera><position>.*</up></camera>"), String.valueOf(text));
  }

  private static void assertNamed(final Container container) {
    for (final Component component : container.getComponents()) {
      if (component instanceof AbstractButton button && button.getAction() != null) {
        assertFalse(button.getAccessibleContext().getAccessibleName().isEmpty(), button::toString);
        assertNotNull(button.getAction().getValue(Action.SHORT_DESCRIPTION), button::toString);
      }
      if (component instanceof Container within) {
        assertNamed(within);
      }
    }
  }

  @Test
  void aSphereTraceIsPlottedUpToItsLastDistance() throws Exception {
    final SphereTracePlot plot = new SphereTracePlot();
    plot.setSize(200, 150);
    plot.setTrace(new SphereTrace(List.of(new SphereTrace.Step(0, 2), new SphereTrace.Step(2, 1), new SphereTrace.Step(3,
        Double.NaN),
        new SphereTrace.Step(Double.POSITIVE_INFINITY, 1)), 9, SphereTrace.End.UNDEFINED, Double.POSITIVE_INFINITY));
    final BufferedImage image = new BufferedImage(200, 150, BufferedImage.TYPE_INT_ARGB);
    plot.paintComponent(image.getGraphics());
    final int[] right = image.getRGB(185, 0, 15, 150, null, 0, 15), left = image.getRGB(0, 0, 15, 150, null, 0, 15);
    assertTrue(Arrays.stream(right).anyMatch(argb -> argb == 0xffd64545), "the last distance is missing");
    assertTrue(Arrays.stream(left).anyMatch(argb -> argb == 0xff2f7fd6), "the first distance is missing");
  }

  @Test
  void bothThemesCanBeChosen() throws Exception {
    final Color light = on(() -> window.frame().getContentPane().getBackground());
    on(() -> {
      window.switchTheme();
      return null;
    });
    final Color dark = on(() -> window.frame().getContentPane().getBackground());
    assertTrue(dark.getRed() < light.getRed());
    on(() -> {
      window.switchTheme();
      return null;
    });
  }

  @Test
  void dialogsCloseWithTheWindow() throws Exception {
    press("wireframe");
    on(() -> {
      window.close();
      return null;
    });
    for (final Window open : Window.getWindows()) {
      assertFalse(open instanceof JDialog && open.isShowing(), open.getName());
    }
  }
}
