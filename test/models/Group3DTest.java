package models;

import static models.HitAssertions.assertHit;
import static models.HitAssertions.assertMiss;
import static models.HitAssertions.assertSameHit;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;

import javax.vecmath.Vector3f;

import org.junit.jupiter.api.Test;

import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

class Group3DTest implements Object3DContract {

  private static final Ray DOWN = new Ray(new Point3D(0, 0, 10), new Vector3D(0, 0, -1));

  /** Two balls that touch, in a group within a group; their union gives the hits of one solid. */
  @Override
  public Object3D shape(final RandomPlacement at) {
    final Group3D inner = new Group3D(), group = new Group3D();
    inner.addObject(new Sphere(at.point(-2, 0, 0), at.length(2), Color.RED));
    group.addObject(inner);
    group.addObject(new Sphere(at.point(1, 0, 0), at.length(1), Color.BLUE));
    return group;
  }

  @Override
  public double signedDistance(final double x, final double y, final double z) {
    return Math.min(Math.sqrt((x + 2) * (x + 2) + y * y + z * z) - 2, Math.sqrt((x - 1) * (x - 1) + y * y + z * z) - 1);
  }

  @Override
  public double accuracy() {
    return 1e-12;
  }

  private static Sphere ball(final double z) {
    return new Sphere(new Point3D(0, 0, (float) z), 1, Color.RED);
  }

  private static Group3D groupOf(final Object3D... objects) {
    final Group3D group = new Group3D();
    for (final Object3D object : objects) {
      group.addObject(object);
    }
    return group;
  }

  @Test
  void emptyGroupHitsNothing() {
    assertMiss(new Group3D(), DOWN);
    assertSame(Hit.NOHIT, new Group3D().intersectionWith(Ray.NORAY));
    assertTrue(new Group3D().getBoundingBox().isEmpty());
    assertMiss(groupOf(new Group3D(), groupOf(new Group3D())), DOWN);
  }

  @Test
  void closestObjectIsHitAndTold() {
    final Sphere near = ball(4), far = ball(-4);
    for (final Group3D group : List.of(groupOf(near, far), groupOf(far, near), groupOf(far, groupOf(near)))) {
      assertSameHit(near.intersectionWith(DOWN), group.intersectionWith(DOWN), "");
      assertEquals(5, group.intersectionWith(DOWN).getT());
    }
    assertHit(3, new Point3D(0, 0, -3), new Vector3D(0, 0, 1), far, new Ray(new Point3D(), new Vector3D(0, 0, -1)));
  }

  @Test
  void ofTwoAtTheSameDistanceTheOneAddedFirstWins() {
    for (int n = 2; n < 40; n++) {
      final List<Object3D> objects = new ArrayList<>();
      final Group3D group = new Group3D();
      for (int i = 0; i < n; i++) {
        objects.add(i % 3 == 2 ? new Plane(new Point3D(5, i, 1), new Vector3D(0, 0, 1), Color.RED)
            : i % 3 == 1 ? new Box(new Point3D(), new Vector3D(1, 0, 0), new Vector3D(0, 1, 0), i, i, 2, Color.RED)
                : ball(0));
        group.addObject(objects.get(i));
      }
      assertSame(objects.get(0), group.intersectionWith(DOWN).getObject());
      final Group3D nested = groupOf(new Group3D(), groupOf(groupOf(objects.get(n - 1)), objects.get(0)), group);
      assertSame(objects.get(n - 1), nested.intersectionWith(DOWN).getObject());
    }
  }

  @Test
  void groupHasNoColour() {
    assertNull(groupOf(ball(0)).getColor());
  }

  @Test
  void boxIsTheUnionAndWithoutEndIfThatOfAnObjectIs() {
    final Group3D group = groupOf(ball(0), groupOf(ball(10)));
    assertEquals(-1, group.getBoundingBox().minZ(), 1e-6);
    assertEquals(11, group.getBoundingBox().maxZ(), 1e-5);
    group.addObject(new Plane(new Point3D(), new Vector3D(0, 0, 1), Color.RED));
    assertEquals(BoundingBox.UNBOUNDED.toString(), group.getBoundingBox().toString());
  }

  /** A group of many kinds of objects, some of them in groups, transformations and both. */
  private static Group3D random(final RandomNumbers numbers, final int count, final List<Object3D> flat) {
    final Group3D group = new Group3D();
    for (int i = 0; i < count; i++) {
      final Object3D object = randomObject(numbers);
      if (i % 5 == 4) {
        final Group3D inner = groupOf(object);
        final Object3D moved = new AffineTransformation(new Vector3f(1, 2, -1), new Vector3f(0, 0, 1), 30,
            new Vector3f(1, 1, 1), object);
        inner.addObject(moved);
        group.addObject(inner);
        flat.add(object);
        flat.add(moved);
      } else {
        group.addObject(object);
        flat.add(object);
      }
    }
    return group;
  }

  private static Object3D randomObject(final RandomNumbers numbers) {
    final Point3D C = numbers.pointAbout(new Point3D(), 10);
    final Vector3D u = numbers.direction();
    final float r = numbers.magnitude(-3, 1);
    switch (numbers.index(8)) {
      case 0: return new Plane(C, u, Color.RED);
      case 1: return new Box(C, u, numbers.direction(), r, 2 * r, 3 * r, Color.RED);
      case 2: return new Cylinder(C, u, r, 2 * r, Color.RED);
      case 3: return new Capsule(C, u, r, 2 * r, Color.RED);
      case 4: return new Triangle(C, numbers.pointAbout(C, 3), numbers.pointAbout(C, 3), Color.RED);
      case 5: return ClosedMesh.icosphere(1).moved(r, C.x, C.y, C.z).mesh();
      default: return new Sphere(C, r, Color.RED);
    }
  }

  @Test
  void agreesWithPlainIterationBitForBit() {
    final RandomNumbers numbers = new RandomNumbers("group by linear scan");
    int hits = 0, rays = 0;
    for (final int count : new int[] {1, 2, 3, 5, 10, 40, 150}) {
      for (int k = 0; k < RandomNumbers.times(6); k++) {
        final List<Object3D> flat = new ArrayList<>();
        final Group3D group = random(numbers, count, flat);
        final ContractRays source = new ContractRays(numbers, new Point3D(), 12);
        for (int i = 0; i < 400; i++) {
          final Ray ray = source.next();
          final Hit expected = Scan.closest(flat, ray);
          rays++;
          hits += expected.hits() ? 1 : 0;
          assertSameHit(expected, group.intersectionWith(ray), count + " objects, " + ray + ", " + numbers);
        }
      }
    }
    assertTrue(hits > rays / 3 && hits < rays, hits + " hits of " + rays);
  }

  @Test
  void objectsAddedAfterAQuestionCountWhereverTheyAreAdded() {
    final Group3D inner = new Group3D(), deep = groupOf(new Group3D(), inner);
    final Object3D moved = new AffineTransformation(new Vector3f(1, 1, 1), new Vector3f(0, 0, 2), groupOf(deep));
    final Group3D scene = groupOf(moved);
    assertMiss(scene, DOWN);
    inner.addObject(ball(-10));
    assertEquals(17, scene.intersectionWith(DOWN).getT());
    assertEquals(-9, scene.getBoundingBox().minZ(), 1e-5);
    inner.addObject(ball(-4));
    assertEquals(11, scene.intersectionWith(DOWN).getT());
    deep.addObject(ball(-2));
    assertEquals(9, scene.intersectionWith(DOWN).getT());
    assertEquals(9, moved.intersectionWith(DOWN).getT());
    scene.addObject(ball(3));
    assertEquals(6, scene.intersectionWith(DOWN).getT());
    assertEquals(4, scene.getBoundingBox().maxZ(), 1e-5);
  }

  @Test
  void groupSharedByTwoScenesIsUpToDateInBoth() {
    final Group3D shared = new Group3D(), one = groupOf(shared), other = groupOf(ball(-5), shared);
    assertMiss(one, DOWN);
    assertEquals(14, other.intersectionWith(DOWN).getT());
    shared.addObject(ball(0));
    assertEquals(9, one.intersectionWith(DOWN).getT());
    assertEquals(9, other.intersectionWith(DOWN).getT());
  }

  @Test
  void sameObjectTwiceIsHitOnce() {
    final Sphere ball = ball(0);
    assertSameHit(ball.intersectionWith(DOWN), groupOf(ball, ball, groupOf(ball)).intersectionWith(DOWN), "");
  }

  @Test
  void groupWithinItselfIsRejectedAndChangesNothing() {
    final Group3D group = groupOf(ball(0)), outer = groupOf(group), outermost = groupOf(outer);
    final Object3D moved = new AffineTransformation(new Vector3f(2, 2, 2), outermost);
    for (final Object3D cycle : List.of(group, outer, outermost, moved, groupOf(moved),
        new AffineTransformation(new Vector3f(1, 1, 1), group))) {
      final String message = assertThrows(IllegalArgumentException.class, () -> group.addObject(cycle)).getMessage();
      assertTrue(message.contains("itself"), message);
    }
    assertEquals("Group3D(1 objects)", group.toString());
    assertEquals(9, group.intersectionWith(DOWN).getT());
  }

  @Test
  void groupInTwoPlacesIsNoCycle() {
    final Group3D leaf = groupOf(ball(0)), left = groupOf(leaf), right = groupOf(leaf);
    assertEquals(9, groupOf(left, right, leaf).intersectionWith(DOWN).getT());
  }

  @Test
  void tenThousandGroupsWithinEachOtherAreNotTooMany() {
    final Group3D innermost = groupOf(ball(0));
    Group3D outer = innermost;
    for (int i = 0; i < 10_000; i++) {
      final Group3D next = new Group3D();
      if (i % 2 == 0) {
        next.addObject(outer);
      } else {
        next.addObject(new Group3D());
        next.addObject(outer);
      }
      outer = next;
    }
    assertEquals(9, outer.intersectionWith(DOWN).getT());
    innermost.addObject(ball(2));
    assertEquals(7, outer.intersectionWith(DOWN).getT());
    final Group3D whole = outer;
    assertThrows(IllegalArgumentException.class, () -> innermost.addObject(whole));
  }

  @Test
  void groupsFilledFromOutsideInAreTheSame() {
    final Group3D outermost = new Group3D();
    Group3D group = outermost;
    for (int i = 0; i < 10_000; i++) {
      final Group3D inner = new Group3D();
      group.addObject(inner);
      group = inner;
    }
    assertMiss(outermost, DOWN);
    group.addObject(ball(0));
    assertEquals(9, outermost.intersectionWith(DOWN).getT());
  }

  @Test
  void threadsMayAskWhileOneAdds() throws Exception {
    final Group3D inner = groupOf(ball(-100)), scene = groupOf(new AffineTransformation(new Vector3f(1, 1, 1), inner));
    final List<Throwable> failures = java.util.Collections.synchronizedList(new ArrayList<>());
    final Thread[] threads = new Thread[4];
    for (int k = 0; k < threads.length; k++) {
      threads[k] = new Thread(() -> {
        float last = Float.POSITIVE_INFINITY;
        while (last > 9) {
          final float t = scene.intersectionWith(DOWN).getT();
          assertTrue(t <= last, "an object is gone: " + t + " after " + last);
          last = t;
        }
      });
      threads[k].setUncaughtExceptionHandler((thread, e) -> failures.add(e));
      threads[k].start();
    }
    for (int z = -99; z <= 0; z++) {
      inner.addObject(ball(z));
      assertEquals(10 - z - 1, scene.intersectionWith(DOWN).getT());
    }
    for (final Thread thread : threads) {
      thread.join(20_000);
      assertTrue(!thread.isAlive(), "a thread never saw the last object");
    }
    assertEquals(List.of(), failures);
  }

  @Test
  void textTellsHowManyObjects() {
    assertEquals("Group3D(2 objects)", groupOf(ball(0), new Group3D()).toString());
  }
}
