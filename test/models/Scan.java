package models;

import java.util.List;

import tracer.Hit;
import tracer.Ray;

/** The closest hit by testing all objects: the oracle of trees of boxes. */
final class Scan {

  private Scan() {
  }

  /** The closest hit; of two at the same distance, that of the first object. */
  static Hit closest(final List<? extends Object3D> objects, final Ray ray) {
    Hit closest = Hit.NOHIT;
    for (final Object3D object : objects) {
      final Hit hit = object.intersectionWith(ray);
      if (hit.isCloser(closest)) {
        closest = hit;
      }
    }
    return closest;
  }
}
