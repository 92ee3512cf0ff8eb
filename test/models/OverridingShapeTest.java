package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.awt.Color;

import javax.vecmath.Vector3f;

import org.junit.jupiter.api.Test;

import acceleration.RayTile;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/** The overridden intersection of a student's subclass of a library shape is called everywhere. */
class OverridingShapeTest {

  /** A ball of which rays hit the right half only. */
  private static final class HalfBall extends Sphere {

    HalfBall() {
      super(new Point3D(), 1, Color.RED);
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      final Hit hit = super.intersectionWith(ray);
      return hit.hits() && hit.pointX() > 0 ? hit : Hit.NOHIT;
    }
  }

  private static Ray ray(final double x) {
    return new Ray(new Point3D((float) x, 0, 5), new Vector3D(0, 0, -1));
  }

  private static void assertHalf(final Object3D half) {
    final Group3D scene = new Group3D();
    scene.addObject(half);
    assertSame(Hit.NOHIT, scene.intersectionWith(ray(-0.5)));
    assertEquals(Color.RED, scene.intersectionWith(ray(0.5)).getObject().getColor());
    assertEquals(false, scene.intersectAny(ray(-0.5), 100));
    assertEquals(true, scene.intersectAny(ray(0.5), 100));
    final RayTile rays = new RayTile();
    rays.open(2, 1);
    rays.put(0, -0.5, 0, 5, 0, 0, -1);
    rays.put(1, 0.5, 0, 5, 0, 0, -1);
    rays.close();
    final TileHits hits = new TileHits(rays);
    hits.clear();
    scene.closestHits(rays, hits);
    assertEquals(false, hits.hits(0));
    assertEquals(Color.RED.getRGB(), hits.argb(1));
  }

  @Test
  void isAskedInAGroupAndInATile() {
    assertHalf(new HalfBall());
  }

  @Test
  void isItselfInAllOtherRespects() {
    final Object3D half = new HalfBall(), asked = OverridingShape.asked(half);
    assertEquals(half.getColor(), asked.getColor());
    assertEquals(half.getBoundingBox().toString(), asked.getBoundingBox().toString());
    assertEquals(half.toString(), asked.toString());
  }

  @Test
  void isAskedUnderATransformation() {
    assertHalf(new AffineTransformation(new Vector3f(1, 2, 1), new HalfBall()));
  }

  @Test
  void shapesOfTheLibraryAndPlainUserWrittenOnesAreAskedThemselves() {
    final Object3D ball = new Sphere(new Point3D(), 1, Color.RED);
    final Object3D group = new Group3D();
    final Object3D torus = new Torus(new Point3D(), new Vector3D(0, 1, 0), 2, 1, Color.RED);
    final Object3D own = new Object3D(Color.RED) {
      @Override
      public Hit intersectionWith(final Ray ray) {
        return Hit.NOHIT;
      }
    };
    final Object3D moved = new AffineTransformation(new Vector3f(1, 2, 1), own);
    for (final Object3D object : new Object3D[] {ball, group, torus, own, moved}) {
      assertSame(object, OverridingShape.asked(object));
    }
  }
}
