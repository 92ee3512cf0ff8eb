package rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;

import models.Group3D;
import models.Sphere;
import org.junit.jupiter.api.Test;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;
import upnatray.Image;
import view.Camera;
import view.Perspective;

class RenderSettingsTest {

  /** A ball that counts the calls of its intersection. */
  private static final class Counting extends Sphere {

    private int count;

    Counting() {
      super(new Point3D(), 1, Color.RED);
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      count++;
      return super.intersectionWith(ray);
    }
  }

  /** So a breakpoint there stops at each ray, also of objects in groups within the scene. */
  @Test
  void pixelLoopAsksEachShapeForEachPixel() {
    final Camera camera = new Camera(new Point3D(0, 0, 5), new Point3D(), new Vector3D(0, 1, 0));
    camera.setProjection(new Perspective(60, 1));
    final Counting ball = new Counting();
    final Group3D inner = new Group3D(), scene = new Group3D();
    inner.addObject(ball);
    scene.addObject(inner);
    final Image image = new Image(8, 6, Color.BLACK);
    image.synthesis(scene, camera, RenderSettings.STANDARD.withPixelLoop());
    assertEquals(48, ball.count);
    assertEquals(Color.RED.getRGB(), image.getRGB(4, 3));
    assertEquals(Color.BLACK.getRGB(), image.getRGB(0, 0));
  }

  @Test
  void theStandardUsesAllCoresAndPlainColours() {
    assertEquals(Runtime.getRuntime().availableProcessors(), RenderSettings.STANDARD.threads());
    assertSame(Shading.PLAIN, RenderSettings.STANDARD.shading());
    assertSame(Progress.NONE, RenderSettings.STANDARD.progress());
    assertTrue(Progress.NONE.tileDone(0, 0, 16, 16));
  }

  @Test
  void changesOnePartAndKeepsTheOthers() {
    final Progress progress = (x, y, width, height) -> false;
    final RenderSettings rendering =
        RenderSettings.STANDARD.withThreads(3).withShading(Shading.FACING).withProgress(progress);
    assertEquals(new RenderSettings(3, Shading.FACING, progress), rendering);
    assertEquals(new RenderSettings(5, Shading.FACING, progress), rendering.withThreads(5));
    assertEquals(new RenderSettings(3, Shading.PLAIN, progress), rendering.withShading(Shading.PLAIN));
    assertEquals(new RenderSettings(3, Shading.FACING, Progress.NONE), rendering.withProgress(Progress.NONE));
  }

  @Test
  void rejectsWrongParts() {
    assertThrows(IllegalArgumentException.class, () -> RenderSettings.STANDARD.withThreads(0));
    assertThrows(IllegalArgumentException.class, () -> RenderSettings.STANDARD.withThreads(-3));
    assertThrows(IllegalArgumentException.class, () -> RenderSettings.STANDARD.withShading(null));
    assertThrows(IllegalArgumentException.class, () -> RenderSettings.STANDARD.withProgress(null));
  }
}
