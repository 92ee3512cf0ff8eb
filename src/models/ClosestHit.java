package models;

import tracer.Hit;
import tracer.Ray;

/**
 * The closest hit of one ray with the objects of a group tested so far. Distances are compared as floats, and at the same
 * distance the object first added wins, as in {@link TileHits}.
 */
final class ClosestHit {

  /** One plus the relative error of a float: two distances closer than that may compare as equal. */
  static final double SAME = 1 + 0x1p-22;

  private final Ray ray;
  private double t = Double.POSITIVE_INFINITY;
  private int order = -1;
  private Object3D object;
  private Hit hit;

  ClosestHit(final Ray ray) {
    this.ray = ray;
  }

  /** Tests an object that was added as number {@code itsOrder}. */
  void ask(final Object3D asked, final int itsOrder) {
    final double distance = asked.distance(ray.startX(), ray.startY(), ray.startZ(),
        ray.directionX(), ray.directionY(), ray.directionZ());
    if (Double.isNaN(distance)) {
      final Hit found = Object3D.askFor(asked, ray);
      if (isCloser(found.distance(), itsOrder)) {
        take(found.distance(), itsOrder, asked, found);
      }
    } else if (isCloser(distance, itsOrder)) {
      take(distance, itsOrder, asked, null);
    }
  }

  private boolean isCloser(final double distance, final int itsOrder) {
    final float f = (float) distance, best = (float) t;
    return f > 0 && (f < best || f == best && itsOrder < order);
  }

  private void take(final double distance, final int itsOrder, final Object3D itsObject, final Hit itsHit) {
    t = distance;
    order = itsOrder;
    object = itsObject;
    hit = itsHit;
  }

  /** Distance beyond which no hit can be closer. */
  double farthest() {
    return t * SAME;
  }

  /** The object that was hit; null if none. */
  Object3D object() {
    return object;
  }

  Hit hit() {
    if (object == null) {
      return Hit.NOHIT;
    }
    return hit != null ? hit : object.hitAt(ray, t, 0);
  }
}
