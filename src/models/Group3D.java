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
 * A group of objects, itself an object: scenes are built of groups.
 *
 * <p><img src="doc-files/Group3D.png" width="320" height="240" alt="A group of a sphere, a box, and a torus">
 *
 * <p>Its hit is the closest hit of its objects; of two at the same distance, that of the object added first. Instead of
 * testing all of them it keeps a tree of their boxes ({@link acceleration.Bvh}), which is built at the first query after
 * an {@link #addObject} to it or to a nested group; the hits are the same. Nested groups are flattened for that. Safe for
 * use by several threads: an object that is added while another thread queries the group belongs to it for the queries
 * that begin after {@code addObject} has returned.
 */
public class Group3D extends Object3D {

  /** The lock under which objects are added one after the other, so that no two groups come to contain each other. */
  private static final Object ADDING = new Object();

  private final List<Object3D> objects = new ArrayList<>();
  /** The groups that contain it, directly or transformed. */
  private final List<WeakReference<Group3D>> containers = new ArrayList<>();
  /** Whether its objects are in an up-to-date tree, its own or that of a group that contains it. */
  private volatile boolean isInTree;
  /** How often its tree was invalidated. */
  private volatile long additions;
  private volatile FlatGroup members;
  /** Whether another object contains it, so that it could come to contain itself. */
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

  /**
   * Invalidates the trees that contain the objects of this group. Above a group in no such tree, all are invalid already.
   */
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

  /** Its objects become part of a tree, which the next addition invalidates. */
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
   * @return an immutable copy of the list
   */
  public List<Object3D> getObjects() {
    synchronized (objects) {
      return List.copyOf(objects);
    }
  }

  /**
   * The objects of the group, with nested groups replaced by their objects.
   *
   * @return an immutable list without groups, in the order in which a ray visits them, each object once
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
   * Takes note of user-written objects whose boxes have changed. Called at the start of a picture; code that queries the
   * group directly calls it after such a change.
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
   * Whether a ray hits any object of the group before a distance. Faster than finding the closest hit.
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
   * @param hits the hits found so far, {@link TileHits#clear cleared} by the caller
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
