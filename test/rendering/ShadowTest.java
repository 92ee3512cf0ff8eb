package rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.List;

import javax.vecmath.Vector3f;

import lights.Directional;
import lights.Light;
import lights.LightGroup;
import lights.Omnidirectional;
import materials.IdealConductor;
import materials.IdealDielectric;
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
import radiometry.ReflectanceRGB;
import radiometry.SpectrumRGB;
import tracer.Hit;
import tracer.Ray;
import upnatray.Image;
import view.Camera;
import view.Perspective;

/** Shadows: their edges, where things touch, what sees a light, and lights at odd places. */
class ShadowTest {

  private static final TriangularMesh OCTAHEDRON = TriangularMesh.of(
      new float[] {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1},
      new int[] {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5}, Color.RED);
  private static final SpectrumRGB WHITE = new SpectrumRGB(1f / 3, 1f / 3, 1f / 3);

  private static Group3D group(final Object3D... objects) {
    final Group3D group = new Group3D();
    for (final Object3D object : objects) {
      group.addObject(object);
    }
    return group;
  }

  private static Plane floor() {
    return new Plane(new Point3D(), new Vector3D(0, 1, 0), Color.WHITE);
  }

  private static Light lamp(final Point3D S) {
    return new Omnidirectional(S, WHITE, 100);
  }

  private static double red(final Group3D scene, final Light light, final Ray ray, final Hit hit) {
    return new Illumination(scene, new LightGroup(light), 3, Color.BLACK).radiance(ray, hit, LightObserver.NONE).getR();
  }

  private static double red(final Group3D scene, final Light light, final Point3D from, final Point3D to) {
    final Ray ray = new Ray(from, to);
    return red(scene, light, ray, scene.intersectionWith(ray));
  }

  /** Distance of a segment from a point. */
  private static double distance(final Hit hit, final Point3D S, final Point3D C) {
    final double x = hit.pointX(), y = hit.pointY(), z = hit.pointZ(), dx = S.x - x, dy = S.y - y, dz = S.z - z;
    final double along = ((C.x - x) * dx + (C.y - y) * dy + (C.z - z) * dz) / (dx * dx + dy * dy + dz * dz);
    final double k = Math.max(0, Math.min(1, along));
    final double px = x + k * dx - C.x, py = y + k * dy - C.y, pz = z + k * dz - C.z;
    return Math.sqrt(px * px + py * py + pz * pz);
  }

  @Test
  void edgesUnderABallAndOfABeamAreWhereGeometryPutsThem() {
    final RandomNumbers numbers = new RandomNumbers("shadow edges");
    final Point3D C = new Point3D(0.3f, 2, -0.2f), S = new Point3D(2, 6, 1);
    final Group3D scene = group(floor(), new Sphere(C, 1, Color.RED));
    final Directional beam = new Directional(new Point3D(0, 9, 0), new Point3D(), 3, WHITE, 100);
    int dark = 0;
    for (int i = 0; i < RandomNumbers.times(20_000); i++) {
      final Ray ray = new Ray(new Point3D(0, 0.5f, 8), new Point3D((float) numbers.between(-4, 4), 0,
          (float) numbers.between(-4, 4)));
      final Hit hit = scene.intersectionWith(ray);
      final double off = distance(hit, S, C) - 1, beside = Math.hypot(hit.pointX(), hit.pointZ());
      if (hit.getObject() instanceof Plane && Math.abs(off) > 1e-6) {
        assertEquals(off > 0, red(scene, lamp(S), ray, hit) > 0, () -> "lamp at " + hit + "; " + numbers);
        dark += off > 0 ? 0 : 1;
        final double under = Math.hypot(hit.pointX() - C.x, hit.pointZ() - C.z);
        if (Math.abs(beside - 3) > 1e-6 && Math.abs(under - 1) > 1e-6) {
          assertEquals(beside < 3 && under > 1, red(scene, beam, ray, hit) > 0, () -> "beam at " + hit + "; " + numbers);
        }
      }
    }
    assertTrue(dark > 500, "too few dark points");
  }

  /** A ball and a box that stand on the floor: nothing is lit close to where they touch it. */
  @Test
  void noLightCreepsUnderWhatTouchesTheFloor() {
    final RandomNumbers numbers = new RandomNumbers("contact");
    for (int i = 0; i < RandomNumbers.times(4_000); i++) {
      final float r = numbers.magnitude(-10, 10);
      final Point3D C = new Point3D((float) numbers.between(-r, r), r, (float) numbers.between(-r, r));
      final Group3D scene = group(floor(), new Sphere(C, r, Color.RED));
      final double angle = numbers.between(0, 2 * Math.PI), near = 0.01 * r * numbers.between(0, 1);
      final float x = (float) (C.x + near * Math.cos(angle)), z = (float) (C.z + near * Math.sin(angle));
      final double away = r * Math.pow(10, numbers.between(-0.5, 4));
      final Hit hit = floor().intersectionWith(new Ray(new Point3D(x, (float) away, z), new Vector3D(0, -1, 0)));
      final Ray ray = new Ray(new Point3D(x, (float) away, z), new Vector3D(0, -1, 0));
      final Vector3D towards = numbers.direction();
      final Point3D S = new Point3D(C.x + 9 * r * towards.x, C.y + r * (1 + 9 * Math.abs(towards.y)),
          C.z + 9 * r * towards.z);
      assertEquals(0, red(scene, lamp(S), ray, hit), () -> "r = " + r + " at " + hit + " of " + S + "; " + numbers);
    }
  }

  /** Single shapes that are convex, or seen from where they do not occlude themselves, in all sizes and far away. */
  @Test
  void whatFacesALightAndSeesItIsLit() {
    final RandomNumbers numbers = new RandomNumbers("facing");
    int lit = 0;
    for (int i = 0; i < RandomNumbers.times(20_000); i++) {
      final float s = numbers.magnitude(-10, 10);
      final Point3D C = numbers.pointAbout(new Point3D(), s * Math.pow(10, numbers.between(-1, 4)));
      final Vector3D u = numbers.direction(), aux = numbers.direction();
      aux.cross(aux, u);
      final Object3D shape = shape(i % 7, C, u, aux, s);
      final Point3D eye = numbers.pointAbout(C, s * Math.pow(10, numbers.between(0.5, 4)));
      final Ray ray = new Ray(eye, numbers.pointAbout(C, 0.3 * s));
      final Group3D scene = group(shape);
      final Hit hit = scene.intersectionWith(ray);
      final Point3D S = numbers.pointAbout(C, s * Math.pow(10, numbers.between(0.5, 2)));
      final double facing = hit.hits() ? facing(hit, S) : 0, seen = hit.hits() ? facing(hit, eye) : 0;
      final boolean sides = shape instanceof Plane ? facing * seen > 0 : facing > 0 && seen > 0;
      if (sides && Math.abs(facing) > 1e-4 * s) {
        lit++;
        assertTrue(red(scene, lamp(S), ray, hit) > 0, () -> shape + " at " + hit + " of " + S + " is dark; " + numbers);
      }
    }
    assertTrue(lit > 1000, "too few lit points");
  }

  private static Object3D shape(final int kind, final Point3D C, final Vector3D u, final Vector3D aux, final float s) {
    return switch (kind) {
      case 0 -> new Sphere(C, s, Color.RED);
      case 1 -> new Box(C, u, aux, s, s, s, Color.RED);
      case 2 -> new Cylinder(C, u, 0.3f * s, s, Color.RED);
      case 3 -> new Capsule(C, u, 0.3f * s, s, Color.RED);
      case 4 -> new Ellipsoid(C, u, aux, s, 0.4f * s, 0.2f * s, Color.RED);
      case 5 -> new Plane(C, u, Color.RED);
      default -> new AffineTransformation(new Vector3f(s, 0.2f * s, -s), u, 30, new Vector3f(C), OCTAHEDRON);
    };
  }

  private static double facing(final Hit hit, final Point3D S) {
    return (S.x - hit.pointX()) * hit.geometricX() + (S.y - hit.pointY()) * hit.geometricY()
        + (S.z - hit.pointZ()) * hit.geometricZ();
  }

  @Test
  void torusDoesNotShadeItsOuterSide() {
    final RandomNumbers numbers = new RandomNumbers("torus");
    for (int i = 0; i < RandomNumbers.times(5_000); i++) {
      final float s = numbers.magnitude(-10, 10);
      final Point3D C = numbers.pointAbout(new Point3D(), s * Math.pow(10, numbers.between(-1, 3)));
      final Torus torus = new Torus(C, new Vector3D(0, 1, 0), s, 0.3f * s, Color.RED);
      final double angle = numbers.between(0, 2 * Math.PI), x = Math.cos(angle), z = Math.sin(angle);
      final Point3D far = new Point3D((float) (C.x + 5 * s * x), C.y, (float) (C.z + 5 * s * z));
      final Group3D scene = group(torus);
      final double up = numbers.between(-1, 1);
      final Point3D S = new Point3D((float) (C.x + 20 * s * x), (float) (C.y + 9 * s * up), (float) (C.z + 20 * s * z));
      assertTrue(red(scene, lamp(S), far, C) > 0, () -> torus + " from " + far + " by " + S + "; " + numbers);
    }
  }

  @Test
  void lightWithinAnObjectLightsItsInsideOnly() {
    final Sphere ball = new Sphere(new Point3D(0, 3, 0), 1, Color.WHITE);
    final Group3D scene = group(floor(), ball);
    final Light within = lamp(new Point3D(0.2f, 3.1f, 0));
    assertEquals(0, red(scene, within, new Point3D(3, 1, 3), new Point3D(1, 0, 1)));
    assertEquals(0, red(scene, within, new Point3D(3, 3, 3), new Point3D(0, 3, 0)));
    assertTrue(red(scene, within, new Point3D(0, 3, 0), new Point3D(1, 3, 0)) > 0);
  }

  @Test
  void lightOnASurfaceIsNotBlockedByIt() {
    final Plane ceiling = new Plane(new Point3D(0, 5, 0), new Vector3D(0, -1, 0), Color.WHITE);
    final RandomNumbers numbers = new RandomNumbers("ceiling");
    for (int i = 0; i < 1_000; i++) {
      final Point3D S = new Point3D((float) numbers.between(-9, 9), 5, (float) numbers.between(-9, 9));
      final Point3D to = new Point3D((float) numbers.between(-9, 9), 0, (float) numbers.between(-9, 9));
      final double lit = red(group(floor(), ceiling), lamp(S), new Point3D(0, 3, 0), to);
      assertTrue(lit > 0, () -> S + " on " + to + "; " + numbers);
    }
  }

  /** What lies behind the disc of a beam does not block it, nor what lies behind a lamp. */
  @Test
  void onlyWhatLiesBetweenBlocks() {
    final Sphere above = new Sphere(new Point3D(0, 9, 0), 1, Color.WHITE);
    final Directional beam = new Directional(new Point3D(0, 5, 0), new Point3D(), 2, WHITE, 10);
    final Point3D from = new Point3D(3, 2, 0), to = new Point3D(0.5f, 0, 0);
    assertTrue(red(group(floor(), above), beam, from, to) > 0);
    assertTrue(red(group(floor(), above), lamp(new Point3D(0, 5, 0)), from, to) > 0);
    final Directional high = new Directional(new Point3D(0, 15, 0), new Point3D(), 2, WHITE, 10);
    assertEquals(0, red(group(floor(), above), high, from, to));
  }

  @Test
  void transparentObjectsBlockTooAndMirrors() {
    final ReflectanceRGB all = new ReflectanceRGB(1, 1, 1);
    final Point3D C = new Point3D(0, 2, 0);
    for (final Sphere ball : List.of(new Sphere(C, 1, new IdealDielectric(all, 1.5f, 1)),
        new Sphere(C, 1, new IdealConductor(all)), new Sphere(C, 1, new Color(0, 0, 0, 0)))) {
      assertEquals(0, red(group(floor(), ball), lamp(new Point3D(0, 5, 0)), new Point3D(4, 1, 0), new Point3D()));
    }
  }

  @Test
  void hundredThousandLightsAddUp() {
    final LightGroup many = new LightGroup();
    for (int i = 0; i < 100_000; i++) {
      many.addLight(new Omnidirectional(new Point3D(0, 2, 0), WHITE, 1e-3f));
    }
    final Group3D scene = group(floor());
    final Ray ray = new Ray(new Point3D(1, 1, 1), new Point3D());
    final double sum = new Illumination(scene, many, 0, Color.BLACK).radiance(ray, scene.intersectionWith(ray),
        LightObserver.NONE).getR();
    assertEquals(red(scene, lamp(new Point3D(0, 2, 0)), new Point3D(1, 1, 1), new Point3D()), sum, 1e-6 * sum);
  }

  /**
   * Also in a picture, where the shadow rays of a tile are traced together: memory does not grow with the number of
   * lights.
   */
  @Test
  void pictureOfManyLightsIsThatOfOneOfTheirPower() {
    final LightGroup many = new LightGroup(), one = new LightGroup(lamp(new Point3D(0, 2, 0)));
    for (int i = 0; i < 20_000; i++) {
      many.addLight(new Omnidirectional(new Point3D(0, 2, 0), WHITE, 5e-3f));
    }
    final Group3D scene = group(floor(), new Sphere(new Point3D(0.5f, 0.5f, 0), 0.4f, Color.RED));
    final Camera camera = new Camera(new Point3D(1, 3, 5), new Point3D(), new Vector3D(0, 1, 0));
    camera.setProjection(new Perspective(40, 1));
    final Image[] images = {new Image(6, 6, Color.BLACK), new Image(6, 6, Color.BLACK)};
    images[0].synthesis(scene, camera, one);
    images[1].synthesis(scene, camera, many);
    for (int i = 0; i < 36; i++) {
      final int expected = images[0].getRGB(i % 6, i / 6) & 0xff, found = images[1].getRGB(i % 6, i / 6) & 0xff;
      assertEquals(expected, found, 1, "pixel " + i);
    }
  }

  @Test
  void zerosOfASpectrumAreBlackChannels() {
    final Light light = new Omnidirectional(new Point3D(0, 2, 0), new SpectrumRGB(0, 1, 0), 10);
    final Group3D scene = group(floor());
    final Ray ray = new Ray(new Point3D(1, 1, 1), new Point3D());
    final Illumination illumination = new Illumination(scene, new LightGroup(light), 0, Color.BLACK);
    final int argb = illumination.argb(ray, scene.intersectionWith(ray));
    assertEquals(0, argb & 0xff00ff);
    assertTrue((argb & 0xff00) > 0);
  }
}
