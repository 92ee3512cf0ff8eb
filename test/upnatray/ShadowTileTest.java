package upnatray;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.Arrays;
import java.util.Random;

import lights.Directional;
import lights.Light;
import lights.LightGroup;
import lights.Omnidirectional;
import lights.Spot;
import models.Group3D;
import models.ShadowTile;
import org.junit.jupiter.api.Test;
import primitives.Point3D;
import radiometry.SpectrumRGB;
import rendering.Illumination;
import rendering.RenderSettings;
import tracer.Hit;
import tracer.Ray;
import tracer.RayGenerator;
import trials.Trials;
import view.Camera;

/** Shadow rays traced by the tile are blocked exactly where single ones are. */
class ShadowTileTest {

  /** Kinds of lights: a point, near or far, a direction, or neither. */
  private static final class Source {

    final double[] at = new double[3];
    final boolean directed;
    final double spread;

    Source(final Random random, final double unit) {
      final double away = unit * Math.pow(10, 2 * random.nextDouble() - 1);
      for (int k = 0; k < 3; k++) {
        at[k] = (float) (away * random.nextGaussian());
      }
      directed = random.nextInt(4) == 0;
      spread = random.nextInt(6) > 0 ? 0 : away * Math.pow(10, -12 * random.nextDouble());
    }

    /** The vector from a point to the light. */
    double[] from(final Random random, final Hit hit) {
      final double[] v = new double[3];
      for (int k = 0; k < 3; k++) {
        final double bent = random.nextInt(99) == 0 ? at[k] * 0x1p-50 : 0;
        v[k] = directed ? at[k] + bent : at[k] + spread * random.nextGaussian() - coordinate(hit, k);
      }
      return v;
    }

    private static double coordinate(final Hit hit, final int k) {
      return k == 0 ? hit.pointX() : k == 1 ? hit.pointY() : hit.pointZ();
    }
  }

  private int asked;
  private int blocked;

  private void compare(final Random random, final Group3D scene, final Camera camera, final Source source) {
    final int W = 16 + random.nextInt(50), H = 16 + random.nextInt(50);
    final RayGenerator generator = camera.getRayGenerator(W, H);
    final ShadowTile tile = new ShadowTile();
    final Ray[] rays = new Ray[256];
    final double[] limits = new double[256];
    int cast = 0;
    tile.clear();
    final int m = random.nextInt(W - 15), n = random.nextInt(H - 15);
    for (int i = 0; i < 256; i++) {
      final Hit hit = scene.intersectionWith(generator.getRay(m + i % 16, n + i / 16));
      if (hit.hits()) {
        final double[] v = source.from(random, hit);
        final double length = Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        final boolean outside = v[0] * hit.geometricX() + v[1] * hit.geometricY() + v[2] * hit.geometricZ() > 0;
        rays[cast] = hit.leave(outside || random.nextInt(10) == 0, v[0] / length, v[1] / length, v[2] / length);
        limits[cast] = length * (1 - 1e-9);
        tile.put(rays[cast], length, limits[cast]);
        cast++;
      }
    }
    tile.findBlocked(scene);
    for (int i = 0; i < cast; i++) {
      final boolean expected = scene.intersectAny(rays[i], limits[i]);
      final int number = i;
      assertEquals(expected, tile.isBlocked(i), () -> "ray " + number + ", " + rays[number] + " to " + limits[number]
          + (source.directed ? ", directed" : ", spread " + source.spread));
      asked++;
      blocked += expected ? 1 : 0;
    }
  }

  @Test
  void whatBlocksASingleShadowRayBlocksItInATile() {
    Trials.of(600, random -> {
      final double unit = random.nextInt(4) > 0 ? 1 : Math.pow(10, 20 * random.nextDouble() - 10);
      final RandomScene scene = new RandomScene(random, unit, 1 + random.nextInt(12));
      compare(random, scene.scene, RandomView.camera(random, scene, unit), new Source(random, unit));
    });
    assertTrue(asked > 30_000 && blocked > 5000 && blocked < asked - 5000, () -> blocked + " of " + asked);
  }

  private static Light light(final Random random, final RandomScene scene) {
    final Point3D at = scene.point();
    at.scale((float) Math.pow(10, 2 * random.nextDouble() - 1));
    final SpectrumRGB white = new SpectrumRGB(0.25f, 0.5f, 0.25f);
    switch (random.nextInt(3)) {
      case 0: return new Omnidirectional(at, white, 1000);
      case 1: return new Spot(at, scene.point(), 5 + 85 * random.nextFloat(), white, 1000);
      default: return new Directional(at, scene.point(), 5, white, 1000);
    }
  }

  private static int[] pixels(final RandomScene scene, final Camera camera, final RenderSettings settings) {
    final Image image = new Image(45, 37, Color.BLUE);
    assertTrue(image.synthesis(scene.scene, camera, settings));
    return image.getRGB(0, 0, 45, 37, null, 0, 45);
  }

  @Test
  void aLitPictureIsThatOfThePixelLoop() {
    final int[] shades = {0};
    Trials.of(60, random -> {
      final RandomScene scene = new RandomScene(random, 1, 1 + random.nextInt(12));
      final Camera camera = RandomView.camera(random, scene, 1);
      final LightGroup lights = new LightGroup();
      for (int i = random.nextInt(3); i >= 0; i--) {
        lights.addLight(light(random, scene));
      }
      final RenderSettings lit = RenderSettings.STANDARD.withShading(new Illumination(scene.scene, lights, 2, Color.BLUE));
      final int[] expected = pixels(scene, camera, lit.withPixelLoop()), found = pixels(scene, camera, lit);
      assertArrayEquals(expected, found);
      shades[0] += (int) Arrays.stream(expected).distinct().count();
    });
    assertTrue(shades[0] > 1000, () -> shades[0] + " colours");
  }
}
