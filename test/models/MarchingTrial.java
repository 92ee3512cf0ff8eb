package models;

import static org.junit.jupiter.api.Assertions.assertTrue;

import tracer.Hit;
import tracer.Ray;

/** Compares a shape with its oracle, ray by ray: collects faults and the accuracy of the rest. */
final class MarchingTrial {

  private final Object3D shape;
  private final CrossingOracle oracle;

  int rays;
  int hits;
  int faults;
  String firstFault;
  double worstT;
  double worstNormal;

  MarchingTrial(final Object3D shape, final CrossingOracle oracle) {
    this.shape = shape;
    this.oracle = oracle;
  }

  /** Tries one ray; its hit is compared where the crossing is certain. */
  void ask(final Ray ray) {
    final Hit hit = shape.intersectionWith(ray);
    final double t = shape.distance(ray.startX(), ray.startY(), ray.startZ(),
        ray.directionX(), ray.directionY(), ray.directionZ());
    final double certain = oracle.firstCertain(ray);
    rays++;
    final String fault = oracle.fault(ray, t, certain);
    if (fault != null || hit.hits() && hit.getT() != (float) t || hit.hits() != Hit.isDistance(t)) {
      faults++;
      firstFault = firstFault == null ? shape + ", " + precise(ray) + ": " + fault + ", " + hit : firstFault;
      return;
    }
    if (hit.hits()) {
      hits++;
      measure(ray, t, certain, hit);
    }
  }

  private void measure(final Ray ray, final double t, final double certain, final Hit hit) {
    if (!(Math.abs(t - certain) <= oracle.tolerance(t))) {
      return;
    }
    worstT = Math.max(worstT, Math.abs(t - certain) / Math.max(oracle.size(), 1e-3 * t));
    final double x = ray.startX() + certain * ray.directionX(), y = ray.startY() + certain * ray.directionY(),
        z = ray.startZ() + certain * ray.directionZ();
    if (!oracle.isSmooth(x, y, z)) {
      return;
    }
    final double[] n = oracle.normal(x, y, z);
    worstNormal = Math.max(worstNormal, Math.max(Math.abs(hit.normalX() - n[0]),
        Math.max(Math.abs(hit.normalY() - n[1]), Math.abs(hit.normalZ() - n[2]))));
  }

  /**
   * Asserts that there were no faults, that the error of t was at most a fraction of the size, and that there were hits
   * and misses.
   */
  void assertExact(final double t, final double normal) {
    assertTrue(faults == 0 && worstT <= t && worstNormal <= normal, this::toString);
    assertTrue(hits > rays / 10, this::toString);
  }

  private static String precise(final Ray ray) {
    return "R = (" + ray.startX() + ", " + ray.startY() + ", " + ray.startZ() + "), v = (" + ray.directionX() + ", "
        + ray.directionY() + ", " + ray.directionZ() + ")";
  }

  @Override
  public String toString() {
    return rays + " rays, " + hits + " hits, " + faults + " faults, t off by " + worstT + " of the size, normal by "
        + worstNormal + (firstFault == null ? "" : ": " + firstFault);
  }
}
