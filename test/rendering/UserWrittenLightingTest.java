package rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.List;

import javax.vecmath.Vector3f;

import lights.Light;
import lights.LightGroup;
import lights.Omnidirectional;
import materials.AshikhminShirley;
import materials.BRDF;
import materials.Blinn;
import materials.IdealConductor;
import materials.IdealDielectric;
import materials.Lambertian;
import materials.Material;
import materials.TransmissiveCookTorrance;
import models.AffineTransformation;
import models.Group3D;
import models.Object3D;
import models.Plane;
import models.RandomNumbers;
import models.Sphere;
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

/** Objects, lights, and materials that a student writes: lit as those of the library are, and named if they fail. */
class UserWrittenLightingTest {

  private static final String PACKAGE = "rendering.UserWrittenLightingTest$";
  private static final SpectrumRGB WHITE = new SpectrumRGB(1f / 3, 1f / 3, 1f / 3);
  private static final ReflectanceRGB ALL = new ReflectanceRGB(1, 1, 1);
  private static final Light LAMP = new Omnidirectional(new Point3D(3, 5, 4), WHITE, 200);

  /** A sphere in floats, with nothing but a colour. */
  private static final class FloatBall extends Object3D {

    private final Point3D C;
    private final float r;

    FloatBall(final Point3D C, final float r, final Color color) {
      super(color);
      this.C = C;
      this.r = r;
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      final Point3D R = ray.getStartingPoint();
      final Vector3D l = new Vector3D(R.x - C.x, R.y - C.y, R.z - C.z), v = ray.getDirection();
      final float b = l.dot(v), c = l.dot(l) - r * r, d = b * b - c, root = (float) Math.sqrt(d);
      final float t = -b - root > 0 ? -b - root : -b + root;
      if (!(d >= 0 && t > 0)) {
        return Hit.NOHIT;
      }
      final Point3D P = ray.pointAtParameter(t);
      return new Hit(t, P, new Vector3D(P.x - C.x, P.y - C.y, P.z - C.z), this);
    }
  }

  private static Group3D group(final Object3D... objects) {
    final Group3D group = new Group3D();
    for (final Object3D object : objects) {
      group.addObject(object);
    }
    return group;
  }

  private static RadianceRGB radiance(final Group3D scene, final Ray ray, final Light... lights) {
    return new Illumination(scene, new LightGroup(lights), 4, Color.BLACK).radiance(ray, scene.intersectionWith(ray),
        LightObserver.NONE);
  }

  /** The library's ball and the student's, alone, in groups, transformations, and in a mirror. */
  @Test
  void studentsBallIsLitAsTheLibrarysIs() {
    final Point3D C = new Point3D(0.3f, 1, 0.2f);
    final RandomNumbers numbers = new RandomNumbers("float ball");
    final Group3D[] scenes = new Group3D[2];
    for (int i = 0; i < 2; i++) {
      final Object3D ball = i == 0 ? new Sphere(C, 1, Color.ORANGE) : new FloatBall(C, 1, Color.ORANGE);
      scenes[i] = group(new Plane(new Point3D(), new Vector3D(0, 1, 0), Color.WHITE), ball,
          new Plane(new Point3D(0, 0, -3), new Vector3D(0, 0, 1), new IdealConductor(ALL)),
          new AffineTransformation(new Vector3f(0.5f, -1, 0.8f), new Vector3f(1, 1, 0), 40, new Vector3f(-2, 1, 0),
              group(ball)));
    }
    int different = 0;
    for (int i = 0; i < RandomNumbers.times(5_000); i++) {
      final Ray ray = new Ray(new Point3D(1, 2, 6), numbers.pointAbout(new Point3D(-1, 1, 0), 2));
      final double expected = radiance(scenes[0], ray, LAMP).getR(), found = radiance(scenes[1], ray, LAMP).getR();
      different += Math.abs(expected - found) > 1e-3 * Math.max(expected, 0.1) ? 1 : 0;
    }
    final int count = different;
    assertTrue(different <= 10 * RandomNumbers.times(1), () -> count + " differ; " + numbers);
  }

  /** A facet whose shading normal points anywhere in front of it. */
  private static final class Sheet extends Object3D {

    private final RandomNumbers numbers = new RandomNumbers("bent normals");

    Sheet(final Material material) {
      super(material);
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      final double t = -ray.startY() / ray.directionY();
      final Vector3D n = numbers.direction();
      return Hit.of(t, ray.startX() + t * ray.directionX(), 0, ray.startZ() + t * ray.directionZ(), 0, 1, 0, 1e-9, this)
          .withShading(n.x, n.y, n.z, Double.NaN, Double.NaN);
    }
  }

  @Test
  void nothingLeaksThroughASheetWhateverItsNormals() {
    final RandomNumbers numbers = new RandomNumbers("leak");
    for (final Material material : List.of(new Lambertian(ALL), new AshikhminShirley(new ReflectanceRGB(0.5f, 0.5f, 0.5f),
        new ReflectanceRGB(0.5f, 0.5f, 0.5f), new Blinn(60)))) {
      final Group3D scene = group(new Sheet(material));
      for (int i = 0; i < 5_000; i++) {
        final boolean above = numbers.index(2) == 0;
        final float y = (float) numbers.between(0.01, 3) * (above ? 1 : -1);
        final Ray ray = new Ray(new Point3D(0, y, 3), numbers.pointAbout(new Point3D(), 3));
        final Light behind = new Omnidirectional(new Point3D(1, -y, 0), WHITE, 100);
        final Hit hit = scene.intersectionWith(ray);
        if (hit.hits() && ray.directionY() * y < 0) {
          assertEquals(0, radiance(scene, ray, behind).getR(), () -> material + " " + ray + "; " + numbers);
        }
      }
    }
  }

  /** Reflected rays stay in front of the facet, refracted ones go behind it: a non-uniform sky tells them apart. */
  @Test
  void bentRaysLeaveOnTheirOwnSide() {
    final RandomNumbers numbers = new RandomNumbers("bent rays");
    final Group3D mirror = group(new Sheet(new IdealConductor(ALL)));
    final Group3D glass = group(new Sheet(new IdealDielectric(ALL, 1.5f, 1)));
    final Group3D rough = group(new Sheet(new TransmissiveCookTorrance(ALL, 1.5f, 1, new Blinn(30))));
    int refracted = 0;
    for (int i = 0; i < 5_000; i++) {
      final Ray ray = new Ray(new Point3D(0, 2, 3), numbers.pointAbout(new Point3D(), 1.5));
      for (final Group3D scene : List.of(mirror, glass, rough)) {
        final int[] below = new int[2];
        final Hit hit = scene.intersectionWith(ray);
        if (hit.hits()) {
          new Illumination(scene, new LightGroup(), 1, Color.WHITE).radiance(ray, hit, new LightObserver() {
            @Override
            public void background(final Ray its, final int depth, final RadianceRGB radiance) {
              below[its.directionY() < 0 ? 1 : 0]++;
              assertEquals(Math.signum(its.directionY()), Math.signum(its.startY()), () -> its + "; " + numbers);
            }
          });
          assertTrue(scene == mirror ? below[1] == 0 : below[1] <= 1, () -> hit + "; " + numbers);
          refracted += below[1];
        }
      }
    }
    assertTrue(refracted > 8_000, "too few refracted rays: " + refracted);
  }

  /** A floor whose hits are off by a hundred times the rounding of floats. */
  private static final class RoughlyFloor extends Object3D {

    RoughlyFloor() {
      super(Color.WHITE);
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      final float height = 1e-5f * (float) Math.sin(1e7 * ray.startX());
      final float t = (float) ((height - ray.startY()) / ray.directionY());
      return t > 0 && t < 1e9f ? new Hit(t, ray.pointAtParameter(t), new Vector3D(0, 1, 0), this) : Hit.NOHIT;
    }
  }

  @Test
  void surfaceThatIsNotExactDoesNotShadeItself() {
    final RandomNumbers numbers = new RandomNumbers("rough floor");
    final Group3D scene = group(new AffineTransformation(new Vector3f(1, 1, 1), new Vector3f(), group(new RoughlyFloor())),
        new Sphere(new Point3D(0, 9, 0), 0.1f, Color.RED));
    for (int i = 0; i < 2_000; i++) {
      final Point3D to = new Point3D((float) numbers.between(1, 5), 0, (float) numbers.between(1, 5));
      final Ray ray = new Ray(new Point3D(0, 2, 0), to);
      assertTrue(radiance(scene, ray, LAMP).getR() > 0, () -> ray + "; " + numbers);
    }
  }

  private static IllegalStateException failure(final Light light, final Object3D... objects) {
    final Camera camera = new Camera(new Point3D(0, 3, 5), new Point3D(), new Vector3D(0, 1, 0));
    camera.setProjection(new Perspective(60, 1));
    final IllegalStateException[] failures = new IllegalStateException[2];
    for (int i = 0; i < 2; i++) {
      final RenderSettings settings = RenderSettings.STANDARD.withShading(
          new Illumination(group(objects), new LightGroup(light), 3, Color.BLACK)).withThreads(1);
      final RenderSettings chosen = i == 0 ? settings : settings.withPixelLoop();
      failures[i] = assertThrows(IllegalStateException.class,
          () -> new Image(30, 20, Color.BLACK).synthesis(group(objects), camera, chosen));
    }
    assertTrue(failures[1].getMessage().contains(" failed at pixel ("), failures[1].getMessage());
    return failures[0];
  }

  /** A light that fails on demand. */
  private static final class Candle extends Light {

    private final int fault;

    Candle(final int fault) {
      super(new Point3D(0, 4, 0), WHITE, 100);
      this.fault = fault;
    }

    @Override
    public RadianceRGB getIrradianceAt(final Point3D P) {
      return fault == 0 ? null : fault == 1 ? new RadianceRGB(-1, 0, 0) : fault == 2 ? getIrradianceAt(P) : getPower();
    }

    @Override
    public Point3D getPosition(final Point3D P) {
      if (fault == 3) {
        throw new ArithmeticException("by a student");
      }
      return fault == 4 ? null : getPosition();
    }
  }

  private static Plane floor(final Material material) {
    return new Plane(new Point3D(), new Vector3D(0, 1, 0), material);
  }

  @Test
  void lightThatFailsIsNamedWithMethodPixelAndRay() {
    final String[] methods = {"getIrradianceAt", "getIrradianceAt", "getIrradianceAt", "getPosition", "getPosition"};
    for (int fault = 0; fault < methods.length; fault++) {
      final IllegalStateException reported = failure(new Candle(fault), floor(new Lambertian(ALL)));
      final String start = PACKAGE + "Candle." + methods[fault] + " failed at pixel (0, 0) with Ray(R=";
      assertTrue(reported.getMessage().startsWith(start), reported.getMessage());
      assertSame(fault == 2 ? StackOverflowError.class : reported.getCause().getClass(), reported.getCause().getClass());
    }
  }

  /** A material that fails on demand. */
  private static final class Wrong extends BRDF {

    private final int fault;

    Wrong(final int fault) {
      this.fault = fault;
    }

    @Override
    public RadianceRGB reflect(final RadianceRGB irradiance, final Vector3D wi, final Vector3D wo, final Vector3D n) {
      return fault == 0 ? null : fault == 1 ? new RadianceRGB(0, Double.NaN, 0) : irradiance;
    }

    @Override
    public ReflectanceRGB mirror(final double cosine) {
      if (fault == 2) {
        throw new ArithmeticException("by a student");
      }
      return null;
    }
  }

  @Test
  void materialThatFailsIsNamedWithMethodPixelAndRay() {
    final String[] methods = {"reflect", "reflect", "mirror"};
    for (int fault = 0; fault < methods.length; fault++) {
      final String message = failure(LAMP, floor(new Wrong(fault))).getMessage();
      final String start = PACKAGE + "Wrong." + methods[fault] + " failed at pixel (0, 0) with Ray(R=";
      assertTrue(message.startsWith(start), message);
    }
  }

  /** Fails for rays that go up: those of shadows and mirrors, not those of the camera. */
  private static final class Upwards extends Object3D {

    Upwards() {
      super(Color.RED);
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      if (ray.directionY() > 0) {
        throw new ArithmeticException("by a student");
      }
      return Hit.NOHIT;
    }
  }

  @Test
  void objectThatFailsForShadowsOrInMirrorsIsNamed() {
    for (final Material material : List.of(new Lambertian(ALL), new IdealConductor(ALL))) {
      final String message = failure(LAMP, floor(material), new Upwards()).getMessage();
      final String start = PACKAGE + "Upwards.intersectionWith failed at pixel (0, 0) with Ray(R=";
      assertTrue(message.startsWith(start), message);
    }
  }
}
