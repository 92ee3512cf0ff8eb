package inspection;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;

import models.Group3D;
import models.Object3D;
import tracer.Hit;
import tracer.Ray;

/**
 * The objects of a scene as they were added to it or to a group in it. The object of a hit is the innermost one, such as a
 * triangle of a mesh, or the object within a transformation.
 */
final class SceneObjects {

  private final List<Object3D> members;
  private final Set<Object3D> added = Collections.newSetFromMap(new IdentityHashMap<>());

  SceneObjects(final Group3D scene) {
    members = scene.getMembers();
    added.addAll(members);
  }

  /** The object of the scene that contains the object of a hit; the latter itself if none is found. */
  Object3D of(final Ray ray, final Hit hit) {
    final Object3D part = hit.getObject();
    if (added.contains(part)) {
      return part;
    }
    for (final Object3D member : members) {
      if (isHit(member, ray, part)) {
        return member;
      }
    }
    return part;
  }

  /** Whether a ray hits a part of an object; an object that throws an exception counts as not hit. */
  private static boolean isHit(final Object3D object, final Ray ray, final Object3D part) {
    try {
      final Hit hit = object.intersectionWith(ray);
      return hit != null && hit.getObject() == part;
    } catch (final RuntimeException | StackOverflowError failure) {
      return false;
    }
  }
}
