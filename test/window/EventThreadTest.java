package window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Color;
import java.awt.Point;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentSkipListSet;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

import javax.imageio.ImageIO;
import javax.swing.JOptionPane;
import javax.swing.JTree;
import javax.swing.SwingUtilities;

import org.junit.jupiter.api.Test;

import lights.Light;
import lights.LightGroup;
import materials.Material;
import materials.SpecularRays;
import materials.SurfaceInteraction;
import models.Group3D;
import models.Sphere;
import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import radiometry.RadianceRGB;
import radiometry.SpectrumRGB;
import scenes.Lighting;
import scenes.SceneFile;
import tracer.Hit;
import tracer.Ray;
import view.Camera;
import view.Perspective;

/** The event dispatch thread waits neither for rays nor for files nor for large pictures. */
class EventThreadTest extends WindowFixture {

  /** What the event dispatch thread called, and what any other thread called. */
  private final Set<String> onEventThread = new ConcurrentSkipListSet<>();
  private final Set<String> elsewhere = new ConcurrentSkipListSet<>();

  private void called(final String method) {
    (SwingUtilities.isEventDispatchThread() ? onEventThread : elsewhere).add(method);
  }

  private final class OwnShape extends Sphere {

    OwnShape() {
      super(new Point3D(), 1, new OwnMaterial());
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      called("intersectionWith");
      return super.intersectionWith(ray);
    }

    @Override
    public BoundingBox getBoundingBox() {
      called("getBoundingBox");
      return super.getBoundingBox();
    }

    @Override
    public List<Object> constructorArguments() {
      called("constructorArguments");
      return super.constructorArguments();
    }

    @Override
    public String toString() {
      called("toString");
      return super.toString();
    }
  }

  private final class OwnMaterial extends Material {

    @Override
    public void scatter(final SurfaceInteraction interaction) {
      called("scatter");
      interaction.setRadiance(0.3, 0.3, 0.3);
    }

    @Override
    public boolean specular(final double cosine, final boolean outside, final SpecularRays rays) {
      called("specular");
      return false;
    }
  }

  private final class OwnLight extends Light {

    OwnLight() {
      super(new Point3D(1, 2, 5), new SpectrumRGB(0.4f, 0.3f, 0.3f), 10);
    }

    @Override
    public Point3D getPosition() {
      called("getPosition");
      return super.getPosition();
    }

    @Override
    public RadianceRGB getIrradianceAt(final Point3D P) {
      called("getIrradianceAt");
      return new RadianceRGB(0.1, 0.1, 0.1);
    }
  }

  private SceneFile own() {
    final Group3D objects = new Group3D();
    objects.addObject(new OwnShape());
    final Camera camera = new Camera(new Point3D(0, 0, 5), new Point3D(), new Vector3D(0, 1, 0));
    camera.setProjection(new Perspective(40, 4f / 3));
    return new SceneFile("own", 40, 30, Color.BLUE, new Lighting(true, false, new LightGroup(new OwnLight()), 2, 0), camera,
        objects, Map.of(), Set.of());
  }

  @Test
  void neitherShapesNorMaterialsNorLightsAreCalledOnIt() throws Exception {
    final SceneFile scene = own();
    onEventThread.clear();
    run(() -> window.open(scene));
    waitFor(() -> !window.isRunning() && window.job() != null && window.job().scene() == scene);
    run(window::showWireframe);
    pin(20, 15);
    run(() -> selectAll((JTree) find("inspection")));
    waitFor(() -> find("polar").isVisible());
    press("copyTest");
    waitFor(() -> label("status").startsWith("test copied"));
    run(window::showLights);
    waitFor(() -> isShowing("lights"));
    press("lights.1");
    waitFor(() -> window.view().preview() != null);
    run(() -> window.camera().turn(20, 5));
    waitFor(() -> !window.isRunning() && window.job().scene() != scene);
    run(() -> window.setSamples(new Samples(2, false)));
    waitFor(() -> !window.isRunning() && window.job().samples() == 2);
    assertEquals(Set.of(), onEventThread);
    assertTrue(elsewhere.containsAll(Set.of("intersectionWith", "getBoundingBox", "constructorArguments", "toString",
        "scatter", "specular", "getPosition", "getIrradianceAt")), elsewhere::toString);
  }

  private static void selectAll(final JTree tree) {
    for (int row = 0; row < tree.getRowCount(); row++) {
      tree.expandRow(row);
      tree.setSelectionRow(row);
      if (find("polar").isVisible()) {
        return;
      }
    }
    for (int row = 0; row < tree.getRowCount(); row++) {
      if (tree.getPathForRow(row).getLastPathComponent().toString().startsWith("Light 1")) {
        tree.setSelectionRow(row);
      }
    }
  }

  /** A named pipe: whoever opens it waits until the other end is opened too. */
  private Path pipe(final String name) throws IOException, InterruptedException {
    final Path pipe = folder.resolve(name);
    try {
      assumeTrue(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor() == 0);
    } catch (final IOException noPipes) {
      assumeTrue(false, noPipes::toString);
    }
    return pipe;
  }

  /** Runs an action on the event dispatch thread, and a second one, which therefore did not wait for anything. */
  private void run(final Runnable action) throws Exception {
    on(() -> {
      action.run();
      return null;
    });
    on(() -> window.frame().getTitle());
  }

  @Test
  void aReferenceThatCannotBeReadYetIsAwaitedElsewhere() throws Exception {
    final Path pipe = pipe("slow.png");
    run(() -> window.dialogs().compareWith(pipe));
    assertNull(on(WindowFixture::complaint));
    Files.writeString(pipe, "a picture that cannot be read twice");
    waitFor(() -> complaint() != null);
    on(() -> {
      complaint().setValue(JOptionPane.OK_OPTION);
      return null;
    });
  }

  @Test
  void aSceneThatCannotBeReadYetIsAwaitedElsewhere() throws Exception {
    final Path pipe = pipe("slow.xml");
    run(() -> window.open(pipe));
    run(() -> window.camera().write());
    run(() -> window.renderAgain());
    assertTrue(label("status").startsWith("reading slow.xml"), label("status"));
    run(() -> window.open(scene));
    waitFor(() -> !window.isRunning() && window.job() != null);
    assertEquals(RED, pixel(40, 30));
  }

  /** A picture whose pixels cannot be read before it is released. */
  private final class Slow extends BufferedImage {

    private final CountDownLatch released = new CountDownLatch(1);
    private volatile boolean waited;

    Slow(final BufferedImage source) {
      super(source.getWidth(), source.getHeight(), TYPE_INT_ARGB);
      setData(source.getRaster());
    }

    private void await() {
      called("pixels");
      waited = true;
      try {
        released.await(20, TimeUnit.SECONDS);
      } catch (final InterruptedException stopped) {
        throw new IllegalStateException(stopped);
      }
    }

    @Override
    public int[] getRGB(final int x, final int y, final int width, final int height, final int[] pixels, final int offset,
        final int scan) {
      await();
      return super.getRGB(x, y, width, height, pixels, offset, scan);
    }

    @Override
    public ColorModel getColorModel() {
      if (released != null) {
        await();
      }
      return super.getColorModel();
    }
  }

  @Test
  void aLargePictureIsSavedElsewhere() throws Exception {
    final Slow picture = new Slow(window.view().picture());
    final Path target = folder.resolve("large.png");
    run(() -> window.dialogs().saveAs(picture, target));
    waitFor(() -> picture.waited);
    assertFalse(Files.exists(target));
    picture.released.countDown();
    waitFor(() -> label("status").startsWith("saved"));
    assertEquals(RED, ImageIO.read(target.toFile()).getRGB(40, 30));
    assertEquals(Set.of(), onEventThread);
  }

  @Test
  void largePicturesAreComparedElsewhere() throws Exception {
    final Slow reference = new Slow(window.view().picture());
    run(() -> new Comparison(window, reference, Path.of("large.png")));
    waitFor(() -> reference.waited);
    assertEquals("Comparing ...", label("figures"));
    reference.released.countDown();
    waitFor(() -> label("figures").startsWith("0 pixels differ"));
    assertEquals(Set.of(), onEventThread);
    press("compare.close");
  }
}
