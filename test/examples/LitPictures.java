package examples;

import java.awt.Color;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Function;

import javax.imageio.ImageIO;

import lights.Directional;
import lights.LightGroup;
import lights.Omnidirectional;
import lights.Spot;
import materials.AshikhminShirley;
import materials.Beckmann;
import materials.Blinn;
import materials.GGX;
import materials.Horn;
import materials.IdealConductor;
import materials.IdealDielectric;
import materials.Lambertian;
import materials.Material;
import materials.NormalDistributionFunction;
import materials.OrenNayar;
import materials.PhongLafortune;
import materials.ReflectiveCookTorrance;
import materials.Torrance;
import materials.TransmissiveCookTorrance;
import models.Box;
import models.Group3D;
import models.Sphere;
import primitives.Point3D;
import primitives.Vector3D;
import radiometry.ReflectanceRGB;
import radiometry.SpectrumRGB;
import rendering.Illumination;
import rendering.RenderSettings;
import upnatray.Image;
import view.Camera;
import view.Perspective;

/** Writes the pictures of materials and lights that the documentation shows; {@code ant javadoc} calls it. */
public final class LitPictures {

  private static final int WIDTH = 320;
  private static final int HEIGHT = 240;
  private static final int RECURSION = 8;
  private static final Color NOTHING = new Color(0, 0, 0, 0);
  private static final Color SKY = new Color(200, 215, 235);
  private static final SpectrumRGB WHITE = new SpectrumRGB(1 / 3f, 1 / 3f, 1 / 3f);
  private static final SpectrumRGB WARM = new SpectrumRGB(0.4f, 0.34f, 0.26f);
  private static final Vector3D X = new Vector3D(1, 0, 0);
  private static final Vector3D Y = new Vector3D(0, 1, 0);
  private static final Point3D O = new Point3D(0, 0, 0);

  private LitPictures() {
  }

  /** Writes the PNG files into the folders doc-files of the packages, below the folder given as the only argument. */
  public static void main(final String... arguments) throws IOException {
    for (final Map.Entry<String, Material> ball : materials().entrySet()) {
      write(picture(ball.getValue(), daylight()), Path.of(arguments[0], "materials", "doc-files"), ball.getKey());
    }
    for (final Map.Entry<String, LightGroup> light : lights().entrySet()) {
      write(picture(matte(0.8f, 0.55f, 0.2f), light.getValue()), Path.of(arguments[0], "lights", "doc-files"),
          light.getKey());
    }
  }

  private static void write(final Image image, final Path folder, final String name) throws IOException {
    final File file = Files.createDirectories(folder).resolve(name + ".png").toFile();
    if (!ImageIO.write(image, "png", file)) {
      throw new IOException("no writer of PNG files");
    }
  }

  /** By the name of the class, one of its materials or distributions. */
  static Map<String, Material> materials() {
    final ReflectanceRGB ochre = k(0.8f, 0.5f, 0.15f), darkRed = k(0.5f, 0.06f, 0.05f), coat = k(0.3f, 0.3f, 0.3f);
    final Map<String, Material> materials = new LinkedHashMap<>();
    materials.put("Lambertian", new Lambertian(ochre));
    materials.put("OrenNayar", new OrenNayar(ochre, 50));
    materials.put("PhongLafortune", new PhongLafortune(darkRed, coat, new Blinn(9)));
    materials.put("ReflectiveCookTorrance",
        new ReflectiveCookTorrance(k(0.04f, 0.02f, 0.015f), k(0.95f, 0.64f, 0.54f), new Beckmann(20)));
    materials.put("AshikhminShirley", new AshikhminShirley(k(0.1f, 0.3f, 0.6f), k(0.06f, 0.06f, 0.06f), new Blinn(5)));
    materials.put("IdealConductor", new IdealConductor(k(0.9f, 0.88f, 0.82f)));
    materials.put("IdealDielectric", new IdealDielectric(k(1, 1, 1), 1.5f, 1));
    materials.put("TransmissiveCookTorrance", new TransmissiveCookTorrance(k(0.9f, 1, 0.95f), 1.5f, 1, new GGX(12)));
    final Map<String, Function<Float, NormalDistributionFunction>> distributions = Map.of("Blinn", Blinn::new,
        "Horn", Horn::new, "Torrance", Torrance::new, "GGX", GGX::new, "Beckmann", Beckmann::new);
    distributions.forEach((name, of) -> materials.put(name,
        new PhongLafortune(k(0.05f, 0.12f, 0.2f), k(0.7f, 0.7f, 0.7f), of.apply(15f))));
    return materials;
  }

  /** By the name of the class, one of its lights and little else. */
  static Map<String, LightGroup> lights() {
    final Point3D above = new Point3D(-1.8f, 3.2f, 1.8f);
    final Map<String, LightGroup> lights = new LinkedHashMap<>();
    lights.put("Omnidirectional", new LightGroup(new Omnidirectional(above, WARM, 50), faint()));
    lights.put("Spot", new LightGroup(new Spot(above, O, 22, WARM, 2.5f), faint()));
    lights.put("Directional", new LightGroup(new Directional(above, O, 1.3f, WARM, 1.5f), faint()));
    return lights;
  }

  private static LightGroup daylight() {
    return new LightGroup(new Omnidirectional(new Point3D(-4, 6, 5), WARM, 220),
        new Omnidirectional(new Point3D(6, 3, 3), WHITE, 50), faint());
  }

  private static Omnidirectional faint() {
    return new Omnidirectional(new Point3D(0.5f, 2, 9), WHITE, 25);
  }

  private static ReflectanceRGB k(final float r, final float g, final float b) {
    return new ReflectanceRGB(r, g, b);
  }

  private static Material matte(final float r, final float g, final float b) {
    return new Lambertian(k(r, g, b));
  }

  /** A ball on a floor of tiles, with two small ones that it can mirror. */
  private static Image picture(final Material material, final LightGroup lights) {
    final Group3D scene = new Group3D();
    scene.addObject(new Sphere(O, 1, material));
    scene.addObject(new Sphere(new Point3D(-1.6f, -0.6f, -0.9f), 0.4f, matte(0.7f, 0.12f, 0.08f)));
    scene.addObject(new Sphere(new Point3D(1.5f, -0.65f, 0.7f), 0.35f, matte(0.1f, 0.3f, 0.7f)));
    final Material light = matte(0.75f, 0.72f, 0.66f), dark = matte(0.3f, 0.32f, 0.35f);
    for (int i = -5; i < 5; i++) {
      for (int j = -6; j < 4; j++) {
        scene.addObject(new Box(new Point3D(0.8f * i + 0.4f, -1.1f, 0.8f * j + 0.4f), X, Y, 0.8f, 0.2f, 0.8f,
            (i + j) % 2 == 0 ? light : dark));
      }
    }
    final Camera camera = new Camera(new Point3D(0.6f, 1.6f, 6), new Point3D(0, -0.15f, 0), Y);
    camera.setProjection(new Perspective(28, (float) WIDTH / HEIGHT));
    final Image image = new Image(WIDTH, HEIGHT, NOTHING);
    image.synthesis(scene, camera,
        RenderSettings.STANDARD.withShading(new Illumination(scene, lights, RECURSION, SKY)));
    return image;
  }
}
