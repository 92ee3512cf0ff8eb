package rendering;

import java.awt.Color;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

import javax.vecmath.Vector3f;

import lights.Directional;
import lights.Light;
import lights.LightGroup;
import lights.Omnidirectional;
import lights.Spot;
import materials.AshikhminShirley;
import materials.BRDF;
import materials.Blinn;
import materials.IdealConductor;
import materials.IdealDielectric;
import materials.Material;
import materials.OrenNayar;
import materials.TransmissiveCookTorrance;
import models.AffineTransformation;
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

/** Random scenes of all materials and lights, with bent normals, and with a light and a BRDF such as a student writes. */
final class LitScenes {

  static final Color SKY = new Color(120, 160, 200);
  private static final ReflectanceRGB HALF = new ReflectanceRGB(0.5f, 0.4f, 0.3f);
  private static final ReflectanceRGB ALL = new ReflectanceRGB(1, 0.9f, 0.8f);

  /** Chalk as a student writes it: matte, and a little brighter where it is seen from the side of the light. */
  private static final class Chalk extends BRDF {

    @Override
    public RadianceRGB reflect(final RadianceRGB irradiance, final Vector3D wi, final Vector3D wo, final Vector3D n) {
      return irradiance.times(0.2 + 0.05 * Math.max(0, wi.dot(wo)));
    }
  }

  /** A candle as a student writes it: of a point, and dark below. */
  private static final class Candle extends Light {

    Candle(final Point3D position) {
      super(position, new SpectrumRGB(0.5f, 0.3f, 0.2f), 50);
    }

    @Override
    public RadianceRGB getIrradianceAt(final Point3D P) {
      final double d2 = P.distanceSquared(getPosition());
      return P.y < -0.5f ? RadianceRGB.NORADIANCE : getPower().times(1 / (4 * Math.PI * d2));
    }
  }

  /** A pebble as a student writes it, whose hits have only floats behind them. */
  private static final class Pebble extends Object3D {

    private final Sphere sphere;

    Pebble(final Point3D C, final float r) {
      super(new Color(90, 80, 70));
      sphere = new Sphere(C, r, Color.BLACK);
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      final Hit hit = sphere.intersectionWith(ray);
      return hit.hits() ? new Hit(hit.getT(), ray.pointAtParameter(hit.getT()), hit.getNormal(), this) : Hit.NOHIT;
    }
  }

  private static final List<Material> MATERIALS = List.of(new IdealConductor(ALL), new IdealDielectric(ALL, 1.5f, 1),
      new TransmissiveCookTorrance(ALL, 1.4f, 1, new Blinn(25)), new AshikhminShirley(HALF, HALF, new Blinn(25)),
      new AshikhminShirley(HALF, HALF, null), new OrenNayar(HALF, 30), new Chalk());

  private LitScenes() {
  }

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
  static List<Object3D> objects(final RandomNumbers numbers) {
    final List<Object3D> objects = new ArrayList<>();
    objects.add(new Plane(new Point3D(0, -1, 0), new Vector3D(0, 1, 0), new Color(200, 180, 150)));
    for (int i = 0; i < 3; i++) {
      final Object3D pebble = new Pebble(numbers.pointAbout(new Point3D(0, 1, 0), 2), (float) numbers.between(0.2, 0.6));
      objects.add(i == 0 ? pebble : new AffineTransformation(numbers.direction(), 40 * i, new Vector3f(), pebble));
    }
    for (final Material material : MATERIALS) {
      objects.add(new Sphere(numbers.pointAbout(new Point3D(0, 1, 0), 2), (float) numbers.between(0.3, 0.8), material));
      final Vector3f shift = new Vector3f(numbers.pointAbout(new Point3D(0, 1, 0), 2));
      objects.add(new AffineTransformation(new Vector3f(1, 1, -0.8f), numbers.direction(), (float) numbers.between(0, 360),
          shift, sheet(numbers, material)));
    }
    return objects;
  }

  static LightGroup lights() {
    final LightGroup lights = new LightGroup();
    lights.addLight(new Omnidirectional(new Point3D(3, 6, 4), new SpectrumRGB(0.4f, 0.3f, 0.3f), 120));
    lights.addLight(new Spot(new Point3D(-4, 5, 3), new Point3D(0, 0, 0), 40, new SpectrumRGB(0.6f, 0.3f, 0.1f), 90));
    lights.addLight(new Directional(new Point3D(0, 9, -3), new Point3D(0, 0, 0), 4, new SpectrumRGB(0, 0.25f, 0.75f), 40));
    lights.addLight(new Candle(new Point3D(-2, 3, -4)));
    return lights;
  }
}
