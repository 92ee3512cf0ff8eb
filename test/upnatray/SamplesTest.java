package upnatray;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;

import javax.imageio.ImageIO;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import inspection.SampleScenes;
import models.Group3D;
import models.Object3D;
import models.Sphere;
import primitives.Point3D;
import primitives.Vector3D;
import rendering.Progress;
import rendering.RenderPass;
import rendering.RenderSettings;
import rendering.Shading;
import scenes.SceneFile;
import scenes.SceneReader;
import tracer.Hit;
import tracer.Ray;
import view.Angular;
import view.Camera;
import view.Perspective;

/** Several rays for each pixel, and bands of pictures. */
class SamplesTest {

  private static final Path SCENES = Path.of("scenes");

  private static Camera camera() {
    final Camera camera = new Camera(new Point3D(0, 0, 5), new Point3D(), new Vector3D(0, 1, 0));
    camera.setProjection(new Perspective(45, 1.4f));
    return camera;
  }

  private static Group3D shapes() {
    final Group3D scene = new Group3D();
    for (final Object3D object : SampleScenes.everyShape()) {
      scene.addObject(object);
    }
    return scene;
  }

  private static int[] pixels(final BufferedImage image) {
    return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
  }

  private static Image sampled(final int W, final int H, final int K, final int threads, final Color background) {
    final Image image = new Image(W, H, background);
    final RenderSettings settings = new RenderSettings(threads, Shading.FACING, Progress.NONE);
    assertTrue(image.synthesis(shapes(), camera().getRayGenerator(K * W, K * H), K, settings));
    return image;
  }

  private static double linear(final int level) {
    final double s = level / 255.0;
    return s <= 0.04045 ? s / 12.92 : Math.pow((s + 0.055) / 1.055, 2.4);
  }

  private static int encoded(final double v) {
    return (int) Math.round(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * Math.pow(v, 1 / 2.4) - 0.055));
  }

  /** The mean of a square of pixels, in linear light and with alpha premultiplied, channel by channel. */
  private static int[] mean(final BufferedImage fine, final int x, final int y, final int K) {
    final double[] sums = new double[4];
    for (int j = 0; j < K; j++) {
      for (int i = 0; i < K; i++) {
        final int argb = fine.getRGB(x * K + i, y * K + j);
        sums[3] += argb >>> 24;
        for (int channel = 0; channel < 3; channel++) {
          sums[channel] += (argb >>> 24) * linear(argb >> 8 * channel & 0xff);
        }
      }
    }
    final int[] mean = {0, 0, 0, (int) Math.round(sums[3] / (K * K))};
    for (int channel = 0; channel < 3 && sums[3] > 0; channel++) {
      mean[channel] = encoded(sums[channel] / sums[3]);
    }
    return mean;
  }

  @ParameterizedTest
  @CsvSource({"1, 40, 30", "2, 70, 50", "3, 45, 37", "4, 33, 31", "7, 20, 30", "16, 11, 9"})
  void aPixelIsTheMeanOfTheRaysOfALargerPicture(final int K, final int W, final int H) {
    for (final Color background : new Color[] {Color.WHITE, new Color(200, 100, 0, 90), new Color(0, 0, 0, 0)}) {
      final Image fine = new Image(K * W, K * H, background);
      fine.synthesis(shapes(), camera(), RenderSettings.STANDARD.withShading(Shading.FACING));
      final Image image = sampled(W, H, K, 2, background);
      int mixed = 0;
      for (int y = 0; y < H; y++) {
        for (int x = 0; x < W; x++) {
          final int argb = image.getRGB(x, y);
          mixed += argb == fine.getRGB(x * K, y * K) ? 0 : 1;
          final int[] mean = mean(fine, x, y, K);
          for (int channel = 0; channel < 4; channel++) {
            assertEquals(mean[channel], argb >> 8 * channel & 0xff, 0, "(" + x + ", " + y + ") channel " + channel);
          }
        }
      }
      assertTrue(K == 1 || mixed > W * H / 50, "only " + mixed + " pixels are mixed");
    }
  }

  @Test
  void theBitsDoNotDependOnTheThreads() {
    final int[] alone = pixels(sampled(90, 70, 5, 1, Color.BLUE));
    for (final int threads : new int[] {2, 3, 8}) {
      assertArrayEquals(alone, pixels(sampled(90, 70, 5, threads, Color.BLUE)));
    }
    final Image loop = new Image(90, 70, Color.BLUE);
    loop.synthesis(shapes(), camera().getRayGenerator(450, 350), 5,
        RenderSettings.STANDARD.withShading(Shading.FACING).withPixelLoop());
    assertArrayEquals(alone, pixels(loop));
  }

  @Test
  void pixelsOutsideAFishEyeStayBackground() {
    final Camera camera = camera();
    camera.setProjection(new Angular(170));
    final Image image = new Image(30, 30, new Color(9, 8, 7));
    image.synthesis(shapes(), camera.getRayGenerator(120, 120), 4, RenderSettings.STANDARD);
    assertEquals(0xff090807, image.getRGB(0, 0));
  }

  @ParameterizedTest
  @ValueSource(strings = {"COLOUR", "NORMALS", "DEPTH", "COST", "OBJECT", "LIGHT"})
  void bandsMakeUpThePicture(final String name) {
    final RenderPass view = RenderPass.valueOf(name);
    final SceneFile scene = SceneReader.read(SCENES.resolve("shapes.xml")).scene().orElseThrow();
    final int W = 60, H = 40, K = view == RenderPass.COLOUR ? 3 : 1;
    final RenderJob whole = RenderJob.of(scene, view, new Resolution(W, H, K, 0, H), 2);
    assertTrue(whole.run(Progress.NONE));
    final boolean isScaled = whole.scale().isPresent();
    for (final int[] band : new int[][] {{0, 1}, {1, 20}, {21, 19}}) {
      final RenderJob part = RenderJob.of(scene, view, new Resolution(W, H, K, band[0], band[1]), 2);
      assertTrue(part.run(Progress.NONE));
      assertEquals(band[1], part.image().getHeight());
      final int[] expected = whole.image().getRGB(0, band[0], W, band[1], null, 0, W);
      if (!isScaled) {
        assertArrayEquals(expected, pixels(part.image()));
      }
      assertEquals(1, part.share());
    }
  }

  /** Fails where a ray hits it at the right. */
  private static final class Faulty extends Object3D {

    private final Sphere sphere = new Sphere(new Point3D(1, 0, 0), 0.5f, Color.RED);

    Faulty() {
      super(Color.RED);
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      final Hit hit = sphere.intersectionWith(ray);
      if (hit.hits()) {
        throw new IllegalStateException("faulty");
      }
      return hit;
    }
  }

  @Test
  void aFailureNamesThePixelOfThePicture() {
    final Group3D scene = new Group3D();
    scene.addObject(new Faulty());
    final Image image = new Image(40, 40, Color.WHITE);
    final IllegalStateException failure = assertThrows(IllegalStateException.class,
        () -> image.synthesis(scene, camera().getRayGenerator(160, 160), 4, RenderSettings.STANDARD.withThreads(1)));
    final var place = java.util.regex.Pattern.compile("\\((\\d+), (\\d+)\\)").matcher(failure.getMessage());
    assertTrue(place.find(), failure.getMessage());
    final int m = Integer.parseInt(place.group(1)), n = Integer.parseInt(place.group(2));
    assertTrue(m > 20 && m < 40 && n > 10 && n < 30, failure.getMessage());
  }

  @Test
  void aRenderingThatIsStoppedSaysSo() {
    final Image image = new Image(100, 100, Color.WHITE);
    final RenderSettings once = new RenderSettings(1, Shading.PLAIN, (x, y, width, height) -> false);
    assertFalse(image.synthesis(shapes(), camera().getRayGenerator(400, 400), 4, once));
  }

  /** The larger picture alone would take 480 MB. */
  @Test
  void noImageOfAllRaysIsHeld(@TempDir final Path folder) throws Exception {
    final String scene = SCENES.resolve("colours.xml").toAbsolutePath().toString();
    final CommandLine program = new CommandLine(folder).with("-Xmx48m", "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1");
    final CommandLine.Result result = program.run(scene, "--width", "400", "--samples", "16", "-o", "a.png");
    assertEquals(0, result.status(), result.err());
    assertEquals(400, ImageIO.read(folder.resolve("a.png").toFile()).getWidth());
    assertEquals(0, program.run(scene, "--width", "400", "--rows", "21-30", "-o", "b.png").status());
    assertEquals(10, ImageIO.read(folder.resolve("b.png").toFile()).getHeight());
    final CommandLine.Result outside = program.run(scene, "--width", "400", "--rows", "21-3000", "-o", "c.png");
    assertEquals(2, outside.status());
    assertTrue(outside.err().startsWith("UPNaTRay: the rows 21-3000 are not all in the picture"), outside.err());
    assertFalse(Files.exists(folder.resolve("c.png")));
  }

  @ParameterizedTest
  @ValueSource(strings = {"--samples 0", "--samples 17", "--samples x", "--samples 2 --view depth", "--samples 2 --window",
      "--rows 5", "--rows 5-4", "--rows 0-4", "--rows -4", "--rows 3-", "--rows 1-2 --window"})
  void wrongUsage(final String args) {
    assertThrows(UsageException.class, () -> Options.of(("a.xml " + args).split(" ")));
  }
}
