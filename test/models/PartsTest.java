package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.List;
import java.util.Random;

import javax.vecmath.Vector3f;

import org.junit.jupiter.api.Test;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;
import trials.Trials;

/** Objects that are made of others, looked at part by part. */
class PartsTest {

  private static final Ray RAY = new Ray(new Point3D(0, 0, 9), new Vector3D(0, 0, -1));

  private int hits;

  private static Sphere sphere(final float x) {
    return new Sphere(new Point3D(x, 0, 0), 1, Color.RED);
  }

  private static Group3D groupOf(final Object3D... objects) {
    final Group3D group = new Group3D();
    for (final Object3D object : objects) {
      group.addObject(object);
    }
    return group;
  }

  private static Vector3f vector(final Random random, final float least) {
    return new Vector3f(least + random.nextFloat(), least + random.nextFloat(), least + random.nextFloat());
  }

  @Test
  void membersStandInTheirOrderWithThoseOfInnerGroupsInTheirPlaceEachOnce() {
    final Sphere a = sphere(0), b = sphere(1), c = sphere(2), d = sphere(3);
    final Object3D moved = new AffineTransformation(new Vector3f(1, 2, 3), groupOf(d));
    final Group3D group = groupOf(a, groupOf(b, groupOf(), groupOf(a, moved)), c, b);
    assertEquals(List.of(a, b, moved, c), group.getMembers());
    assertEquals(List.of(), new Group3D().getMembers());
  }

  @Test
  void membersFollowAnAddition() {
    final Group3D inner = groupOf(sphere(0)), outer = groupOf(inner);
    assertEquals(1, outer.getMembers().size());
    inner.addObject(sphere(1));
    assertEquals(2, outer.getMembers().size());
  }

  @Test
  void thousandsOfGroupsWithinEachOtherAreOpenedUp() {
    final Sphere innermost = sphere(0);
    Group3D group = groupOf(innermost);
    for (int i = 0; i < 20_000; i++) {
      group = groupOf(group);
    }
    assertEquals(List.of(innermost), group.getMembers());
  }

  @Test
  void theHitOfThePartIsThatOfTheTransformation() {
    Trials.of(2000, random -> {
      final Object3D whole = new AffineTransformation(vector(random, 0.5f), vector(random, -0.5f), sphere(0));
      final Vector3f start = vector(random, 2), to = vector(random, -1.6f);
      final Ray ray = new Ray(new Point3D(start.x, start.y, start.z), new Vector3D(to.x, to.y, to.z));
      final Hit hit = whole.parts().get(0).intersectionWith(whole.rayToParts(ray));
      final Hit expected = whole.intersectionWith(ray), found = whole.hitFromParts(ray, hit);
      assertEquals(expected.hits(), found.hits(), ray.toString());
      if (found.hits()) {
        hits++;
        assertEquals(expected.distance(), found.distance(), 1e-12, ray.toString());
        assertEquals(expected.normalX(), found.normalX(), 1e-12, ray.toString());
        assertEquals(expected.pointY(), found.pointY(), 1e-12, ray.toString());
      }
    });
    assertTrue(hits > 100, hits + " hits");
  }

  @Test
  void othersSeeTheSameRayAndTheSameHit() {
    final Hit hit = sphere(0).intersectionWith(RAY);
    for (final Object3D object : List.of(sphere(0), groupOf(sphere(0)))) {
      assertSame(RAY, object.rayToParts(RAY));
      assertSame(hit, object.hitFromParts(RAY, hit));
      assertThrows(IllegalArgumentException.class, () -> object.hitFromParts(null, hit));
      assertThrows(IllegalArgumentException.class, () -> object.hitFromParts(RAY, null));
    }
  }
}
