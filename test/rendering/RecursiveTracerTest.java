package rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

import javax.vecmath.Vector3f;

import org.junit.jupiter.api.Test;

import lights.Directional;
import lights.LightGroup;
import lights.Omnidirectional;
import lights.Spot;
import materials.AshikhminShirley;
import materials.Blinn;
import materials.IdealConductor;
import materials.IdealDielectric;
import materials.Material;
import materials.OrenNayar;
import materials.TransmissiveCookTorrance;
import models.AffineTransformation;
import models.Group3D;
import models.Object3D;
import models.Plane;
import models.RandomNumbers;
import models.Sphere;
import models.TriangularMesh;
import primitives.Point3D;
import primitives.Vector3D;
import radiometry.RadianceRGB;
import radiometry.ReflectanceRGB;
import radiometry.SpectrumRGB;
import tracer.Hit;
import tracer.Ray;

/** Illumination agrees with {@link RecursiveTracer} in scenes of all materials and lights, with bent normals. */
class RecursiveTracerTest {

  private static final Color SKY = new Color(120, 160, 200);
  private static final ReflectanceRGB HALF = new ReflectanceRGB(0.5f, 0.4f, 0.3f);
  private static final ReflectanceRGB ALL = new ReflectanceRGB(1, 0.9f, 0.8f);

  private static final List<Material> MATERIALS = List.of(new IdealConductor(ALL), new IdealDielectric(ALL, 1.5f, 1),
      new TransmissiveCookTorrance(ALL, 1.4f, 1, new Blinn(25)), new AshikhminShirley(HALF, HALF, new Blinn(25)),
      new AshikhminShirley(HALF, HALF, null), new OrenNayar(HALF, 30));

  /** A hilly sheet over the square of side 2, whose normals are bent by up to some 60° from those of its facets. */
  private static TriangularMesh sheet(final RandomNumbers numbers, final Material material) {
    final Map<Integer, Point3D> vertices = new HashMap<>();
    final Map<Integer, Vector3D> normals = new HashMap<>();
    final List<String> facets = new ArrayList<>();
    for (int i = 0; i < 16; i++) {
      vertices.put(i, new Point3D(2 * (i % 4) / 3f - 1, (float) numbers.between(-0.2, 0.2), 1 - 2 * (i / 4) / 3f));
      final Vector3D n = numbers.direction();
      n.y += 1.2f;
      normals.put(i, n);
      if (i % 4 < 3 && i < 12) {
        facets.add(corner(i) + corner(i + 1) + corner(i + 5));
        facets.add(corner(i) + corner(i + 5) + corner(i + 4));
      }
    }
    return new TriangularMesh(vertices, normals, facets, material);
  }

  private static String corner(final int vertex) {
    return vertex + "//" + vertex + " ";
  }

  /** A coloured floor, and above it balls and sheets of all materials. */
  private static List<Object3D> objects(final RandomNumbers numbers) {
    final List<Object3D> objects = new ArrayList<>();
    objects.add(new Plane(new Point3D(0, -1, 0), new Vector3D(0, 1, 0), new Color(200, 180, 150)));
    for (final Material material : MATERIALS) {
      objects.add(new Sphere(numbers.pointAbout(new Point3D(0, 1, 0), 2), (float) numbers.between(0.3, 0.8), material));
      final Vector3f shift = new Vector3f(numbers.pointAbout(new Point3D(0, 1, 0), 2));
      objects.add(new AffineTransformation(new Vector3f(1, 1, -0.8f), numbers.direction(), (float) numbers.between(0, 360),
          shift, sheet(numbers, material)));
    }
    return objects;
  }

  private static LightGroup lights() {
    final LightGroup lights = new LightGroup();
    lights.addLight(new Omnidirectional(new Point3D(3, 6, 4), new SpectrumRGB(0.4f, 0.3f, 0.3f), 120));
    lights.addLight(new Spot(new Point3D(-4, 5, 3), new Point3D(0, 0, 0), 40, new SpectrumRGB(0.6f, 0.3f, 0.1f), 90));
    lights.addLight(new Directional(new Point3D(0, 9, -3), new Point3D(0, 0, 0), 4, new SpectrumRGB(0, 0.25f, 0.75f), 40));
    return lights;
  }

  /** What an observer is told, added up. */
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
      final List<Object3D> objects = objects(numbers);
      final Group3D scene = new Group3D();
      objects.forEach(scene::addObject);
      final int depth = i % 7;
      final Illumination light = new Illumination(scene, lights(), depth, SKY).withExposure(-1);
      final RecursiveTracer oracle = new RecursiveTracer(objects, lights().getLights(), depth, SKY, -1);
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
}
