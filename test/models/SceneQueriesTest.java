package models;

import static models.HitAssertions.assertSameHit;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

import javax.vecmath.AxisAngle4d;
import javax.vecmath.Matrix3d;
import javax.vecmath.TexCoord2f;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;

import org.junit.jupiter.api.Test;

import acceleration.RayTile;
import materials.Texture;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;
import tracer.RayGenerator;
import view.Camera;
import view.Orthographic;
import view.Perspective;

/** All queries of a scene agree: ray by ray, by tiles, for the closest hit and for any, transformed or not. */
class SceneQueriesTest {

  /** A ball as a student writes it: in floats, and with nothing but the one method. */
  private static final class FloatBall extends Object3D {

    private final Point3D C;
    private final float r;

    FloatBall(final Point3D C, final float r) {
      super(Color.ORANGE);
      this.C = C;
      this.r = r;
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      final Hit hit = new Sphere(C, r, Color.ORANGE).intersectionWith(ray);
      return hit.hits() ? new Hit(hit.getT(), hit.getPoint(), hit.getNormal(), this) : Hit.NOHIT;
    }
  }

  private static Texture chequered() {
    final BufferedImage image = new BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB);
    for (int i = 0; i < 64; i++) {
      image.setRGB(i % 8, i / 8, 0x30201 * (i + 1));
    }
    return new Texture(image);
  }

  /** A textured and smooth sheet about the origin. */
  private static TriangularMesh sheet(final RandomNumbers numbers) {
    final Map<Integer, Point3D> vertices = new HashMap<>();
    final Map<Integer, TexCoord2f> uv = new HashMap<>();
    final List<String> facets = new ArrayList<>();
    for (int i = 0; i < 25; i++) {
      vertices.put(i, new Point3D(i % 5 - 2, i / 5 - 2, (float) numbers.between(-1, 1)));
      uv.put(i, new TexCoord2f(i % 5 / 4f, i / 20f));
      if (i % 5 < 4 && i < 20) {
        facets.add(corner(i) + corner(i + 1) + corner(i + 6));
        facets.add(corner(i) + corner(i + 6) + corner(i + 5));
      }
    }
    return new TriangularMesh(vertices, Map.of(), uv, facets, chequered());
  }

  private static String corner(final int vertex) {
    return vertex + "/" + vertex + " ";
  }

  private static Object3D shape(final RandomNumbers numbers) {
    final Point3D C = numbers.pointAbout(new Point3D(), 6);
    final Vector3D u = numbers.direction();
    final float r = numbers.magnitude(-2, 1);
    return switch (numbers.index(9)) {
      case 0 -> new FloatBall(C, r);
      case 1 -> new Box(C, u, numbers.direction(), r, 2 * r, 3 * r, Color.RED);
      case 2 -> new Sphere(C, r, chequered());
      case 3 -> new Torus(C, u, r, 0.4f * r, Color.GREEN);
      case 4 -> new Triangle(C, numbers.pointAbout(C, 3), numbers.pointAbout(C, 3), Color.CYAN);
      case 5 -> ClosedMesh.icosphere(2).moved(r, C.x, C.y, C.z).mesh();
      case 6 -> new Plane(numbers.pointAbout(C, 3), u, Color.GRAY);
      case 7 -> sheet(numbers);
      default -> new Egg(C, u, r, 1.5f * r, r, Color.PINK);
    };
  }

  /** Shapes, alone, transformed, transformed twice, and in groups that are. */
  private static Group3D scene(final RandomNumbers numbers, final int count) {
    final Group3D scene = new Group3D();
    for (int i = 0; i < count; i++) {
      Object3D object = shape(numbers);
      if (i % 4 == 1) {
        final Group3D inner = new Group3D();
        inner.addObject(object);
        inner.addObject(shape(numbers));
        object = inner;
      }
      for (int k = i % 3; k > 0; k--) {
        object = new AffineTransformation(new Vector3f(numbers.magnitude(-1, 1), -numbers.magnitude(-1, 1), 0.7f),
            numbers.direction(), (float) numbers.between(0, 360), new Vector3f(numbers.direction()), object);
      }
      scene.addObject(object);
    }
    return scene;
  }

  private static Camera camera(final RandomNumbers numbers, final boolean parallel) {
    final Camera camera = new Camera(numbers.pointAbout(new Point3D(), 15), numbers.pointAbout(new Point3D(), 3),
        numbers.direction());
    camera.setProjection(parallel ? new Orthographic(12, 1) : new Perspective(50, 1));
    return camera;
  }

  @Test
  void tilesFindTheHitsOfTheirRaysBitForBit() {
    final RandomNumbers numbers = new RandomNumbers("hits by tiles");
    int hits = 0;
    for (int i = 0; i < RandomNumbers.times(150); i++) {
      final Group3D scene = scene(numbers, 1 + i % 20);
      final RayGenerator rays = camera(numbers, i % 4 == 0).getRayGenerator(40, 40);
      final int columns = 1 + numbers.index(16), rows = 1 + numbers.index(16);
      final int m = numbers.index(40 - columns), n = numbers.index(40 - rows);
      final RayTile tile = new RayTile();
      tile.open(columns, rows);
      rays.fill(tile, m, n);
      tile.close();
      final TileHits found = new TileHits(tile);
      found.clear();
      scene.closestHits(tile, found);
      for (int row = 0; row < rows; row++) {
        for (int column = 0; column < columns; column++) {
          hits += assertSame(scene, rays.getRay(m + column, n + row), found, row * RayTile.SIZE + column, numbers);
        }
      }
    }
    assertTrue(hits > 1000, "hits: " + hits);
  }

  private static int assertSame(final Group3D scene, final Ray ray, final TileHits found, final int i,
      final RandomNumbers numbers) {
    final Hit expected = scene.intersectionWith(ray), hit = found.hit(i);
    assertSameHit(expected, hit, ray + ", " + numbers);
    assertEquals(expected.hits(), found.hits(i));
    if (expected.hits()) {
      assertEquals(expected.distance(), hit.distance(), 1e-12 * hit.distance());
      assertEquals(expected.getGeometricNormal(), hit.getGeometricNormal());
      assertEquals(expected.getTexCoord(), hit.getTexCoord());
      assertEquals(expected.getObject().getColorAt(expected).getRGB(), found.argb(i), () -> hit + ", " + numbers);
    }
    return expected.hits() ? 1 : 0;
  }

  /** Something is hit before a distance if and only if the closest hit is. */
  @Test
  void anyHitBeforeADistanceIsTheClosestOne() {
    final RandomNumbers numbers = new RandomNumbers("any hit");
    int hits = 0;
    for (int i = 0; i < RandomNumbers.times(150); i++) {
      final Group3D scene = scene(numbers, 1 + i % 20);
      for (int k = 0; k < 60; k++) {
        final Ray ray = new Ray(numbers.pointAbout(new Point3D(), 15), numbers.pointAbout(new Point3D(), 6));
        final Hit hit = scene.intersectionWith(ray);
        final double t = hit.hits() ? hit.distance() : 1e6;
        hits += hit.hits() ? 1 : 0;
        for (final double part : new double[] {0.01, 0.5, 0.9999}) {
          assertEquals(false, scene.intersectAny(ray, part * t), () -> hit + " along " + ray + ", " + numbers);
        }
        for (final double times : new double[] {1.0001, 2, 100}) {
          assertEquals(hit.hits(), scene.intersectAny(ray, times * t), () -> hit + " along " + ray + ", " + numbers);
        }
      }
    }
    assertTrue(hits > 1000, "hits: " + hits);
  }

  /** The transformation of numbers in double is that of the constructor in floats. */
  @Test
  void transformationInDoubleIsTheOneInFloats() {
    final RandomNumbers numbers = new RandomNumbers("transformation in double");
    int hits = 0;
    for (int i = 0; i < RandomNumbers.times(300); i++) {
      final Object3D object = shape(numbers);
      final Vector3f s = new Vector3f(numbers.magnitude(-1, 1), -numbers.magnitude(-1, 1), numbers.magnitude(-1, 1));
      final Vector3f axis = new Vector3f(numbers.direction()), d = new Vector3f(numbers.direction());
      final float theta = (float) numbers.between(0, 360);
      final Vector3d unit = new Vector3d(axis);
      unit.normalize();
      final Matrix3d rotation = new Matrix3d();
      rotation.set(new AxisAngle4d(unit, Math.toRadians(theta)));
      final Object3D floats = new AffineTransformation(s, axis, theta, d, object);
      final Object3D doubles = AffineTransformation.of(new Vector3d(s), rotation, new Vector3d(d), object);
      assertEquals(floats.getBoundingBox().toString(), doubles.getBoundingBox().toString());
      for (int k = 0; k < 30; k++) {
        final Ray ray = new Ray(numbers.pointAbout(new Point3D(), 15), numbers.pointAbout(new Point3D(), 6));
        final Hit expected = floats.intersectionWith(ray), hit = doubles.intersectionWith(ray);
        hits += hit.hits() ? 1 : 0;
        assertEquals(expected.hits(), hit.hits());
        if (hit.hits()) {
          assertEquals(expected.distance(), hit.distance(), 1e-9 * hit.distance());
          assertTrue(expected.getPoint().epsilonEquals(hit.getPoint(), 1e-5f), () -> expected + ", " + hit);
          assertTrue(expected.getNormal().epsilonEquals(hit.getNormal(), 1e-5f), () -> expected + ", " + hit);
          assertEquals(expected.errorBound(), hit.errorBound(), 1e-6 * hit.errorBound());
        }
      }
    }
    assertTrue(hits > 500, "hits: " + hits);
  }

  /** The arguments that a transformation returns make the same transformation again; one in double has none. */
  @Test
  void argumentsMakeTheSameTransformationAgain() {
    final Sphere ball = new Sphere(new Point3D(1, 2, 3), 1, Color.RED);
    final AffineTransformation made = new AffineTransformation(new Vector3f(2, -3, 4), new Vector3f(1, 2, 3), 40,
        new Vector3f(5, 6, 7), ball);
    final List<Object> arguments = made.constructorArguments();
    final AffineTransformation again = new AffineTransformation((Vector3f) arguments.get(0), (Vector3f) arguments.get(1),
        (float) arguments.get(2), (Vector3f) arguments.get(3), (Object3D) arguments.get(4));
    assertEquals(made.getBoundingBox().toString(), again.getBoundingBox().toString());
    final Matrix3d identity = new Matrix3d();
    identity.setIdentity();
    assertEquals(List.of(), AffineTransformation.of(new Vector3d(1, 1, 1), identity, new Vector3d(), ball)
        .constructorArguments());
    assertEquals(List.of(ball), made.parts());
    final Ray ray = new Ray(new Point3D(9, 8, 7), new Point3D(7, 0, 19));
    assertEquals(made.rayToObject(ray).toString(), made.rayToParts(ray).toString());
  }
}
