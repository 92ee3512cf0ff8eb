package inspection;

import java.util.Collections;
import java.util.IdentityHashMap;
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

  private final Group3D scene;
  private final Set<Object3D> added = Collections.newSetFromMap(new IdentityHashMap<>());

  SceneObjects(final Group3D scene) {
    this.scene = scene;
    collect(scene);
  }

  private void collect(final Group3D group) {
    for (final Object3D object : group.getObjects()) {
      if (added.add(object) && object instanceof Group3D within) {
        collect(within);
      }
    }
  }

  /** The object of the scene that contains the object of a hit; the latter itself if none is found. */
  Object3D of(final Ray ray, final Hit hit) {
    if (added.contains(hit.getObject())) {
      return hit.getObject();
    }
    final Object3D container = find(scene, ray, hit);
    return container == null ? hit.getObject() : container;
  }

  private static Object3D find(final Group3D group, final Ray ray, final Hit hit) {
    for (final Object3D object : group.getObjects()) {
      if (object instanceof Group3D within) {
        final Object3D container = find(within, ray, hit);
        if (container != null) {
          return container;
        }
      } else if (isHit(object, ray, hit.getObject())) {
        return object;
      }
    }
    return null;
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
