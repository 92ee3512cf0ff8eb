package rendering;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;

import org.junit.jupiter.api.Test;

import models.Group3D;
import models.Object3D;
import models.RandomNumbers;
import primitives.Point3D;
import radiometry.RadianceRGB;
import tracer.Hit;
import tracer.Ray;
import upnatray.Image;
import view.Camera;
import view.Perspective;

/** Illumination agrees with {@link RecursiveTracer} in scenes of all materials and lights, with bent normals. */
class RecursiveTracerTest {

  /** The sum of the contributions reported to an observer. */
  private static final class Sum implements LightObserver {

    private RadianceRGB total = RadianceRGB.NORADIANCE;

    @Override
    public void light(final Contribution contribution) {
      total = contribution.outcome() == Outcome.LIT ? total.plus(contribution.radiance()) : total;
    }

    @Override
    public void background(final Ray ray, final int depth, final RadianceRGB radiance) {
      total = total.plus(radiance);
    }
  }

  private static void assertClose(final RadianceRGB expected, final RadianceRGB found, final double part, final Ray ray,
      final RandomNumbers numbers) {
    final double tolerance = part * (1e-3 + expected.getR() + expected.getG() + expected.getB());
    assertEquals(expected.getR(), found.getR(), tolerance, () -> ray + "; " + numbers);
    assertEquals(expected.getG(), found.getG(), tolerance, () -> ray + "; " + numbers);
    assertEquals(expected.getB(), found.getB(), tolerance, () -> ray + "; " + numbers);
  }

  @Test
  void radianceIsThatOfTheRecursion() {
    final RandomNumbers numbers = new RandomNumbers("recursion");
    int hits = 0;
    for (int i = 0; i < RandomNumbers.times(20); i++) {
      final List<Object3D> objects = LitScenes.objects(numbers);
      final Group3D scene = new Group3D();
      objects.forEach(scene::addObject);
      final int depth = i % 7;
      final Illumination light = new Illumination(scene, LitScenes.lights(), depth, LitScenes.SKY).withExposure(-1);
      final RecursiveTracer oracle = new RecursiveTracer(objects, LitScenes.lights().getLights(), depth, LitScenes.SKY, -1);
      for (int k = 0; k < 150; k++) {
        final Ray ray = new Ray(numbers.pointAbout(new Point3D(0, 3, 0), 6), numbers.pointAbout(new Point3D(0, 1, 0), 1.5));
        final Hit hit = scene.intersectionWith(ray);
        final Sum sum = new Sum();
        final RadianceRGB radiance = light.radiance(ray, hit, LightObserver.NONE);
        hits += hit.hits() ? 1 : 0;
        assertClose(oracle.radiance(ray), radiance, 1e-5, ray, numbers);
        assertEquals(radiance.toString(), light.radiance(ray, hit, sum).toString());
        assertClose(radiance, sum.total, 1e-12, ray, numbers);
      }
    }
    assertTrue(hits > 2000 * RandomNumbers.times(1), "hits: " + hits);
  }

  /** The pixels of tiles, whose lights and shadows are found together, are those of single rays, bit for bit. */
  @Test
  void picturesByTilesAreThoseOfSingleRays() {
    final RandomNumbers numbers = new RandomNumbers("lit tiles");
    for (int i = 0; i < RandomNumbers.times(8); i++) {
      final Group3D scene = new Group3D();
      LitScenes.objects(numbers).forEach(scene::addObject);
      final Point3D eye = numbers.pointAbout(new Point3D(0, 4, 0), 5);
      final Camera camera = new Camera(eye, new Point3D(0, 1, 0), numbers.direction());
      camera.setProjection(new Perspective(50, 1));
      final RenderSettings settings = RenderSettings.STANDARD.withThreads(1)
          .withShading(new Illumination(scene, LitScenes.lights(), i % 4, LitScenes.SKY));
      assertArrayEquals(pixels(scene, camera, settings.withPixelLoop()), pixels(scene, camera, settings),
          () -> "seen from " + eye + "; " + numbers);
    }
  }

  private static int[] pixels(final Group3D scene, final Camera camera, final RenderSettings settings) {
    final Image image = new Image(70, 50, LitScenes.SKY);
    image.synthesis(scene, camera, settings);
    return image.getRGB(0, 0, 70, 50, null, 0, 70);
  }
}
