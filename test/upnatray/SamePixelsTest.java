package upnatray;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.awt.Color;
import java.util.Random;

import models.Box;
import models.Cylinder;
import models.Group3D;
import models.Object3D;
import models.Triangle;
import org.junit.jupiter.api.Test;
import primitives.Point3D;
import primitives.Vector3D;
import rendering.RenderSettings;
import rendering.Shading;
import tracer.Hit;
import tracer.Ray;
import trials.Trials;
import view.Camera;
import view.Orthographic;
import view.Perspective;

/**
 * The pixels of an image are, bit for bit, those of single rays tested against all objects: tiles, trees and threads
 * leave nothing out and change nothing.
 */
class SamePixelsTest {

  private static final Color BACKGROUND = new Color(0x01020304, true);

  /** A colour in which every bit of the ray and the hit counts. */
  private static final Shading EVERYTHING = (ray, hit) -> {
    long sum = 17;
    for (final double number : new double[] {ray.startX(), ray.startY(), ray.startZ(), ray.directionX(), ray.directionY(),
        ray.directionZ(), hit.getT(), hit.pointX(), hit.pointY(), hit.pointZ(), hit.normalX(), hit.normalY(), hit.normalZ(),
        hit.getObject().getColor().getRGB()}) {
      sum = 31 * sum + Double.doubleToRawLongBits(number);
    }
    return (int) (sum ^ sum >>> 32);
  };

  private static final Shading[] SHADINGS = {Shading.PLAIN, Shading.FACING, EVERYTHING};

  private static int[] pixels(final Image image) {
    return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
  }

  private static int[] synthesised(final Group3D scene, final Camera camera, final int W, final int H,
      final Shading shading, final int threads) {
    final Image image = new Image(W, H, BACKGROUND);
    assertTrue(image.synthesis(scene, camera, RenderSettings.STANDARD.withShading(shading).withThreads(threads)));
    return pixels(image);
  }

  private static void compare(final int[] expected, final int[] found, final Object3D scene, final Camera camera,
      final int W, final String which) {
    for (int i = 0; i < expected.length; i++) {
      if (expected[i] != found[i]) {
        final Ray ray = camera.getRayGenerator(W, expected.length / W).getRay(i % W, expected.length / W - 1 - i / W);
        final Hit hit = scene.intersectionWith(ray);
        fail(which + ": pixel " + i % W + ", " + i / W + " of " + W + " x " + expected.length / W + " is "
            + Integer.toHexString(found[i]) + " instead of " + Integer.toHexString(expected[i]) + "; single rays find "
            + hit + " on " + ray + " by " + camera.getProjection().getClass().getSimpleName());
      }
    }
  }

  private static int extent(final Random random) {
    return random.nextInt(6) == 0 ? 1 : 1 + random.nextInt(70);
  }

  /** Returns how many pixels show an object. */
  private static int compare(final Random random, final double unit) {
    final RandomScene scene = new RandomScene(random, unit, 1 + random.nextInt(25));
    final Camera camera = RandomView.camera(random, scene, unit);
    final int W = extent(random), H = extent(random);
    int shown = 0;
    for (final Shading shading : SHADINGS) {
      final int[] found = synthesised(scene.scene, camera, W, H, shading, 1 + random.nextInt(3));
      final int[] single = SingleRays.pixels(scene.scene, camera, W, H, BACKGROUND.getRGB(), shading);
      final String name = shading == EVERYTHING ? "everything" : shading == Shading.PLAIN ? "plain" : "facing";
      compare(single, found, scene.scene, camera, W, name + " against single rays");
      final int[] linear = SingleRays.pixels(scene.linear, camera, W, H, BACKGROUND.getRGB(), shading);
      compare(linear, found, scene.linear, camera, W, name + " against all objects");
      for (final int pixel : single) {
        shown += pixel == BACKGROUND.getRGB() ? 0 : 1;
      }
    }
    return shown / SHADINGS.length;
  }

  @Test
  void arePixelsOfSingleRays() {
    final int[] shown = {0};
    Trials.of(40, random -> shown[0] += compare(random, 1));
    assertTrue(shown[0] > 10_000, () -> "only " + shown[0] + " pixels show an object");
  }

  /** A camera at the edge of objects that extend far beyond its view: solids, and triangles as large. */
  private static int atTheEdgeOfHugeThings(final Random random) {
    final Group3D scene = new Group3D();
    for (int i = 0; i < 3; i++) {
      final float size = (float) Math.pow(10, 16 * random.nextDouble());
      final Point3D C = new Point3D(random.nextInt(2) * size / 2, (random.nextInt(3) - 1) * size / 2, -size / 2 - i);
      final Vector3D x = new Vector3D(1, 0, 0), y = new Vector3D(0, 1, 0.1f);
      final Vector3D along = random.nextBoolean() ? x : new Vector3D(random.nextFloat(), random.nextFloat(), 1);
      final Color color = new Color(random.nextInt(1 << 24));
      scene.addObject(random.nextBoolean() ? new Box(C, along, y, size, size, size, color)
          : random.nextBoolean() ? new Box(new Point3D(0, 0.3f, C.z), x, new Vector3D(0, 1, 0), 1, 1, size, color)
          : random.nextBoolean() ? new Cylinder(C, along, size / 2, size, color)
          : new Triangle(new Point3D(random.nextFloat(), 0, -1), new Point3D(size, random.nextFloat(), -2),
              new Point3D(0, size, -size), color));
    }
    final Point3D V = new Point3D(random.nextFloat() - 0.5f, random.nextFloat() - 0.5f, 2 * random.nextFloat());
    final Camera camera = new Camera(V, new Point3D(0.1f, 0.2f, -3), new Vector3D(0, 1, 0));
    camera.setProjection(random.nextBoolean() ? new Perspective(80, 1) : new Orthographic(3, 1));
    final int[] found = synthesised(scene, camera, 60, 60, Shading.PLAIN, 1);
    final int[] single = SingleRays.pixels(scene, camera, 60, 60, BACKGROUND.getRGB(), Shading.PLAIN);
    compare(single, found, scene, camera, 60, "huge things against single rays");
    int shown = 0;
    for (final int pixel : single) {
      shown += pixel == BACKGROUND.getRGB() ? 0 : 1;
    }
    return shown;
  }

  @Test
  void ofHugeThingsNoEdgeIsLost() {
    final int[] shown = {0};
    Trials.of(30, random -> shown[0] += atTheEdgeOfHugeThings(random));
    assertTrue(shown[0] > 20_000, () -> "only " + shown[0] + " pixels show an object");
  }

  @Test
  void arePixelsOfSingleRaysAtAllScales() {
    final int[] shown = {0};
    Trials.of(20, random -> shown[0] += compare(random, Math.pow(10, 40 * random.nextDouble() - 20)));
    assertTrue(shown[0] > 5_000, () -> "only " + shown[0] + " pixels show an object");
  }
}
