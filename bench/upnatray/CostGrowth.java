package upnatray;

import java.awt.Color;
import java.lang.management.ManagementFactory;
import java.lang.ref.Reference;
import java.util.Locale;
import java.util.SplittableRandom;

import lights.LightGroup;
import lights.Omnidirectional;
import materials.IdealConductor;
import materials.IdealDielectric;
import materials.Lambertian;
import materials.Material;
import models.Group3D;
import models.Plane;
import models.Sphere;
import models.TriangularMesh;
import primitives.Point3D;
import primitives.Vector3D;
import radiometry.ReflectanceRGB;
import radiometry.SpectrumRGB;
import rendering.Illumination;
import rendering.RenderSettings;

/**
 * How the cost of a picture grows: {@code bench/cost-growth} prints a table each for the numbers of triangles, spheres,
 * lights, reflections and pixels. Rates are millions of pixels per CPU second of one thread, after the code is compiled;
 * the scenes are made at random, the same in every run.
 */
public final class CostGrowth {

  private static final double WARM_UP = 2;
  private static final double MEASURED = 2;
  private static final int SIDE = 512;

  private CostGrowth() {
  }

  /**
   * Prints the tables.
   *
   * @param args names of tables, {@code triangles}, {@code spheres}, {@code lights}, {@code depth} or {@code pixels}
   * @throws IllegalArgumentException if there is no table of a name
   */
  public static void main(final String[] args) {
    for (final String table : args) {
      switch (table) {
        case "triangles" -> triangles();
        case "spheres" -> spheres();
        case "lights" -> lights();
        case "depth" -> depths();
        case "pixels" -> pixels();
        default -> throw new IllegalArgumentException(table);
      }
    }
  }

  private static void triangles() {
    for (final int number : new int[] {1000, 10_000, 100_000, 1_000_000, 4_000_000}) {
      final float[] coordinates = BenchmarkScene.coordinates(number);
      final int[] corners = BenchmarkScene.corners(number);
      final long before = used(), start = System.nanoTime();
      final TriangularMesh mesh = TriangularMesh.of(coordinates, corners, Color.ORANGE);
      final double build = (System.nanoTime() - start) * 1e-9;
      final double bytes = (used() - before) / (corners.length / 3.0);
      Reference.reachabilityFence(coordinates);
      Reference.reachabilityFence(corners);
      final Group3D scene = new Group3D();
      scene.addObject(mesh);
      print("triangles", number, rate(scene, SIDE, RenderSettings.STANDARD),
          String.format(Locale.ROOT, "build %.3f s", build)
              + (number < 100_000 ? "" : String.format(Locale.ROOT, ", %.1f bytes a triangle", bytes)));
    }
  }

  /** Bytes in use after collecting garbage. */
  private static long used() {
    System.gc();
    return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
  }

  /** Spheres that cover about the same part of the picture, whatever their number. */
  private static void spheres() {
    for (final int number : new int[] {10, 100, 1000, 10_000, 100_000}) {
      final SplittableRandom random = new SplittableRandom(1);
      final Group3D scene = new Group3D();
      for (int i = 0; i < number; i++) {
        scene.addObject(new Sphere(point(random, 1.5), (float) (1.2 / Math.sqrt(number)), Color.RED));
      }
      print("spheres", number, rate(scene, SIDE, RenderSettings.STANDARD), "");
    }
  }

  private static void lights() {
    for (final int number : new int[] {1, 10, 100}) {
      print("lights", number, litRate(number, 0), "");
    }
  }

  private static void depths() {
    for (final int depth : new int[] {0, 1, 2, 4, 8, 16}) {
      print("depth", depth, litRate(2, depth), "");
    }
  }

  private static void pixels() {
    final Group3D scene = new Group3D();
    scene.addObject(BenchmarkScene.mesh(100_000));
    for (final int side : new int[] {100, 500, 2000, 8000}) {
      print("pixels", side, rate(scene, side, RenderSettings.STANDARD), "");
    }
  }

  private static Point3D point(final SplittableRandom random, final double extent) {
    return new Point3D((float) random.nextDouble(-extent, extent), (float) random.nextDouble(-extent, extent),
        (float) random.nextDouble(-extent, extent));
  }

  /** A floor and 100 spheres, a third of them each matte, mirrors and glass. */
  private static Group3D lit() {
    final SplittableRandom random = new SplittableRandom(2);
    final ReflectanceRGB grey = new ReflectanceRGB(0.6f, 0.6f, 0.6f), white = new ReflectanceRGB(0.9f, 0.9f, 0.9f);
    final Material[] materials = {new Lambertian(grey), new IdealConductor(white), new IdealDielectric(white, 1.5f, 1)};
    final Group3D scene = new Group3D();
    scene.addObject(new Plane(new Point3D(0, -1.7f, 0), new Vector3D(0, 1, 0), materials[0]));
    for (int i = 0; i < 100; i++) {
      scene.addObject(new Sphere(point(random, 1.5), 0.25f, materials[i % 3]));
    }
    return scene;
  }

  /** The rate of that scene in the light of points above it, of 1000 W in all. */
  private static double litRate(final int lights, final int depth) {
    final Group3D scene = lit();
    final SplittableRandom random = new SplittableRandom(3);
    final LightGroup group = new LightGroup();
    for (int i = 0; i < lights; i++) {
      final Point3D at = new Point3D((float) random.nextDouble(-5, 5), (float) random.nextDouble(4, 6),
          (float) random.nextDouble(-5, 5));
      group.addLight(new Omnidirectional(at, new SpectrumRGB(0.25f, 0.5f, 0.25f), 1000f / lights));
    }
    return rate(scene, SIDE, RenderSettings.STANDARD.withShading(new Illumination(scene, group, depth, Color.BLACK)));
  }

  private static double rate(final Group3D scene, final int side, final RenderSettings settings) {
    final Image image = new Image(side, side, Color.BLACK);
    final RenderSettings alone = settings.withThreads(1);
    frames(scene, image, alone, WARM_UP);
    return 1e-6 * side * side / frames(scene, image, alone, MEASURED);
  }

  /** Renders frames for some CPU seconds, at least one; returns what each took. */
  private static double frames(final Group3D scene, final Image image, final RenderSettings settings, final double seconds) {
    final double start = cpuTime();
    int frames = 0;
    do {
      image.synthesis(scene, BenchmarkScene.camera(), settings);
      frames++;
    } while (cpuTime() - start < seconds);
    return (cpuTime() - start) / frames;
  }

  private static double cpuTime() {
    return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() * 1e-9;
  }

  private static void print(final String what, final int number, final double rate, final String more) {
    System.out.printf(Locale.ROOT, "%s %d: %.3g Mpixel/s %s%n", what, number, rate, more);
  }
}
