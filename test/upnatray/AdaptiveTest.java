package upnatray;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Arrays;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rendering.AdaptiveSampling;
import rendering.Progress;
import rendering.RenderPass;
import rendering.RenderSettings;
import rendering.Shading;
import scenes.SceneFile;
import scenes.SceneReader;

/** Several rays for those pixels alone that lie at edges. */
class AdaptiveTest {

  private static SceneFile scene(final String name) {
    return SceneReader.read(Path.of("scenes", name + ".xml")).scene().orElseThrow();
  }

  private static int[] pixels(final BufferedImage image) {
    return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
  }

  private static int[] render(final SceneFile scene, final RenderPass view, final Resolution resolution, final int threads) {
    final RenderJob job = RenderJob.of(scene, view, resolution, threads);
    assertTrue(job.run(Progress.NONE));
    assertEquals(1, job.share());
    return pixels(job.image());
  }

  private static int[] render(final SceneFile scene, final Resolution resolution) {
    return render(scene, RenderPass.COLOUR, resolution, 2);
  }

  private static int difference(final int p, final int q) {
    int most = 0;
    for (int shift = 0; shift < 32; shift += 8) {
      most = Math.max(most, Math.abs((p >> shift & 0xff) - (q >> shift & 0xff)));
    }
    return most;
  }

  /** Each pixel is that of one ray or that of all; the latter at least where one of its four neighbours differs. */
  @ParameterizedTest
  @CsvSource({"shapes, COLOUR, 3, 150, 100", "stilllife, COLOUR, 4, 120, 80", "stilllife, NORMALS, 2, 120, 80",
    "stilllife, OBJECT, 4, 99, 66", "stilllife, LIGHT, 2, 60, 40", "glass, COLOUR, 16, 33, 22", "angular, COLOUR, 4, 70, 70",
    "chess, COLOUR, 5, 97, 70"})
  void aPixelIsThatOfOneRayOrThatOfAll(final String name, final RenderPass view, final int K, final int W, final int H) {
    final SceneFile scene = scene(name);
    final int[] one = render(scene, view, Resolution.of(W, H), 2);
    final int[] all = render(scene, view, new Resolution(W, H, K, 0, H), 2);
    final int[] adaptive = render(scene, view, new Resolution(W, H, K, true, 0, H), 2);
    int refined = 0, kept = 0;
    for (int i = 0; i < W * H; i++) {
      final int x = i % W, p = one[i];
      final boolean edge = x > 0 && difference(p, one[i - 1]) > AdaptiveSampling.STEP
          || x < W - 1 && difference(p, one[i + 1]) > AdaptiveSampling.STEP
          || i >= W && difference(p, one[i - W]) > AdaptiveSampling.STEP
          || i < W * (H - 1) && difference(p, one[i + W]) > AdaptiveSampling.STEP;
      assertTrue(adaptive[i] == all[i] || !edge && adaptive[i] == one[i], "pixel " + i);
      refined += adaptive[i] != one[i] ? 1 : 0;
      kept += adaptive[i] != all[i] ? 1 : 0;
    }
    assertTrue(refined > W * H / 50 && kept > 0, refined + " refined, " + kept + " kept of " + W * H);
  }

  @ParameterizedTest
  @CsvSource({"stilllife, 4", "chess, 3", "glass, 16"})
  void theBitsDependNeitherOnTheThreadsNorOnTheBand(final String name, final int K) {
    final SceneFile scene = scene(name);
    final int W = 210, H = 130;
    final int[] whole = render(scene, RenderPass.COLOUR, new Resolution(W, H, K, true, 0, H), 1);
    assertArrayEquals(whole, render(scene, RenderPass.COLOUR, new Resolution(W, H, K, true, 0, H), 3));
    for (final int[] band : new int[][] {{0, 1}, {1, 60}, {61, 69}}) {
      assertArrayEquals(Arrays.copyOfRange(whole, band[0] * W, (band[0] + band[1]) * W),
          render(scene, RenderPass.COLOUR, new Resolution(W, H, K, true, band[0], band[1]), 2), "from row " + band[0]);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"stilllife", "shapes", "smooth", "glass", "lights"})
  void thePixelLoopGivesTheSamePicture(final String name) {
    final SceneFile scene = scene(name);
    final int W = 70, H = 50;
    final Resolution resolution = new Resolution(W, H, 2, true, 0, H);
    final Image image = new Image(W, H, scene.background());
    assertTrue(image.synthesis(scene.objects(), scene.camera(), resolution,
        RenderSettings.STANDARD.withShading(RenderJob.shading(scene)).withPixelLoop()));
    assertArrayEquals(render(scene, resolution), pixels(image));
  }

  /** Of a picture with one ray, the still life's mean difference to 4 x 4 rays is at least twice as great. */
  @Test
  void theMeanDifferenceToAllRaysIsSmall() {
    final SceneFile scene = scene("stilllife");
    final int W = 180, H = 120;
    final int[] all = render(scene, new Resolution(W, H, 4, 0, H));
    final double one = meanDifference(render(scene, Resolution.of(W, H)), all);
    final double adaptive = meanDifference(render(scene, new Resolution(W, H, 4, true, 0, H)), all);
    assertTrue(adaptive < 1 && adaptive < one / 2, adaptive + " instead of " + one);
  }

  private static double meanDifference(final int[] a, final int[] b) {
    long sum = 0;
    for (int i = 0; i < a.length; i++) {
      for (int shift = 0; shift < 24; shift += 8) {
        sum += Math.abs((a[i] >> shift & 0xff) - (b[i] >> shift & 0xff));
      }
    }
    return sum / 3.0 / a.length;
  }

  @Test
  void aRenderingThatIsStoppedSaysSo() {
    final SceneFile scene = scene("shapes");
    final Image image = new Image(300, 200, scene.background());
    final RenderSettings once = new RenderSettings(1, Shading.PLAIN, (x, y, width, height) -> false);
    assertFalse(image.synthesis(scene.objects(), scene.camera(), new Resolution(300, 200, 2, true, 0, 200), once));
  }
}
