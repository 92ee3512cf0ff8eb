package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

import javax.vecmath.Vector3f;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/** Rays that leave a surface do not hit it where they start, and so do not see it from the wrong side. */
class LeavingRayTest {

  private static final int RAYS = 4_000;

  /** A shape of a given size at a given place. */
  @FunctionalInterface
  private interface Maker {

    Object3D make(Point3D C, Vector3D u, Vector3D aux, float size);
  }

  private static final Map<String, Maker> MAKERS = new TreeMap<>(Map.of(
      "sphere", (C, u, aux, s) -> new Sphere(C, s, Color.RED),
      "box", (C, u, aux, s) -> new Box(C, u, aux, s, 0.7f * s, 0.001f * s, Color.RED),
      "cylinder", (C, u, aux, s) -> new Cylinder(C, u, 0.01f * s, s, Color.RED),
      "capsule", (C, u, aux, s) -> new Capsule(C, u, 0.1f * s, s, Color.RED),
      "torus", (C, u, aux, s) -> new Torus(C, u, s, 0.3f * s, Color.RED),
      "spindle torus", (C, u, aux, s) -> new Torus(C, u, 0.7f * s, s, Color.RED),
      "ellipsoid", (C, u, aux, s) -> new Ellipsoid(C, u, aux, s, 0.3f * s, 0.01f * s, Color.RED),
      "plane", (C, u, aux, s) -> new Plane(C, u, Color.RED),
      "transformed", (C, u, aux, s) -> new AffineTransformation(new Vector3f(s, 0.001f * s, -3 * s), u, 40,
          new Vector3f(C), new Sphere(new Point3D(0.1f, -0.1f, 0.1f), 1, Color.RED))));

  static {
    MAKERS.put("plane through a far point", (C, u, aux, s) -> {
      final Point3D far = new Point3D();
      far.scaleAdd(1e4f * s, aux, C);
      return new Plane(far, u, Color.RED);
    });
    MAKERS.put("moved back from afar", (C, u, aux, s) -> {
      final Point3D far = new Point3D(1e4f * s * aux.x, 1e4f * s * aux.y, 1e4f * s * aux.z);
      return new AffineTransformation(new Vector3f(1, 1, 1), new Vector3f(C.x - far.x, C.y - far.y, C.z - far.z),
          new Sphere(far, s, Color.RED));
    });
    MAKERS.put("egg", (C, u, aux, s) -> new Egg(C, u, 0.7f * s, s, 0.3f * s, Color.RED));
    MAKERS.put("needle egg", (C, u, aux, s) -> new Egg(C, u, 0.01f * s, s, 0.8f * s, Color.RED));
    MAKERS.put("blunt egg", (C, u, aux, s) -> new Egg(C, u, s, 0.5f * s, 0.499f * s, Color.RED));
    MAKERS.put("truncated cone", (C, u, aux, s) -> new TruncatedCone(C, u, s, 0.4f * s, 0.7f * s, Color.RED));
    MAKERS.put("needle cone", (C, u, aux, s) -> new TruncatedCone(C, u, 0, 0.03f * s, s, Color.RED));
    MAKERS.put("flat cone", (C, u, aux, s) -> new TruncatedCone(C, u, s, 0, 0.01f * s, Color.RED));
  }

  /** A sphere such as a student writes it, in floats throughout. */
  private static final class FloatBall extends Object3D {

    private final Point3D C;
    private final float r;

    FloatBall(final Point3D C, final float r) {
      super(Color.RED);
      this.C = C;
      this.r = r;
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      final Vector3D l = between(C, ray.getStartingPoint()), v = ray.getDirection();
      final float b = l.dot(v), c = l.dot(l) - r * r, d = b * b - c;
      final float root = (float) Math.sqrt(d), t = -b - root > 0 ? -b - root : -b + root;
      if (!(d >= 0 && t > 0)) {
        return Hit.NOHIT;
      }
      final Point3D P = ray.pointAtParameter(t);
      return new Hit(t, P, between(C, P), this);
    }

    private static Vector3D between(final Point3D A, final Point3D B) {
      return new Vector3D(B.x - A.x, B.y - A.y, B.z - A.z);
    }
  }

  @TestFactory
  Stream<DynamicTest> theSurfaceThatIsLeftIsNotSeenFromBehind() {
    return MAKERS.entrySet().stream().map(maker -> DynamicTest.dynamicTest(maker.getKey(), () -> {
      final RandomNumbers numbers = new RandomNumbers("leaving " + maker.getKey());
      int left = 0;
      for (int i = 0; i < RandomNumbers.times(RAYS); i++) {
        left += leave(maker.getValue(), numbers, maker.getKey()) ? 1 : 0;
      }
      assertTrue(left > RAYS / 100, () -> "too few hits " + numbers);
    }));
  }

  private static boolean leave(final Maker maker, final RandomNumbers numbers, final String name) {
    final float size = numbers.magnitude(-10, 20);
    final Point3D C = numbers.pointAbout(new Point3D(), size * Math.pow(10, numbers.between(-2, 4)));
    final Vector3D u = numbers.direction(), aux = numbers.direction();
    aux.cross(aux, u);
    final Object3D shape = maker.make(C, u, aux, size);
    final Point3D eye = numbers.pointAbout(C, size * Math.pow(10, numbers.between(0, 4)));
    final Ray ray = new Ray(eye, numbers.pointAbout(C, 0.6 * size));
    final Hit hit = Object3D.askFor(shape, ray);
    if (!hit.hits()) {
      return false;
    }
    final double height = numbers.index(2) == 0 ? numbers.between(0, 1) : numbers.magnitude(-40, 0);
    for (final boolean outside : new boolean[] {true, false}) {
      final double[] d = direction(hit, numbers.direction(), outside ? height : -height);
      final Ray next = hit.leave(outside, d[0], d[1], d[2]);
      final Hit again = Object3D.askFor(shape, next);
      final double cosine = again.geometricX() * d[0] + again.geometricY() * d[1] + again.geometricZ() * d[2];
      final boolean rightSide = !again.hits() || (outside ? cosine <= 1e-3 : cosine >= -1e-3);
      assertTrue(rightSide, () -> shape + " at " + hit.getPoint() + " from " + ray + " left "
          + (outside ? "outwards" : "inwards") + " by " + next + " is hit again at " + again.distance() + ", error "
          + hit.errorBound() + ", cosine " + cosine + ", height " + height + "; " + numbers);
      final boolean convex = !name.contains("torus");
      assertTrue(!(outside && convex && again.hits()), () -> shape + " is hit again by " + next + " at " + again.distance()
          + "; " + numbers);
    }
    return true;
  }

  /** Error bounds are some hundred roundings of the numbers that are computed with: contact shadows close. */
  @TestFactory
  Stream<DynamicTest> errorBoundsAreSmall() {
    return MAKERS.entrySet().stream().filter(maker -> maker.getKey().matches(
        "sphere|cylinder|capsule|torus|ellipsoid|plane|egg|needle egg|blunt egg|truncated cone|needle cone"))
        .map(maker -> DynamicTest.dynamicTest(maker.getKey(), () -> {
          final RandomNumbers numbers = new RandomNumbers("error bound of " + maker.getKey());
          for (int i = 0; i < RandomNumbers.times(RAYS); i++) {
            final float size = numbers.magnitude(-10, 20);
            final Point3D C = numbers.pointAbout(new Point3D(), size * Math.pow(10, numbers.between(-2, 4)));
            final Vector3D u = numbers.direction(), aux = numbers.direction();
            final Object3D shape = maker.getValue().make(C, u, aux, size);
            final Ray ray = new Ray(numbers.pointAbout(C, 10 * size), numbers.pointAbout(C, 0.6 * size));
            final Hit hit = shape.intersectionWith(ray);
            final double largest = Math.abs(C.x) + Math.abs(C.y) + Math.abs(C.z) + 20 * size;
            assertTrue(!hit.hits() || hit.errorBound() > 0 && hit.errorBound() < 1e-13 * largest,
                () -> shape + ", " + ray + ": " + hit.errorBound() + "; " + numbers);
          }
        }));
  }

  /** Of a million rays that leave a sphere outwards none hits it again; those inwards hit its far wall after the chord. */
  @Test
  void aSphereIsLeftByAMillionRays() {
    final RandomNumbers numbers = new RandomNumbers("a million from a sphere");
    int left = 0;
    while (left < RandomNumbers.times(1_000_000)) {
      final float r = (float) Math.pow(10, numbers.between(-3, 6));
      final Point3D C = numbers.pointAbout(new Point3D(), r * Math.pow(10, numbers.between(-2, 4)));
      final Sphere sphere = new Sphere(C, r, Color.RED);
      final Hit hit = sphere.intersectionWith(new Ray(numbers.pointAbout(C, r * Math.pow(10, numbers.between(0, 4))),
          numbers.pointAbout(C, 0.6 * r)));
      for (int i = 0; i < 20 && hit.hits(); i++, left++) {
        final double height = i % 2 == 0 ? numbers.between(0, 1) : numbers.magnitude(-40, 0);
        final double[] d = direction(hit, numbers.direction(), height);
        final Hit out = sphere.intersectionWith(hit.leave(true, d[0], d[1], d[2]));
        final Hit in = sphere.intersectionWith(hit.leave(false, -d[0], -d[1], -d[2]));
        final double cosine = Math.abs(d[0] * hit.normalX() + d[1] * hit.normalY() + d[2] * hit.normalZ());
        final double rounding = hit.errorBound() / Math.max(cosine, Math.sqrt(hit.errorBound() / r));
        if (out.hits() || !in.hits() || !(Math.abs(in.distance() - 2 * r * cosine) <= 4 * rounding)) {
          throw new AssertionError(sphere + ", " + hit + " left at height " + height + ": " + out + ", " + in.distance()
              + " for " + 2 * r * cosine + ", error " + hit.errorBound() + "; " + numbers);
        }
      }
    }
  }

  /** A unit vector of a height over the surface. */
  private static double[] direction(final Hit hit, final Vector3D v, final double height) {
    final double gx = hit.geometricX(), gy = hit.geometricY(), gz = hit.geometricZ();
    final double along = v.x * gx + v.y * gy + v.z * gz;
    final double tx = v.x - along * gx, ty = v.y - along * gy, tz = v.z - along * gz;
    final double k = Math.sqrt(1 - height * height) / Math.sqrt(tx * tx + ty * ty + tz * tz);
    return CrossingOracle.normalised(k * tx + height * gx, k * ty + height * gy, k * tz + height * gz);
  }

  /** Hits of floats: a ray does not see the surface it leaves, but still sees what is behind it. */
  @Test
  void userWrittenSurfaceIsLeftAndItsFarWallSeen() {
    final RandomNumbers numbers = new RandomNumbers("leaving floats");
    for (int i = 0; i < RandomNumbers.times(20_000); i++) {
      final float size = numbers.magnitude(-10, 10);
      final Point3D C = numbers.pointAbout(new Point3D(), 10 * size);
      final Object3D ball = new AffineTransformation(numbers.direction(), 30, new Vector3f(), new FloatBall(C, size));
      final Hit hit = ball.intersectionWith(new Ray(numbers.pointAbout(C, 5 * size), numbers.pointAbout(C, size)));
      if (hit.hits()) {
        final double[] d = direction(hit, numbers.direction(), numbers.between(0.01, 1));
        final Hit out = Object3D.askFor(ball, hit.leave(true, d[0], d[1], d[2]));
        assertTrue(!out.hits(), () -> hit + " is hit again at " + out.distance() + "; " + numbers);
        final Hit in = Object3D.askFor(ball, hit.leave(false, -d[0], -d[1], -d[2]));
        final double chord = 2 * size * (d[0] * hit.geometricX() + d[1] * hit.geometricY() + d[2] * hit.geometricZ());
        assertEquals(chord, in.distance(), 0.01 * size, () -> hit + " left inwards; " + numbers);
      }
    }
  }

  /** A closed mesh about a ball: any-hit and closest hit agree, and rays that leave it outwards escape. */
  @Test
  void convexMeshIsNotHitAgain() {
    final RandomNumbers numbers = new RandomNumbers("leaving a mesh");
    final Object3D mesh = TriangularMesh.of(new float[] {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1},
        new int[] {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5}, Color.RED);
    final Group3D group = new Group3D();
    group.addObject(mesh);
    for (int i = 0; i < RandomNumbers.times(20_000); i++) {
      final Point3D eye = numbers.pointAbout(new Point3D(), Math.pow(10, numbers.between(0, 4)));
      final Ray ray = new Ray(eye, numbers.pointAbout(new Point3D(), 0.5));
      final Hit hit = group.intersectionWith(ray);
      if (hit.hits() && hit.normalX() * ray.directionX() + hit.normalY() * ray.directionY()
          + hit.normalZ() * ray.directionZ() < 0) {
        final double[] d = direction(hit, numbers.direction(), numbers.magnitude(-40, 0));
        final Ray next = hit.leave(true, d[0], d[1], d[2]);
        assertTrue(!group.intersectAny(next, 1e9), () -> hit + " left by " + next + "; " + numbers);
        assertTrue(group.intersectAny(hit.leave(false, -d[0], -d[1], -d[2]), 1e9), () -> hit + "; " + numbers);
      }
    }
  }

  @Test
  void limitItselfIsNotBeforeTheLimit() {
    final Group3D group = new Group3D();
    group.addObject(new Sphere(new Point3D(0, 0, -5), 1, Color.RED));
    group.addObject(new FloatBall(new Point3D(0, 9, -5), 1));
    for (final float y : new float[] {0, 9}) {
      final Ray asked = new Ray(new Point3D(0, y, 0), new Vector3D(0, 0, -1));
      assertEquals(false, group.intersectAny(asked, 4));
      assertEquals(true, group.intersectAny(asked, 4.001));
      assertEquals(false, group.intersectAny(asked, 3));
    }
    assertEquals(false, group.intersectAny(Ray.NORAY, 1e9));
  }
}
