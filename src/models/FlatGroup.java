package models;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;

import acceleration.Bvh;
import acceleration.RayTile;
import acceleration.SegmentTile;
import primitives.BoundingBox;
import tracer.Hit;
import tracer.Ray;

/**
 * A snapshot of the objects of a group, with nested groups flattened: unbounded objects first, the others in the order of
 * a tree of their boxes. Immutable.
 */
final class FlatGroup {

  /** Objects per leaf of the tree: testing a box costs about as much as testing a simple object. */
  private static final int LEAF = 2;

  /** Shapes that never change; the boxes of others are queried before each picture. */
  private static final Set<Class<?>> IMMUTABLE = Set.of(Box.class, Capsule.class, Cylinder.class, Egg.class,
      Ellipsoid.class, Plane.class, Sphere.class, Torus.class, Triangle.class, TriangularMesh.class, TruncatedCone.class);

  private final long additions;

  private final Object3D[] objects;
  private final BoundingBox[] boxes;

  /** The place of each object in the order of adding. */
  private final int[] order;

  /** The places of objects that may change between two pictures. */
  private final int[] changeable;

  private final int unbounded;
  private final Bvh tree;
  private final BoundingBox box;

  private FlatGroup(final List<Object3D> all, final long additions) {
    this.additions = additions;
    final int n = all.size();
    final BoundingBox[] boxOf = new BoundingBox[n];
    final int[] sorted = new int[n];
    BoundingBox union = BoundingBox.EMPTY;
    int withoutEnd = 0, withEnd = n;
    for (int i = n - 1; i >= 0; i--) {
      boxOf[i] = boxOf(all.get(i));
      union = union.union(boxOf[i]);
      if (boxOf[i].isFinite()) {
        sorted[--withEnd] = i;
      } else {
        sorted[withoutEnd++] = i;
      }
    }
    this.unbounded = withoutEnd;
    this.box = union;
    final int[] place = new int[n - unbounded];
    this.tree = Bvh.over(numbers(boxOf, sorted, unbounded), LEAF, place);
    this.order = new int[n];
    this.objects = new Object3D[n];
    this.boxes = new BoundingBox[n];
    for (int i = 0; i < n; i++) {
      order[i] = i < unbounded ? sorted[i] : sorted[unbounded + place[i - unbounded]];
      objects[i] = OverridingShape.asked(all.get(order[i]));
      boxes[i] = boxOf[order[i]];
    }
    this.changeable = changeable(objects);
  }

  private static int[] changeable(final Object3D[] objects) {
    int end = 0;
    final int[] places = new int[objects.length];
    for (int i = 0; i < objects.length; i++) {
      if (canChange(objects[i])) {
        places[end++] = i;
      }
    }
    return Arrays.copyOf(places, end);
  }

  private static boolean canChange(final Object3D whole) {
    if (IMMUTABLE.contains(whole.getClass())) {
      return false;
    }
    final Set<Object3D> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    final Deque<Object3D> open = new ArrayDeque<>(List.of(whole));
    while (!open.isEmpty()) {
      final Object3D object = open.pop();
      if (seen.add(object) && !IMMUTABLE.contains(object.getClass())) {
        if (object.getClass() != AffineTransformation.class && object.getClass() != Group3D.class) {
          return true;
        }
        object.parts().forEach(open::push);
      }
    }
    return false;
  }

  static FlatGroup of(final Group3D group, final long additions) {
    return new FlatGroup(OpenedGroup.membersOf(group), additions);
  }

  /** Whether this is the snapshot after a number of additions. */
  boolean isOf(final long number) {
    return additions == number;
  }

  /** Whether the box of an object has changed, or cannot be computed. */
  boolean isOutdated() {
    try {
      for (final int i : changeable) {
        objects[i].refreshParts();
        if (!isSame(boxOf(objects[i]), boxes[i])) {
          return true;
        }
      }
      return false;
    } catch (RuntimeException | StackOverflowError boxFails) {
      return true;
    }
  }

  private static boolean isSame(final BoundingBox a, final BoundingBox b) {
    return a.minX() == b.minX() && a.minY() == b.minY() && a.minZ() == b.minZ()
        && a.maxX() == b.maxX() && a.maxY() == b.maxY() && a.maxZ() == b.maxZ();
  }

  /** Box of an object, where a user-written one may return null. */
  static BoundingBox boxOf(final Object3D object) {
    final BoundingBox box = object.getBoundingBox();
    return box == null ? BoundingBox.UNBOUNDED : box;
  }

  private static float[] numbers(final BoundingBox[] boxOf, final int[] which, final int from) {
    final float[] numbers = new float[6 * (which.length - from)];
    for (int i = from, at = 0; i < which.length; i++) {
      final BoundingBox b = boxOf[which[i]];
      numbers[at++] = b.minX();
      numbers[at++] = b.minY();
      numbers[at++] = b.minZ();
      numbers[at++] = b.maxX();
      numbers[at++] = b.maxY();
      numbers[at++] = b.maxZ();
    }
    return numbers;
  }

  BoundingBox box() {
    return box;
  }

  Hit closestHit(final Ray ray) {
    return closest(ray).hit();
  }

  ClosestHit closest(final Ray ray) {
    final ClosestHit closest = new ClosestHit(ray);
    for (int i = 0; i < unbounded; i++) {
      closest.ask(objects[i], order[i]);
    }
    tree.closest(ray.startX(), ray.startY(), ray.startZ(), ray.directionX(), ray.directionY(), ray.directionZ(),
        (first, end) -> {
          for (int i = first; i < end; i++) {
            closest.ask(objects[unbounded + i], order[unbounded + i]);
          }
          return closest.farthest();
        });
    return closest;
  }

  boolean intersectsBefore(final Ray ray, final double tmax) {
    for (int i = 0; i < unbounded; i++) {
      if (objects[i].intersectsBefore(ray, tmax)) {
        return true;
      }
    }
    return tree.any(ray.startX(), ray.startY(), ray.startZ(), ray.directionX(), ray.directionY(), ray.directionZ(), tmax,
        (first, end) -> {
          for (int i = unbounded + first; i < unbounded + end; i++) {
            if (objects[i].intersectsBefore(ray, tmax)) {
              return true;
            }
          }
          return false;
        });
  }

  void block(final ShadowTile tile) {
    final SegmentTile segments = tile.segments();
    for (int i = 0; i < unbounded; i++) {
      segments.project(BoundingBox.UNBOUNDED);
      objects[i].block(tile);
    }
    tree.block(segments, (first, end) -> {
      for (int i = unbounded + first; i < unbounded + end; i++) {
        if (segments.project(boxes[i])) {
          objects[i].block(tile);
        }
      }
      return segments.limit();
    });
  }

  /** The cost of the same query: the objects are visited in the same order, and each reports its cost. */
  int cost(final Ray ray) {
    final ClosestHit closest = new ClosestHit(ray);
    final int[] cost = new int[1];
    for (int i = 0; i < unbounded; i++) {
      closest.ask(objects[i], order[i]);
      cost[0] += objects[i].cost(ray);
    }
    tree.closest(ray.startX(), ray.startY(), ray.startZ(), ray.directionX(), ray.directionY(), ray.directionZ(),
        (first, end) -> {
          for (int i = unbounded + first; i < unbounded + end; i++) {
            closest.ask(objects[i], order[i]);
            cost[0] += objects[i].cost(ray);
          }
          return closest.farthest();
        });
    return cost[0];
  }

  void closestHits(final RayTile rays, final TileHits hits) {
    for (int i = 0; i < unbounded; i++) {
      rays.reset();
      hits.setOrder(order[i]);
      objects[i].closestHits(rays, hits);
    }
    if (rays.frustum().isFitted()) {
      tree.closest(rays.frustum(), (first, end) -> closestHits(rays, hits, unbounded + first, unbounded + end));
    } else {
      rayByRay(rays, hits);
    }
  }

  private double closestHits(final RayTile rays, final TileHits hits, final int first, final int end) {
    for (int i = first; i < end; i++) {
      if (rays.narrowTo(boxes[i])) {
        hits.setOrder(order[i]);
        objects[i].closestHits(rays, hits);
      }
    }
    return hits.farthest();
  }

  /** For rays too incoherent to be traced together. */
  private void rayByRay(final RayTile rays, final TileHits hits) {
    for (int row = 0; row < rays.rows(); row++) {
      for (int i = row * RayTile.SIZE; i < row * RayTile.SIZE + rays.columns(); i++) {
        if (rays.isPresent(i)) {
          final int pixel = i;
          final Ray ray = hits.ray(i);
          tree.closest(rays.startX(i), rays.startY(i), rays.startZ(i),
              rays.directionX(i), rays.directionY(i), rays.directionZ(i), (first, end) -> {
                for (int k = unbounded + first; k < unbounded + end; k++) {
                  hits.setOrder(order[k]);
                  hits.offer(pixel, ray, objects[k]);
                }
                return hits.farthest(pixel);
              });
        }
      }
    }
  }
}
