package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.List;

import javax.vecmath.Matrix3d;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;

import org.junit.jupiter.api.Test;

import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/** Groups of objects that change between two pictures, groups within themselves, and what a group is made of. */
class ChangingGroupsTest {

  private static final Vector3f UP = new Vector3f(0, 1, 0);

  /** A ball that can be moved, and whose box moves with it. */
  private static final class Rolling extends Object3D {

    private Sphere ball = new Sphere(new Point3D(), 1, Color.RED);

    Rolling() {
      super(Color.RED);
    }

    void rollTo(final float x) {
      ball = new Sphere(new Point3D(x, 0, 0), 1, Color.RED);
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      return ball.intersectionWith(ray);
    }

    @Override
    public BoundingBox getBoundingBox() {
      return ball.getBoundingBox();
    }
  }

  private static Group3D groupOf(final Object3D... objects) {
    final Group3D group = new Group3D();
    for (final Object3D object : objects) {
      group.addObject(object);
    }
    return group;
  }

  private static Ray downAt(final float x) {
    return new Ray(new Point3D(x, 0, 9), new Vector3D(0, 0, -1));
  }

  private static Object3D still() {
    return new Sphere(new Point3D(-50, 0, 0), 1, Color.BLUE);
  }

  /** In the group, in a group within it, transformed, and both. */
  @Test
  void aChangedBoxIsKnownAfterARefresh() {
    for (int kind = 0; kind < 4; kind++) {
      final Rolling rolling = new Rolling();
      final Object3D inner = kind == 0 ? rolling : groupOf(rolling, still());
      final Object3D part = kind < 2 ? inner : new AffineTransformation(UP, 0, inner);
      final Group3D scene = groupOf(still(), kind == 3 ? new AffineTransformation(UP, 0, part) : part, still());
      assertTrue(scene.intersectionWith(downAt(0)).hits());
      for (int i = 1; i < 4; i++) {
        rolling.rollTo(20 * i);
        scene.refresh();
        assertFalse(scene.intersectionWith(downAt(20 * i - 20)).hits(), "still where it was");
        assertTrue(scene.intersectionWith(downAt(20 * i)).hits(), "not found where it is, in kind " + kind);
        assertTrue(scene.intersectAny(downAt(20 * i), 100));
      }
    }
  }

  @Test
  void aGroupCannotContainATransformationOfItself() {
    final Matrix3d identity = new Matrix3d();
    identity.setIdentity();
    for (int kind = 0; kind < 4; kind++) {
      final Group3D group = groupOf(still());
      final Object3D once = kind == 1 ? AffineTransformation.of(new Vector3d(1, 1, 1), identity, new Vector3d(), group)
          : new AffineTransformation(UP, 10, group);
      final Object3D part = kind == 2 ? new AffineTransformation(UP, 10, once) : kind == 3 ? groupOf(once) : once;
      assertThrows(IllegalArgumentException.class, () -> group.addObject(part), "kind " + kind);
      assertEquals(1, group.getObjects().size());
    }
  }

  @Test
  void theObjectThatIsHitIsThatOfTheGroupNotThePartOfIt() {
    final Rolling rolling = new Rolling();
    final Object3D moved = new AffineTransformation(new Vector3f(2, 2, 2), new Vector3f(9, 0, 0), rolling);
    final Object3D still = still();
    final Group3D scene = groupOf(groupOf(moved), still);
    assertSame(moved, scene.objectHitBy(downAt(9)));
    assertSame(still, scene.objectHitBy(downAt(-50)));
    assertNull(scene.objectHitBy(downAt(30)));
    assertNull(scene.objectHitBy(Ray.NORAY));
    assertEquals(List.of(moved, still), scene.getMembers());
  }

  /** A group leaves rays and hits as they are on their way to its parts and back; a transformation takes them there. */
  @Test
  void partsAreAskedInTheirOwnFrame() {
    final Sphere ball = new Sphere(new Point3D(), 1, Color.RED);
    final AffineTransformation moved = new AffineTransformation(new Vector3f(2, 2, 2), new Vector3f(9, 0, 0), ball);
    final Group3D group = groupOf(moved);
    final Ray ray = downAt(9.5f);
    assertSame(ray, group.rayToParts(ray));
    final Hit local = ball.intersectionWith(moved.rayToParts(ray)), back = moved.hitFromParts(ray, local);
    assertSame(back, group.hitFromParts(ray, back));
    assertEquals(moved.intersectionWith(ray).toString(), back.toString());
  }
}
