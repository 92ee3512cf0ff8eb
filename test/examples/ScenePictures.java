package examples;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;

import javax.imageio.ImageIO;

import rendering.RenderPass;
import rendering.RenderSettings;
import rendering.Supersampling;
import scenes.SceneFile;
import scenes.SceneReader;
import upnatray.Image;
import upnatray.RenderJob;

/** Writes the pictures of passes and meshes that the documentation shows; {@code ant javadoc} calls it. */
public final class ScenePictures {

  private static final int WIDTH = 320;
  private static final int SAMPLES = 4;

  private ScenePictures() {
  }

  /** Writes the PNG files into the folders doc-files of the packages, below the folder given as the only argument. */
  public static void main(final String... arguments) throws IOException {
    for (final Map.Entry<String, BufferedImage> picture : pictures().entrySet()) {
      final File file = Path.of(arguments[0]).resolve(picture.getKey()).toFile();
      Files.createDirectories(file.toPath().getParent());
      if (!ImageIO.write(picture.getValue(), "png", file)) {
        throw new IOException("no writer of PNG files");
      }
    }
  }

  /** By the path of the file, its picture. */
  static Map<String, BufferedImage> pictures() {
    final Map<String, BufferedImage> pictures = new LinkedHashMap<>();
    final SceneFile stillLife = scene("stilllife");
    for (final RenderPass pass : RenderPass.values()) {
      pictures.put("rendering/doc-files/" + pass.option() + ".png", picture(stillLife, pass, WIDTH));
    }
    pictures.put("rendering/doc-files/Illumination.png", picture(scene("glass"), RenderPass.COLOUR, WIDTH));
    pictures.put("rendering/doc-files/Supersampling.png", sampled(scene("shapes")));
    pictures.put("meshes/doc-files/ObjFile.png", picture(scene("teapot"), RenderPass.COLOUR, WIDTH));
    pictures.put("meshes/doc-files/MaterialFiles.png", picture(scene("house"), RenderPass.COLOUR, WIDTH));
    pictures.put("meshes/doc-files/TextureFile.png", picture(scene("balls"), RenderPass.COLOUR, WIDTH));
    return pictures;
  }

  private static SceneFile scene(final String name) {
    return SceneReader.read(Path.of("scenes", name + ".xml")).scene().orElseThrow();
  }

  private static int height(final SceneFile scene, final int width) {
    return width * scene.height() / scene.width();
  }

  private static Image picture(final SceneFile scene, final RenderPass pass, final int width) {
    final RenderJob job = new RenderJob(scene, pass, width, height(scene, width), 2);
    job.run((x, y, columns, rows) -> true);
    return job.image();
  }

  /** One ray for each pixel on the left, several on the right, enlarged. */
  private static BufferedImage sampled(final SceneFile scene) {
    final int W = WIDTH / 4, H = height(scene, W);
    final BufferedImage right = new BufferedImage(W, H, BufferedImage.TYPE_INT_ARGB);
    final int[] pixels = new int[W * H];
    final RenderSettings settings = RenderSettings.STANDARD.withShading(RenderJob.shading(scene));
    new Supersampling(scene.objects(), scene.camera().getRayGenerator(SAMPLES * W, SAMPLES * H), SAMPLES, settings)
        .render(pixels, scene.background().getRGB(), Thread::new);
    right.setRGB(0, 0, W, H, pixels, 0, W);
    final BufferedImage both = new BufferedImage(WIDTH, 2 * H, BufferedImage.TYPE_INT_ARGB);
    final Graphics2D graphics = both.createGraphics();
    graphics.drawImage(picture(scene, RenderPass.COLOUR, W), 0, 0, 2 * W, 2 * H, null);
    graphics.drawImage(right, 2 * W, 0, 2 * W, 2 * H, null);
    graphics.dispose();
    return both;
  }
}
