package window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Enumeration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.ResourceBundle;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;

import inspection.ColourStep;
import inspection.ContractViolation;
import models.Group3D;
import models.SphereTrace;
import primitives.Point3D;
import primitives.Vector3D;
import diagnostics.Problem;
import upnatray.PngFile;
import rendering.RenderPass;
import view.Camera;
import view.Orthographic;

/** The parts of the window that need no display. */
class PartsTest {

  @Test
  void sizesAreParsed() {
    assertEquals(Optional.of(new PictureSize(50, 0, 0)), PictureSize.of("50 %"));
    assertEquals(Optional.of(new PictureSize(0, 640, 480)), PictureSize.of(" 640x480"));
    assertEquals(Optional.of(new PictureSize(0, 640, 0)), PictureSize.of("640 x ?"));
    for (final String wrong : new String[] {"", "0 %", "0 x 480", "? x ?", "640", "large", "-5 x 5", "1000000 x 2"}) {
      assertEquals(Optional.empty(), PictureSize.of(wrong), wrong);
    }
    for (final PictureSize size : List.of(PictureSize.OWN, new PictureSize(0, 3, 4), new PictureSize(0, 0, 4))) {
      assertEquals(Optional.of(size), PictureSize.of(size.toString()));
    }
  }

  @Test
  void oneSideAloneKeepsTheProportion() {
    final PictureSize half = new PictureSize(50, 0, 0), wide = new PictureSize(0, 100, 0), high = new PictureSize(0, 0, 90);
    assertEquals(32, half.widthOf(64, 48));
    assertEquals(75, wide.heightOf(64, 48));
    assertEquals(120, high.widthOf(64, 48));
    assertEquals(90, high.heightOf(64, 48));
    assertEquals(1, new PictureSize(1, 0, 0).heightOf(64, 48));
  }

  @Test
  void zoomingKeepsWhatIsUnderThePointer() {
    final Zoom zoom = Zoom.fit(200, 100, 400, 400);
    assertEquals(new Zoom(2, 0, 100), zoom);
    final Point pointer = new Point(301, 205);
    final Point pixel = zoom.pixelAt(pointer);
    assertEquals(new Point(150, 52), pixel);
    Zoom other = zoom;
    for (int i = 0; i < 30; i++) {
      other = other.about(pointer, 1.25);
      assertEquals(pixel, other.pixelAt(pointer));
    }
    assertEquals(64, other.scale());
    assertTrue(other.onScreen(new Rectangle(pixel.x, pixel.y, 1, 1)).contains(pointer));
  }

  @Test
  void aProgressivePictureShowsThePreviousOneUntilATileIsDone() {
    final BufferedImage before = new BufferedImage(4, 4, BufferedImage.TYPE_INT_ARGB);
    final BufferedImage next = new BufferedImage(4, 4, BufferedImage.TYPE_INT_ARGB);
    before.setRGB(0, 0, 0xff111111);
    final ProgressivePicture picture = new ProgressivePicture(next, before);
    assertEquals(0xff111111, picture.image().getRGB(0, 0));
    next.setRGB(3, 3, 0xff333333);
    picture.tileDone(2, 2, 2, 2);
    assertEquals(0xff333333, picture.image().getRGB(3, 3));
    assertEquals(0xff111111, picture.image().getRGB(0, 0));
    assertEquals(new Rectangle(2, 2, 2, 2), picture.takeChanged());
    assertTrue(picture.takeChanged().isEmpty());
    assertEquals(0, new ProgressivePicture(next, new BufferedImage(5, 4, BufferedImage.TYPE_INT_ARGB)).image().getRGB(3,
        3));
  }

  @Test
  void changedFilesAreReportedOnce(@TempDir final Path folder) throws Exception {
    final Path scene = Files.writeString(folder.resolve("a.xml"), "one"), other = folder.resolve("b.obj");
    final Semaphore changes = new Semaphore(0);
    final SceneWatch watch = new SceneWatch(changes::release);
    try {
      watch.watch(List.of(scene, other));
      Files.writeString(scene, "one and two");
      assertTrue(changes.tryAcquire(10, TimeUnit.SECONDS));
      Files.writeString(other, "it was not there");
      assertTrue(changes.tryAcquire(10, TimeUnit.SECONDS));
      assertFalse(changes.tryAcquire(1, TimeUnit.SECONDS));
      watch.watch(List.of(other));
      Files.delete(scene);
      assertFalse(changes.tryAcquire(1, TimeUnit.SECONDS));
    } finally {
      watch.stop();
    }
  }

  @Test
  void picturesAreSavedAndReadBack(@TempDir final Path folder) throws Exception {
    final BufferedImage picture = new BufferedImage(3, 2, BufferedImage.TYPE_INT_ARGB);
    picture.setRGB(2, 1, 0x80123456);
    final Path file = PictureFile.withExtension(folder.resolve("picture"));
    PngFile.save(picture, file);
    assertEquals(folder.resolve("picture.png"), file);
    assertEquals(0x80123456, PictureFile.read(file).getRGB(2, 1));
  }

  @Test
  void aFailureIsLocatedWhereItWasCaused() {
    final Exception failure = assertThrows(IndexOutOfBoundsException.class, () -> new ArrayList<>().get(0));
    final Problem problem = Failure.problem(new IllegalStateException("outer", failure));
    assertEquals("PartsTest.java", problem.file());
    assertTrue(problem.line() > 0);
    assertEquals("PartsTest.java:" + problem.line() + ": outer", problem.toString());
    failure.setStackTrace(new StackTraceElement[0]);
    assertEquals("", Failure.problem(failure).file());
  }

  @Test
  void invalidArgumentsOfShowAreRejectedAtOnce() {
    final Group3D objects = new Group3D();
    final Camera camera = new Camera(new Point3D(0, 0, 5), new Point3D(), new Vector3D(0, 1, 0));
    final Color black = Color.BLACK;
    assertThrows(IllegalStateException.class, () -> RenderWindow.show("", objects, camera, 4, 3, black));
    camera.setProjection(new Orthographic(3, 0.75f));
    for (final Executable wrong : List.<Executable>of(() -> RenderWindow.show(null, objects, camera, 4, 3, black),
        () -> RenderWindow.show("", null, camera, 4, 3, black), () -> RenderWindow.show("", objects, null, 4, 3, black),
        () -> RenderWindow.show("", objects, camera, 0, 3, black),
        () -> RenderWindow.show("", objects, camera, 4, -3, black),
        () -> RenderWindow.show("", objects, camera, 4, 3, null))) {
      assertThrows(IllegalArgumentException.class, wrong);
    }
    if (GraphicsEnvironment.isHeadless()) {
      assertThrows(IllegalStateException.class, () -> RenderWindow.show("", objects, camera, 4, 3, black));
    }
  }

  private static Set<String> keys(final ResourceBundle bundle) {
    final Set<String> keys = new TreeSet<>();
    for (final Enumeration<String> all = bundle.getKeys(); all.hasMoreElements();) {
      keys.add(all.nextElement());
    }
    return keys;
  }

  @Test
  void everyMessageExistsInBothLanguages() {
    final ResourceBundle.Control alone = ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_DEFAULT);
    final ResourceBundle english = ResourceBundle.getBundle("window.messages", Locale.ROOT, alone);
    final ResourceBundle spanish = ResourceBundle.getBundle("window.messages", new Locale("es"), alone);
    final Set<String> keys = keys(english);
    assertEquals(keys, keys(spanish));
    int same = 0;
    for (final String key : keys) {
      same += english.getString(key).equals(spanish.getString(key)) ? 1 : 0;
    }
    assertTrue(same < keys.size() / 4, "not translated: " + same);
    for (final Object kind : List.of(ContractViolation.values(), SphereTrace.End.values(), ColourStep.Kind.values(),
        RenderPass.values(),
        Problem.Severity.values()).stream().flatMap(java.util.Arrays::stream).toList()) {
      final String prefix = kind instanceof ContractViolation ? "violation." : kind instanceof SphereTrace.End ? "trace."
          : kind instanceof ColourStep.Kind ? "colour." : kind instanceof RenderPass ? "pass." : "problems.";
      assertTrue(keys.contains(prefix + kind) || keys.contains(prefix + kind + ".text"), prefix + kind);
    }
  }
}
