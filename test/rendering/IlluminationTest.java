package rendering;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;

import javax.vecmath.Vector3f;

import lights.Directional;
import lights.LightGroup;
import lights.Omnidirectional;
import lights.Spot;
import materials.IdealConductor;
import materials.IdealDielectric;
import materials.Lambertian;
import materials.Material;
import models.AffineTransformation;
import models.Box;
import models.Capsule;
import models.Cylinder;
import models.Ellipsoid;
import models.Group3D;
import models.Object3D;
import models.Plane;
import models.RandomNumbers;
import models.Sphere;
import models.Torus;
import models.TriangularMesh;
import org.junit.jupiter.api.Test;
import primitives.Point3D;
import primitives.Vector3D;
import radiometry.RadianceRGB;
import radiometry.ReflectanceRGB;
import radiometry.SpectrumRGB;
import tracer.Hit;
import tracer.Ray;
import upnatray.Image;
import view.Camera;
import view.Perspective;

/** Illumination: worked examples, and laws that hold for every scene. */
class IlluminationTest {

  private static final SpectrumRGB WHITE = new SpectrumRGB(1f / 3, 1f / 3, 1f / 3);
  private static final Material MIRROR = new IdealConductor(new ReflectanceRGB(1, 1, 1));
  private static final Material GLASS = new IdealDielectric(new ReflectanceRGB(1, 1, 1), 1.5f, 1);
  private static final Color SKY = new Color(120, 160, 200);

  private static Group3D group(final Object3D... objects) {
    final Group3D group = new Group3D();
    for (final Object3D object : objects) {
      group.addObject(object);
    }
    return group;
  }

  private static Object3D floor(final Color color) {
    return new Plane(new Point3D(), new Vector3D(0, 1, 0), color);
  }

  private static Object3D floor(final Material material) {
    return new Plane(new Point3D(), new Vector3D(0, 1, 0), material);
  }

  private static LightGroup lamp(final double x, final double y, final double z, final double power) {
    return new LightGroup(new Omnidirectional(new Point3D((float) x, (float) y, (float) z), WHITE, (float) power));
  }

  private static RadianceRGB radiance(final Group3D scene, final LightGroup lights, final int depth, final Point3D from,
      final Point3D to) {
    final Ray ray = new Ray(from, to);
    return new Illumination(scene, lights, depth, SKY).radiance(ray, scene.intersectionWith(ray), LightObserver.NONE);
  }

  @Test
  void matteFloorUnderALampHasThePaperValue() {
    final double E = 100 / (4 * Math.PI * 4), kd = 0.5029;
    final Group3D scene = group(floor(new Color(188, 188, 188)));
    final RadianceRGB L = radiance(scene, lamp(0, 2, 0, 100), 0, new Point3D(1, 1, 1), new Point3D());
    assertEquals(kd / Math.PI * E, L.getR(), 1e-4 * E);
    assertEquals(L.getR(), L.getB());
    final double aslant = 100 / (4 * Math.PI * 8) * Math.sqrt(0.5);
    assertEquals(kd / Math.PI * aslant, radiance(scene, lamp(0, 2, 0, 100), 0, new Point3D(3, 1, 1), new Point3D(2, 0, 0))
        .getR(), 1e-4 * E);
    final RadianceRGB below = radiance(scene, lamp(0, 2, 0, 100), 0, new Point3D(0, -1, 0), new Point3D(0.5f, 0, 0));
    assertEquals(0, below.getR());
  }

  @Test
  void pixelIsEncodedByTheFormula() {
    for (int i = -10; i <= 100_000; i++) {
      final double v = i / 99_000.0, cut = Math.max(0, Math.min(1, v));
      final double s = cut <= 0.0031308 ? 12.92 * cut : 1.055 * Math.pow(cut, 1 / 2.4) - 0.055;
      assertEquals((int) Math.floor(255 * s + 0.5), SrgbEncoding.channel(v), () -> "v = " + v);
    }
    assertEquals(255, SrgbEncoding.channel(Double.POSITIVE_INFINITY));
    final Illumination light = new Illumination(group(), new LightGroup(), 5, SKY);
    assertEquals(0xffffffff, light.argb(new RadianceRGB(0.1, 0.2, 1e9)));
    assertEquals(light.argb(new RadianceRGB(0.04, 0.02, 0)), light.withExposure(-2).argb(new RadianceRGB(0.16, 0.08, 0)));
    assertEquals(SKY.getRGB(), light.withExposure(3).argb(light.withExposure(3).backgroundRadiance()));
  }

  /** The picture of a scene, by the given settings. */
  private static int[] pixels(final Group3D scene, final Camera camera, final RenderSettings settings) {
    final Image image = new Image(61, 47, SKY);
    image.synthesis(scene, camera, settings);
    return image.getRGB(0, 0, 61, 47, null, 0, 61);
  }

  private static Camera camera(final Point3D from, final Point3D to) {
    final Camera camera = new Camera(from, to, new Vector3D(0.1f, 1, 0));
    camera.setProjection(new Perspective(50, 1.3f));
    return camera;
  }

  private static Group3D stillLife() {
    final TriangularMesh mesh = TriangularMesh.of(new float[] {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1},
        new int[] {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5}, Color.ORANGE);
    final Group3D scene = group(floor(Color.LIGHT_GRAY), new Sphere(new Point3D(-2, 1, 0), 1, GLASS),
        new Sphere(new Point3D(0, 1, -2), 1, MIRROR),
        new Torus(new Point3D(2, 0.6f, 0), new Vector3D(1, 3, 0), 0.8f, 0.3f, Color.GREEN),
        new Box(new Point3D(0, 0.5f, 2), new Vector3D(1, 0, 1), new Vector3D(0, 1, 0), 1, 1, 1, Color.PINK),
        new AffineTransformation(new Vector3f(0.5f, 1, -0.7f), new Vector3f(0, 1, 1), 40, new Vector3f(3, 1, -3), mesh),
        new AffineTransformation(new Vector3f(0.7f, 0.4f, 0.7f), new Vector3f(0, 1, 0), 0, new Vector3f(-3, 0.4f, 2),
            new Sphere(new Point3D(), 1, MIRROR)));
    return scene;
  }

  private static LightGroup threeLights() {
    final LightGroup lights = lamp(3, 6, 4, 120);
    lights.addLight(new Spot(new Point3D(-4, 5, 3), new Point3D(0, 0, 0), 25, new SpectrumRGB(0.6f, 0.3f, 0.1f), 40));
    lights.addLight(new Directional(new Point3D(0, 9, -3), new Point3D(0, 0, 0), 2.5f, new SpectrumRGB(0, 0, 1), 10));
    return lights;
  }

  @Test
  void tilesGiveThePixelsOfTheLoopForAnyNumberOfThreads() {
    final Group3D scene = stillLife();
    final Shading light = new Illumination(scene, threeLights(), 6, SKY);
    final Camera camera = camera(new Point3D(1, 3, 9), new Point3D(0, 0.5f, 0));
    final RenderSettings settings = RenderSettings.STANDARD.withShading(light);
    final int[] expected = pixels(scene, camera, settings.withPixelLoop());
    for (final int threads : new int[] {1, 2, 3, 8}) {
      assertArrayEquals(expected, pixels(scene, camera, settings.withThreads(threads)), threads + " threads");
    }
    final Image standard = new Image(61, 47, SKY);
    standard.synthesis(scene, camera, threeLights());
    final Shading five = new Illumination(scene, threeLights(), 5, SKY);
    assertArrayEquals(pixels(scene, camera, settings.withShading(five)), standard.getRGB(0, 0, 61, 47, null, 0, 61));
  }

  /** An object that only reflects or transmits is invisible before a uniform background. */
  @Test
  void furnaceHidesPerfectMirrorsAndGlass() {
    final Point3D C = new Point3D(0.3f, 0.1f, -0.2f);
    final Vector3D u = new Vector3D(1, 2, 0.5f), aux = new Vector3D(-2, 1, 0);
    for (final Material material : List.of(MIRROR, GLASS)) {
      for (final Object3D shape : List.of(new Sphere(C, 1, material), new Box(C, u, aux, 1.5f, 1, 1.2f, material),
          new Cylinder(C, u, 0.7f, 1.5f, material), new Capsule(C, u, 0.6f, 1, material),
          new Torus(C, u, 0.9f, 0.4f, material), new Ellipsoid(C, u, aux, 1, 0.5f, 0.7f, material))) {
        final Group3D scene = group(shape);
        final Illumination light = new Illumination(scene, new LightGroup(), 12, SKY).withExposure(1.5);
        final int[] picture = pixels(scene, camera(new Point3D(0, 0.5f, 4), C), RenderSettings.STANDARD.withShading(light));
        int wrong = 0;
        for (final int pixel : picture) {
          for (int shift = 0; shift < 24; shift += 8) {
            wrong += Math.abs((pixel >> shift & 255) - (SKY.getRGB() >> shift & 255)) > 1 ? 1 : 0;
          }
        }
        final boolean trapping = material == GLASS && !(shape instanceof Sphere);
        final int seen = wrong;
        assertTrue(wrong <= (trapping ? 200 : 0), () -> seen + " channels of " + shape + " in " + material + " are seen");
      }
    }
  }

  /** Radiance grows by the square of the index of refraction, whatever is reflected to and fro on the way. */
  @Test
  void cameraWithinGlassSeesTheSkyBrighter() {
    final Group3D scene = group(new Sphere(new Point3D(), 1, GLASS));
    final double sky = new ReflectanceRGB(SKY).getR() / 10.0;
    final RandomNumbers numbers = new RandomNumbers("within glass");
    for (int i = 0; i < 100; i++) {
      final Point3D to = numbers.pointAbout(new Point3D(), 0.5);
      assertEquals(2.25 * sky, radiance(scene, new LightGroup(), 12, new Point3D(), to).getR(), 1e-4 * sky,
          () -> to + "; " + numbers);
    }
  }

  @Test
  void facingMirrorsOfDepthTenThousandComeToAnEnd() {
    final Group3D scene = group(floor(MIRROR),
        new Plane(new Point3D(0, 1, 0), new Vector3D(0, -1, 0), MIRROR));
    final int[] count = new int[1];
    final Ray ray = new Ray(new Point3D(0, 0.5f, 0), new Vector3D(0.01f, -1, 0));
    new Illumination(scene, new LightGroup(), 10_000, SKY).radiance(ray, scene.intersectionWith(ray), new LightObserver() {
      @Override
      public void surface(final LightObserver.Surface surface) {
        assertEquals(count[0]++, surface.depth());
      }
    });
    assertEquals(10_001, count[0]);
  }

  @Test
  void depthCountsTheImagesInAMirror() {
    final Group3D scene = group(floor(MIRROR));
    final Point3D from = new Point3D(0, 1, 0), to = new Point3D(1, 0, 0);
    assertEquals(0, radiance(scene, new LightGroup(), 0, from, to).getR());
    assertEquals(new ReflectanceRGB(SKY).getR() / 10.0, radiance(scene, new LightGroup(), 1, from, to).getR(), 1e-9);
  }

  @Test
  void sceneOfAnotherScaleHasTheSamePicture() {
    for (final float s : new float[] {0x1p-10f, 0x1p10f}) {
      final double[][] L = new double[2][];
      for (int i = 0; i < 2; i++) {
        final float k = i == 0 ? 1 : s;
        final Group3D scene = group(floor(Color.GRAY), new Sphere(new Point3D(0, k, 0), k, Color.RED));
        final List<Double> all = new ArrayList<>();
        for (int j = 0; j < 200; j++) {
          all.add(radiance(scene, lamp(2 * k, 4 * k, k, 100 * k * k), 3, new Point3D(0, 2 * k, 6 * k),
              new Point3D(k * (j % 20 - 10) / 5, k * (j / 20) / 4, 0)).getR());
        }
        L[i] = all.stream().mapToDouble(x -> x).toArray();
      }
      assertArrayEquals(L[0], L[1], 1e-5, "scale " + s);
    }
  }

  /** The pictures of single lights, and what is seen of the sky, add up to the picture. */
  @Test
  void radianceIsTheSumOfThePassesOfTheLights() {
    final Group3D scene = stillLife();
    final Illumination whole = new Illumination(scene, threeLights(), 4, SKY);
    final Illumination dark = new Illumination(scene, new LightGroup(), 4, SKY);
    final RandomNumbers numbers = new RandomNumbers("light passes");
    for (int i = 0; i < 300; i++) {
      final Ray ray = new Ray(new Point3D(1, 3, 9), numbers.pointAbout(new Point3D(0, 0.5f, 0), 3));
      final Hit hit = scene.intersectionWith(ray);
      if (hit.hits()) {
        RadianceRGB sum = dark.radiance(ray, hit, LightObserver.NONE);
        for (int light = 0; light < 3; light++) {
          sum = sum.plus(whole.ofLight(light).radiance(ray, hit, LightObserver.NONE));
        }
        final RadianceRGB all = whole.radiance(ray, hit, LightObserver.NONE);
        assertEquals(all.getR(), sum.getR(), 1e-12 * all.getR(), () -> ray + "; " + numbers);
        assertEquals(all.getB(), sum.getB(), 1e-12 * all.getB(), () -> ray + "; " + numbers);
      }
    }
    assertThrows(IllegalArgumentException.class, () -> whole.ofLight(3));
  }

  @Test
  void wrongArgumentsAreRejected() {
    final LightGroup none = new LightGroup();
    assertThrows(IllegalArgumentException.class, () -> new Illumination(null, none, 1, SKY));
    assertThrows(IllegalArgumentException.class, () -> new Illumination(group(), null, 1, SKY));
    assertThrows(IllegalArgumentException.class, () -> new Illumination(group(), none, -1, SKY));
    assertThrows(IllegalArgumentException.class, () -> new Illumination(group(), none, 1, null));
    final Illumination light = new Illumination(group(), none, 0, SKY);
    for (final double stops : new double[] {-20.1, 20.1, Double.NaN}) {
      assertThrows(IllegalArgumentException.class, () -> light.withExposure(stops));
    }
    assertEquals(20, light.withExposure(20).exposure());
  }

  @Test
  void mattePaintIsTheDecodedColour() {
    final Lambertian grey = new Lambertian(new ReflectanceRGB(Color.GRAY));
    final Point3D from = new Point3D(1, 1, 1), to = new Point3D();
    assertEquals(radiance(group(floor(grey)), lamp(0, 2, 0, 100), 0, from, to).getG(),
        radiance(group(floor(Color.GRAY)), lamp(0, 2, 0, 100), 0, from, to).getG());
  }
}
