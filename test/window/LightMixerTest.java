package window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.BitSet;
import java.util.Map;
import java.util.Set;

import org.junit.jupiter.api.Test;

import inspection.Difference;
import lights.Light;
import lights.LightGroup;
import lights.Omnidirectional;
import materials.IdealConductor;
import models.Group3D;
import models.Sphere;
import primitives.Point3D;
import primitives.Vector3D;
import radiometry.ReflectanceRGB;
import radiometry.SpectrumRGB;
import rendering.Progress;
import rendering.RenderPass;
import scenes.Lighting;
import scenes.SceneFile;
import upnatray.RenderJob;
import view.Camera;
import view.Perspective;

class LightMixerTest {

  private static final int W = 40;
  private static final int H = 30;
  private static final Light WARM = new Omnidirectional(new Point3D(4, 4, 4), new SpectrumRGB(0.5f, 0.3f, 0.2f), 40);
  private static final Light COLD = new Omnidirectional(new Point3D(-4, 2, 4), new SpectrumRGB(0.2f, 0.3f, 0.5f), 30);

  private static SceneFile scene(final int depth, final Light... lights) {
    final Group3D objects = new Group3D();
    objects.addObject(new Sphere(new Point3D(-1, 0, 0), 1, Color.ORANGE));
    objects.addObject(new Sphere(new Point3D(1, 0, 0), 1, new IdealConductor(new ReflectanceRGB(0.9f, 0.9f, 0.9f))));
    final Camera camera = new Camera(new Point3D(0, 1, 5), new Point3D(), new Vector3D(0, 1, 0));
    camera.setProjection(new Perspective(50, 4f / 3));
    return new SceneFile("", W, H, new Color(60, 80, 120, 200), new Lighting(true, false, new LightGroup(lights), depth, 0),
        camera, objects, Map.of(), Set.of());
  }

  private static BufferedImage rendered(final SceneFile scene) {
    final RenderJob job = new RenderJob(scene, RenderPass.COLOUR, W, H, 1);
    assertTrue(job.run(Progress.NONE));
    return job.image();
  }

  private static BitSet lights(final int... numbers) {
    final BitSet on = new BitSet();
    for (final int number : numbers) {
      on.set(number);
    }
    return on;
  }

  private static void assertSame(final BufferedImage expected, final BufferedImage actual) {
    assertTrue(Difference.between(expected, actual).orElseThrow().largest() <= 1);
  }

  /** The law of linearity: any subset looks like a scene with only these lights, within the rounding of a level. */
  @Test
  void everyMixtureIsThePictureWithTheseLights() {
    for (final int depth : new int[] {0, 3}) {
      final LightMixer mixer = new LightMixer(scene(3, WARM, COLD), W, H);
      assertSame(rendered(scene(depth, WARM, COLD)), mixer.mix(lights(0, 1), depth, Set.of(), () -> false));
      assertSame(rendered(scene(depth, WARM)), mixer.mix(lights(0), depth, Set.of(), () -> false));
      assertSame(rendered(scene(depth, COLD)), mixer.mix(lights(1), depth, Set.of(), () -> false));
      assertEquals(0xc83c5078, mixer.mix(lights(), depth, Set.of(), () -> false).getRGB(0, 0));
    }
  }

  /** The mirror is the only material with an ideal part, and shadows only darken. */
  @Test
  void effectsAreLeftOut() {
    final LightMixer mixer = new LightMixer(scene(3, WARM, COLD), W, H);
    assertSame(rendered(scene(0, WARM, COLD)),
        mixer.mix(lights(0, 1), 3, Set.of(SelectiveSum.Effect.MIRRORS), () -> false));
    assertSame(rendered(scene(3, WARM, COLD)),
        mixer.mix(lights(0, 1), 3, Set.of(SelectiveSum.Effect.GLASS), () -> false));
    final Light side = new Omnidirectional(new Point3D(5, 0, 1.5f), new SpectrumRGB(0.3f, 0.4f, 0.3f), 40);
    final BufferedImage unshadowed = new LightMixer(scene(0, side), W, H)
        .mix(lights(0), 0, Set.of(SelectiveSum.Effect.SHADOWS), () -> false);
    final BufferedImage shadowed = rendered(scene(0, side));
    int brighter = 0;
    for (int i = 0; i < W * H; i++) {
      final int a = unshadowed.getRGB(i % W, i / W) >> 8 & 0xff, b = shadowed.getRGB(i % W, i / W) >> 8 & 0xff;
      assertTrue(a >= b - 1);
      brighter += a > b + 1 ? 1 : 0;
    }
    assertTrue(brighter > 5, "brighter: " + brighter);
  }

  @Test
  void aCancelledMixtureIsNone() {
    assertNull(new LightMixer(scene(3, WARM), W, H).mix(lights(0), 3, Set.of(), () -> true));
  }
}
