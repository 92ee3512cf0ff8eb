package models;

import static arguments.Arguments.notNull;
import static arguments.Arguments.wrong;

import java.awt.Color;
import java.lang.ref.WeakReference;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;

import acceleration.RayTile;
import primitives.BoundingBox;
import tracer.Hit;
import tracer.Ray;

/**
 * A group of objects, which is an object itself: the way to put a scene together.
 *
 * <p><img src="doc-files/Group3D.png" width="320" height="240" alt="A group of a sphere, a box, and a torus">
 *
 * <p>Its hit by a ray is the closest hit of its objects; of two at the same distance, that of the object added first.
 * Instead of asking all of them it keeps a tree of their boxes ({@link acceleration.Bvh}), which is made at the
 * first query after an {@link #addObject} to it or to a group within it; the hits are the same. Groups within a group
 * are opened up for that. Safe for use by several threads: an object that is added while another thread queries the group
 * belongs to it for the queries that begin after {@code addObject} has returned.
 */
public class Group3D extends Object3D {

  /** The lock under which objects are added one after the other, so that no two groups come to contain each other. */
  private static final Object ADDING = new Object();

  private final List<Object3D> objects = new ArrayList<>();
  /** The groups that it is within, directly or transformed. */
  private final List<WeakReference<Group3D>> containers = new ArrayList<>();
  /** Whether a tree that is up to date, its own or that of a group that it is within, was built of its objects. */
  private volatile boolean isInTree;
  /** How often its tree was put out of date. */
  private volatile long additions;
  private volatile FlatGroup members;
  /** Whether it is within another object, and so can come to contain itself. */
  private volatile boolean isPart;

  /** An empty group. */
  public Group3D() {
    super();
  }

  /**
   * Adds an object, the last one so far in the order of the group.
   *
   * @param obj the object
   * @throws IllegalArgumentException if the object is null, or is this group or contains it
   */
  public void addObject(final Object3D obj) {
    notNull("obj", obj);
    synchronized (ADDING) {
      if (obj == this || isPart && contains(obj, this)) {
        throw wrong("cycle");
      }
      obj.markContained();
      obj.addContainer(this);
      synchronized (objects) {
        objects.add(obj);
      }
      countAddition();
    }
  }

  /** Puts the trees out of date that were built of the objects of this group. Above a group that is in none, all are. */
  private void countAddition() {
    final Deque<Group3D> open = new ArrayDeque<>(List.of(this));
    while (!open.isEmpty()) {
      final Group3D group = open.pop();
      if (group.isInTree) {
        group.isInTree = false;
        group.additions = group.additions + 1;
        for (final WeakReference<Group3D> container : group.containers) {
          final Group3D outer = container.get();
          if (outer != null) {
            open.push(outer);
          }
        }
      }
    }
  }

  /** Its objects become part of a tree, which the next addition puts out of date. */
  @Override
  void addTo(final OpenedGroup opened) {
    isInTree = true;
    opened.addAll(getObjects());
  }

  @Override
  void addContainer(final Group3D container) {
    containers.removeIf(known -> known.get() == null);
    containers.add(new WeakReference<>(container));
  }

  @Override
  void markContained() {
    isPart = true;
  }

  private static boolean contains(final Object3D whole, final Object3D part) {
    final Set<Object3D> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    final Deque<Object3D> open = new ArrayDeque<>(List.of(whole));
    while (!open.isEmpty()) {
      final Object3D object = open.pop();
      if (object == part) {
        return true;
      }
      if (seen.add(object)) {
        object.parts().forEach(open::push);
      }
    }
    return false;
  }

  /**
   * The objects of the group, in the order in which they were added.
   *
   * @return a list of its own, which does not change
   */
  public List<Object3D> getObjects() {
    synchronized (objects) {
      return List.copyOf(objects);
    }
  }

  /**
   * The objects of the group with those of the groups within it in their place.
   *
   * @return a list of its own without groups, in the order in which a ray asks them, each object once
   */
  public List<Object3D> getMembers() {
    return OpenedGroup.membersOf(this);
  }

  @Override
  public List<Object3D> parts() {
    return getObjects();
  }

  private FlatGroup members() {
    final FlatGroup known = members;
    return known != null && known.isOf(additions) ? known : built();
  }

  private synchronized FlatGroup built() {
    FlatGroup known = members;
    final long number = additions;
    if (known == null || !known.isOf(number)) {
      known = FlatGroup.of(this, number);
      members = known;
    }
    return known;
  }

  /**
   * Takes note of user-written objects whose boxes have changed. A picture begins with it; who queries the group himself
   * calls it after such a change.
   */
  public void refresh() {
    final FlatGroup known = members;
    if (known != null && known.isOutdated()) {
      synchronized (this) {
        members = members == known ? null : members;
      }
    }
  }

  @Override
  void refreshParts() {
    refresh();
  }

  /** Null: the objects have colours of their own. */
  @Override
  public Color getColor() {
    return null;
  }

  @Override
  public Hit intersectionWith(final Ray ray) {
    return notNull("ray", ray) == Ray.NORAY ? Hit.NOHIT : members().closestHit(ray);
  }

  /**
   * Whether a ray hits any object of the group before a distance. It is found sooner than which of them it hits first.
   *
   * @param ray the ray; {@link Ray#NORAY} hits nothing
   * @param tmax the distance in scene units; a hit at this very distance does not count
   * @return whether there is a hit
   * @throws IllegalArgumentException if the ray is null
   */
  public boolean intersectAny(final Ray ray, final double tmax) {
    return notNull("ray", ray) != Ray.NORAY && members().intersectsBefore(ray, tmax);
  }

  /**
   * The object of this group, or of a group within it, that a ray hits first.
   *
   * @param ray the ray
   * @return the object, perhaps a transformation; null if the ray hits nothing
   * @throws IllegalArgumentException if the ray is null
   */
  public Object3D objectHitBy(final Ray ray) {
    return notNull("ray", ray) == Ray.NORAY ? null : members().closest(ray).object();
  }

  @Override
  void block(final ShadowTile tile) {
    members().block(tile);
  }

  @Override
  boolean intersectsBefore(final Ray ray, final double tmax) {
    return members().intersectsBefore(ray, tmax);
  }

  @Override
  boolean answersTiles() {
    return true;
  }

  /**
   * Offers the closest hits of the rays of a tile: what {@link #intersectionWith} returns for each of them.
   *
   * @param rays the rays
   * @param hits the hits found so far, {@link TileHits#clear cleared} by whoever begins
   */
  @Override
  public void closestHits(final RayTile rays, final TileHits hits) {
    members().closestHits(rays, hits);
  }

  @Override
  int cost(final Ray ray) {
    return members().cost(ray);
  }

  @Override
  public BoundingBox getBoundingBox() {
    return members().box();
  }

  @Override
  public String toString() {
    return "Group3D(" + getObjects().size() + " objects)";
  }
}
