package models;

import static models.HitAssertions.assertSameHit;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.List;

import javax.vecmath.Vector3f;

import org.junit.jupiter.api.Test;

import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;
import tracer.RayGenerator;
import upnatray.Image;
import view.Angular;
import view.Camera;
import view.Orthographic;
import view.Perspective;
import view.Projection;

/** A student's object that implements {@code intersectionWith} only obeys the laws and works wherever others do. */
class StudentsObjectTest implements Object3DContract {

  private static final Cone CONE = new Cone(new Point3D(), new Vector3D(0, 1, 0), 3, 4, Color.ORANGE);

  @Override
  public Object3D shape(final RandomPlacement at) {
    return new Cone(at.point(1, -1, 0.5), at.direction(0, 0.6, 0.8), at.length(1.5f), at.length(2), Color.ORANGE);
  }

  @Override
  public double signedDistance(final double x, final double y, final double z) {
    final double px = x - 1, py = y + 1, pz = z - 0.5, s = 0.6 * py + 0.8 * pz;
    final double rho = Math.sqrt(Math.max(0, px * px + py * py + pz * pz - s * s));
    final double side = (rho * 2 + s * 1.5 - 3) / 2.5, below = -s;
    return Math.max(side, below);
  }

  @Override
  public double size() {
    return 4;
  }

  @Override
  public Point3D centre() {
    return new Point3D(1, -0.5f, 1);
  }

  private static Group3D groupOf(final Object3D... objects) {
    final Group3D group = new Group3D();
    for (final Object3D object : objects) {
      group.addObject(object);
    }
    return group;
  }

  @Test
  void itsBoxIsAllOfSpaceSoThatEveryRayIsSentToIt() {
    assertSame(BoundingBox.UNBOUNDED, CONE.getBoundingBox());
    assertEquals(BoundingBox.UNBOUNDED.toString(), groupOf(CONE).getBoundingBox().toString());
  }

  @Test
  void itsColourIsTheOneGiven() {
    assertEquals(Color.ORANGE, CONE.getColor());
    assertEquals(Color.ORANGE.getRGB(), CONE.argb(0));
  }

  /** Its slope rises 4 over 3; at half the height the ray along −x hits it at x = 1.5 with the normal (4, 3, 0)/5. */
  @Test
  void worksInGroupsAndTransformations() {
    final Ray ray = new Ray(new Point3D(10, 2, 0), new Vector3D(-1, 0, 0));
    final Object3D moved = new AffineTransformation(new Vector3f(2, 2, 2), new Vector3f(0, 0, 1), 90,
        new Vector3f(0, 0, 100), CONE);
    for (final Object3D object : List.of(CONE, groupOf(CONE), groupOf(new Sphere(new Point3D(-9, 0, 0), 1, Color.RED),
        groupOf(CONE)),
        new AffineTransformation(new Vector3f(1, 1, 1), groupOf(groupOf(CONE))))) {
      final Hit hit = object.intersectionWith(ray);
      assertEquals(8.5, hit.getT(), 1e-6);
      HitAssertions.assertClose(new Vector3D(0.8f, 0.6f, 0), hit.getNormal(), 1e-6, hit.toString());
      assertSame(CONE, hit.getObject());
    }
    final Hit hit = groupOf(moved).intersectionWith(new Ray(new Point3D(-4, 10, 100), new Vector3D(0, -1, 0)));
    assertEquals(7, hit.getT(), 1e-5);
    HitAssertions.assertClose(new Vector3D(-0.6f, 0.8f, 0), hit.getNormal(), 1e-6, hit.toString());
  }

  private static List<Projection> projections() {
    return List.of(new Perspective(60, 1), new Angular(60), new Angular(178), new Orthographic(8, 1));
  }

  private static void assertPicture(final Group3D scene, final int size) {
    for (final Projection projection : projections()) {
      final Camera camera = new Camera(new Point3D(1, 2, 9), new Point3D(0, 1, 0), new Vector3D(0, 1, 0));
      camera.setProjection(projection);
      final Image image = new Image(size, size, Color.BLACK);
      image.synthesis(scene, camera);
      final RayGenerator rays = camera.getRayGenerator(size, size);
      int hits = 0;
      for (int i = 0; i < size * size; i++) {
        final Ray ray = rays.getRay(i % size, i / size);
        final Hit hit = scene.intersectionWith(ray);
        hits += hit.hits() ? 1 : 0;
        assertEquals(hit.hits() ? hit.getObject().getColor().getRGB() : Color.BLACK.getRGB(),
            image.getRGB(i % size, size - 1 - i / size), () -> projection.getClass() + ", " + ray + ": " + hit);
      }
      assertTrue(hits > 0);
    }
  }

  @Test
  void worksInPictures() {
    assertPicture(groupOf(CONE), 50);
    assertPicture(groupOf(groupOf(CONE), new Sphere(new Point3D(2, 0, 0), 1.5f, Color.RED)), 50);
    assertPicture(groupOf(new AffineTransformation(new Vector3f(1, 0.7f, 1), new Vector3f(1, 1, 0), 40, CONE)), 50);
  }

  /** Is hit by each ray at t = 1, in an object whose colour encodes all bits of the ray's direction. */
  private static final class Echo extends Object3D {

    Echo(final Color color) {
      super(color);
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      final long bits = (Double.hashCode(ray.directionX()) * 31L + Double.hashCode(ray.directionY())) * 31L
          + Double.hashCode(ray.directionZ()) + 7L * Double.hashCode(ray.startX());
      return ray == Ray.NORAY ? Hit.NOHIT
          : Hit.of(1, ray.startX(), ray.startY(), ray.startZ(), 1, 0, 0,
              new Echo(new Color((int) (bits ^ bits >>> 32) & 0xffffff)));
    }
  }

  @Test
  void isAskedAboutTheSameRaysInAPictureAsAlone() {
    final Echo echo = new Echo(Color.WHITE);
    final Object3D turned = new AffineTransformation(new Vector3f(1, 2, 3), new Vector3f(1, 2, 3), 40,
        new Vector3f(1, 2, 3), echo);
    final Object3D inner = new AffineTransformation(new Vector3f(1, 2, 3), new Vector3f(1, 2, 3), 40, new Vector3f(1, 2, 3),
        groupOf(echo));
    for (final Object3D object : List.of(echo, turned, inner, groupOf(inner),
        new AffineTransformation(new Vector3f(0.3f, 0.7f, 1), groupOf(inner,
            new Sphere(new Point3D(0, 0, -99), 1, Color.RED))))) {
      assertPicture(groupOf(object), 20);
    }
  }

  @Test
  void nullInsteadOfAHitIsAnsweredByAWordToTheStudent() {
    final Object3D forgetful = new Object3D(Color.RED) {
      @Override
      public Hit intersectionWith(final Ray ray) {
        return null;
      }

      @Override
      public BoundingBox getBoundingBox() {
        return null;
      }
    };
    final Ray ray = new Ray(new Point3D(), new Vector3D(0, 0, -1));
    final Camera camera = new Camera(new Point3D(), new Point3D(0, 0, -1), new Vector3D(0, 1, 0));
    camera.setProjection(new Perspective(60, 1));
    final Object3D moved = new AffineTransformation(new Vector3f(1, 1, 2), forgetful);
    for (final Object3D object : List.of(forgetful, moved)) {
      final Group3D group = groupOf(object);
      for (final String message : List.of(
          assertThrows(IllegalStateException.class, () -> group.intersectionWith(ray)).getMessage(),
          assertThrows(IllegalStateException.class, () -> new Image(4, 4, Color.RED).synthesis(group,
              camera)).getMessage())) {
        assertTrue(message.contains(forgetful.getClass().getName()) && message.contains("null"), message);
      }
    }
    assertThrows(IllegalStateException.class, () -> moved.intersectionWith(ray));
  }

  @Test
  void groupsComeToTheSameAnswerAsScanning() {
    final RandomNumbers numbers = new RandomNumbers("student's objects");
    final Object3D[] objects = new Object3D[30];
    for (int i = 0; i < objects.length; i++) {
      final Point3D C = numbers.pointAbout(new Point3D(), 10);
      objects[i] = i % 2 == 0 ? new Cone(C, numbers.direction(), 1, 2, Color.RED) : new Sphere(C, 1, Color.RED);
    }
    final Group3D group = groupOf(objects);
    final ContractRays rays = new ContractRays(numbers, new Point3D(), 10);
    for (int i = 0; i < 2000; i++) {
      final Ray ray = rays.next();
      assertSameHit(Scan.closest(List.of(objects), ray), group.intersectionWith(ray), ray + ", " + numbers);
    }
  }
}
