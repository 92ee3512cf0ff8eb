package rendering;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

import javax.vecmath.Vector3f;

import org.junit.jupiter.api.Test;

import models.AffineTransformation;
import models.Box;
import models.Capsule;
import models.Cylinder;
import models.Egg;
import models.Ellipsoid;
import models.Group3D;
import models.Object3D;
import models.Plane;
import models.Sphere;
import models.Torus;
import models.Triangle;
import models.TruncatedCone;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;
import tracer.RayGenerator;
import trials.Trials;
import view.Camera;
import view.Perspective;

/**
 * The laws that every {@link Shading} must obey, as tests. The test of a shading implements this interface and so
 * inherits them; it has to implement one method:
 *
 * <pre>{@code
 * class FlatTest implements rendering.ShadingContract {
 *   public rendering.Shading shading(Group3D scene) {
 *     return rendering.Shading.PLAIN;
 *   }
 * }
 * }</pre>
 */
public interface ShadingContract {

  /**
   * The shading to be tested.
   *
   * @param scene the scene whose hits it is to shade, about the origin and a few units large
   * @return the shading
   */
  Shading shading(Group3D scene);

  /** Objects of all kinds: in a ring about the origin, above a plane, and one of them in a group. */
  private static Group3D scene() {
    final Point3D O = new Point3D();
    final Vector3D i = new Vector3D(1, 0.2f, 0), j = new Vector3D(0.1f, 1, 0.3f);
    final List<Object3D> objects = List.of(new Sphere(O, 0.7f, Color.RED), new Box(O, i, j, 0.9f, 0.6f, 1, Color.ORANGE),
        new Cylinder(O, j, 0.4f, 1, Color.YELLOW), new Capsule(O, i, 0.3f, 0.8f, new Color(20, 200, 60, 128)),
        new Torus(O, j, 0.5f, 0.2f, Color.CYAN), new Ellipsoid(O, i, j, 0.8f, 0.5f, 0.3f, Color.BLUE),
        new Egg(O, j, 0.5f, 0.7f, 0.2f, Color.MAGENTA), new TruncatedCone(O, j, 0.5f, 0, 0.9f, Color.PINK),
        new Triangle(new Point3D(-0.6f, -0.5f, 0), new Point3D(0.6f, -0.4f, 0.2f), new Point3D(0, 0.7f, 0), Color.GRAY));
    final Group3D scene = new Group3D(), group = new Group3D();
    for (int k = 0; k < objects.size(); k++) {
      final double angle = 2 * Math.PI * k / objects.size();
      final Vector3f place = new Vector3f((float) (2 * Math.cos(angle)), 0, (float) (2 * Math.sin(angle)));
      (k == 0 ? group : scene).addObject(
          new AffineTransformation(new Vector3f(1, 1, 1), new Vector3f(0, 1, 0), 10 * k, place, objects.get(k)));
    }
    scene.addObject(group);
    scene.addObject(new Plane(new Point3D(0, -1, 0), new Vector3D(0, 1, 0), Color.WHITE));
    return scene;
  }

  private static RayGenerator rays(final int W, final int H) {
    final Camera camera = new Camera(new Point3D(1, 3, 7), new Point3D(), new Vector3D(0, 1, 0));
    camera.setProjection(new Perspective(45, (float) W / H));
    return camera.getRayGenerator(W, H);
  }

  /** From outside, or from within the ring of objects, or of one of them. */
  private static Ray ray(final Random random) {
    final float far = random.nextBoolean() ? 2 : 8;
    return new Ray(new Point3D(far * (float) random.nextGaussian(), far * random.nextFloat() - 0.5f,
        far * (float) random.nextGaussian()),
        new Vector3D((float) random.nextGaussian(), (float) random.nextGaussian() - 0.3f, (float) random.nextGaussian()));
  }

  /** Every hit has a colour, whichever side of which object it is on, and the same colour when computed again. */
  @Test
  default void everyHitHasOneColour() {
    final Group3D scene = scene();
    final Shading shading = shading(scene);
    final int[] hits = {0};
    Trials.of(2000, random -> {
      final Ray ray = ray(random);
      final Hit hit = scene.intersectionWith(ray);
      if (hit.hits()) {
        hits[0]++;
        assertEquals(shading.argb(ray, hit), shading.argb(ray, hit), () -> "asked again about " + ray);
      }
    });
    assertTrue(hits[0] > 500, () -> "only " + hits[0] + " hits");
  }

  /** Tiles and threads show the colours that the loop over the pixels shows. */
  @Test
  default void tilesAndThreadsShowTheColoursOfTheLoop() {
    final Group3D scene = scene();
    final int[] loop = new int[90 * 60], tiles = new int[90 * 60];
    final RenderSettings settings = RenderSettings.STANDARD.withShading(shading(scene));
    final int background = Color.DARK_GRAY.getRGB();
    settings.withPixelLoop().render(scene, rays(90, 60), settings.colours(loop, background), Thread::new);
    settings.withThreads(3).render(scene, rays(90, 60), settings.colours(tiles, background), Thread::new);
    assertArrayEquals(loop, tiles);
  }

  /** Concurrent calls do not disturb each other. */
  @Test
  default void threadsDoNotDisturbEachOther() throws InterruptedException {
    final Group3D scene = scene();
    final Shading shading = shading(scene);
    final RayGenerator rays = rays(60, 40);
    final List<int[]> pictures = new ArrayList<>();
    final List<Thread> threads = new ArrayList<>();
    for (int k = 0; k < 4; k++) {
      final int[] picture = new int[60 * 40];
      pictures.add(picture);
      threads.add(new Thread(() -> paint(scene, shading, rays, picture)));
    }
    threads.forEach(Thread::start);
    for (final Thread thread : threads) {
      thread.join();
    }
    pictures.forEach(picture -> assertArrayEquals(pictures.get(0), picture));
  }

  private static void paint(final Group3D scene, final Shading shading, final RayGenerator rays, final int[] picture) {
    for (int i = 0; i < picture.length; i++) {
      final Ray ray = rays.getRay(i % rays.getWidth(), i / rays.getWidth());
      final Hit hit = scene.intersectionWith(ray);
      picture[i] = hit.hits() ? shading.argb(ray, hit) : 1;
    }
  }
}
