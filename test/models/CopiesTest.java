package models;

import static models.HitAssertions.assertSameHit;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.List;
import java.util.function.BiFunction;

import org.junit.jupiter.api.Test;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/** Shapes keep copies of points and vectors, and leave those that they were given as they are. */
class CopiesTest {

  private static final Ray DOWN = new Ray(new Point3D(2.1f, 0.2f, 10), new Vector3D(0, 0, -1));

  private static final List<BiFunction<Point3D[], Vector3D[], Object3D>> SHAPES = List.of(
      (p, v) -> new Sphere(p[0], 3, Color.RED),
      (p, v) -> new Plane(p[0], v[0], Color.RED),
      (p, v) -> new Triangle(p[0], p[1], p[2], Color.RED),
      (p, v) -> new Cylinder(p[0], v[0], 3, 4, Color.RED),
      (p, v) -> new Capsule(p[0], v[0], 3, 4, Color.RED),
      (p, v) -> new Box(p[0], v[0], v[1], 5, 5, 5, Color.RED),
      (p, v) -> new Torus(p[0], v[0], 2, 1, Color.RED),
      (p, v) -> new Ellipsoid(p[0], v[0], v[1], 3, 4, 5, Color.RED),
      (p, v) -> new Egg(p[0], v[0], 3, 4, 1, Color.RED),
      (p, v) -> new TruncatedCone(p[0], v[0], 3, 2, 4, Color.RED));

  @Test
  void laterChangesOfPointsAndVectorsDoNotReachAShape() {
    for (final BiFunction<Point3D[], Vector3D[], Object3D> make : SHAPES) {
      final Point3D[] points = {new Point3D(0, 0, 0), new Point3D(7, -3, 1), new Point3D(4, 9, 2)};
      final Vector3D[] vectors = {new Vector3D(0, 1, 4), new Vector3D(5, 0, 0)};
      final Object3D shape = make.apply(points, vectors);
      assertEquals("(0.0, 1.0, 4.0) (5.0, 0.0, 0.0)", vectors[0] + " " + vectors[1], shape + " changed its arguments");
      final Hit before = shape.intersectionWith(DOWN);
      final String box = shape.getBoundingBox().toString();
      for (final Point3D P : points) {
        P.set(100, -100, Float.NaN);
      }
      for (final Vector3D v : vectors) {
        v.negate();
        v.x = 77;
      }
      assertTrue(before.hits(), shape::toString);
      assertSameHit(before, shape.intersectionWith(DOWN), shape.toString());
      assertEquals(box, shape.getBoundingBox().toString());
    }
  }
}
