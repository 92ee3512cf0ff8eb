package models;

import java.util.Arrays;

import javax.vecmath.Tuple3f;

import org.apache.commons.numbers.core.DD;

import tracer.Ray;

/**
 * Judges the intersections of a closed shape by all crossings of the ray with its surface, computed independently and
 * with more digits than doubles have.
 *
 * <p>Closer to the surface than a margin, some 1e-8 of the size of the shape, rounding decides: it may count as hitting a
 * surface that it passes at that distance, and as missing one into which it dips no deeper.
 */
abstract class CrossingOracle {

  /** The margin, relative to the size. */
  private static final double MARGIN = 0x1p-27;

  /** The margin, relative to the coordinates of the start. */
  private static final double FAR_MARGIN = 0x1p-50;

  private final double size;

  /** An oracle for a shape within a sphere of the given radius. */
  CrossingOracle(final double size) {
    this.size = size;
  }

  /** All distances along the ray's line, also behind its start, at which it crosses the surface, in order. */
  abstract double[] crossings(Ray ray);

  /** Signed distance of a point from the surface, at least near the surface; the sign is right everywhere. */
  abstract double signedDistance(double x, double y, double z);

  /** Outward unit normal at a point of the surface. */
  abstract double[] normal(double x, double y, double z);

  /** Whether the normal is the same all around a point of the surface, within the tolerance of t. */
  abstract boolean isSmooth(double x, double y, double z);

  double size() {
    return size;
  }

  /**
   * The first crossing ahead that must be found: the end of the first stretch of the ray, inside or outside, that gets
   * farther from the surface than the margin, if the next such stretch is on the other side. Infinity if none.
   */
  double firstCertain(final Ray ray) {
    return firstCertain(ray, margin(ray));
  }

  /** The same with a margin given as a length. */
  double firstCertain(final Ray ray, final double margin) {
    final double[] ahead = Arrays.stream(crossings(ray)).filter(t -> t > 0).toArray();
    double from = 0;
    int side = 0;
    for (int i = 0; i <= ahead.length; i++) {
      final double to = i < ahead.length ? ahead[i] : from + 4 * size;
      final double way = greatestDistance(ray, from, to);
      if (Math.abs(way) > margin) {
        if (side * way < 0) {
          return from;
        }
        side = (int) Math.signum(way);
      }
      from = to;
    }
    return Double.POSITIVE_INFINITY;
  }

  private double greatestDistance(final Ray ray, final double from, final double to) {
    double greatest = 0;
    for (int i = 0; i <= 16; i++) {
      final double distance = distanceAt(ray, from + (to - from) * i / 16);
      greatest = Math.abs(distance) > Math.abs(greatest) ? distance : greatest;
    }
    return greatest;
  }

  double distanceAt(final Ray ray, final double t) {
    return signedDistance(ray.startX() + t * ray.directionX(), ray.startY() + t * ray.directionY(),
        ray.startZ() + t * ray.directionZ());
  }

  double margin(final Ray ray) {
    final double start = Math.abs(ray.startX()) + Math.abs(ray.startY()) + Math.abs(ray.startZ());
    return MARGIN * size + FAR_MARGIN * start;
  }

  /**
   * The fault of a distance found for a ray; null if it is right.
   *
   * @param t the distance; infinity says that the ray misses
   * @param certain {@link #firstCertain} of the ray
   */
  String fault(final Ray ray, final double t, final double certain) {
    if (t > certain + tolerance(certain)) {
      return "passes the crossing at " + certain + ": " + t;
    }
    if (t < Double.POSITIVE_INFINITY && !(Math.abs(t - certain) <= tolerance(t))
        && !(t > 0 && Math.abs(distanceAt(ray, t)) <= margin(ray))) {
      return t + " is not on the surface, which is first crossed at " + certain;
    }
    return Double.isNaN(t) ? "NaN" : null;
  }

  double tolerance(final double t) {
    return 0x1p-22 * size + 0x1p-36 * t;
  }

  static DD[] exact(final Tuple3f v) {
    return new DD[] {DD.of(v.x), DD.of(v.y), DD.of(v.z)};
  }

  static DD[] start(final Ray ray) {
    return new DD[] {
        DD.of(ray.startX()), DD.of(ray.startY()), DD.of(ray.startZ())};
  }

  static DD[] direction(final Ray ray) {
    return new DD[] {
        DD.of(ray.directionX()), DD.of(ray.directionY()), DD.of(ray.directionZ())};
  }

  static DD[] minus(final DD[] a, final DD[] b) {
    return new DD[] {a[0].subtract(b[0]), a[1].subtract(b[1]), a[2].subtract(b[2])};
  }

  static DD[] ahead(final DD[] p, final DD[] d, final double t) {
    return new DD[] {p[0].add(d[0].multiply(t)), p[1].add(d[1].multiply(t)), p[2].add(d[2].multiply(t))};
  }

  static DD dot(final DD[] a, final DD[] b) {
    return a[0].multiply(b[0]).add(a[1].multiply(b[1])).add(a[2].multiply(b[2]));
  }

  static DD[] unit(final Tuple3f v) {
    return unit(exact(v));
  }

  static DD[] unit(final DD[] v) {
    final DD length = dot(v, v).sqrt();
    return new DD[] {v[0].divide(length), v[1].divide(length), v[2].divide(length)};
  }

  static double[] normalised(final double x, final double y, final double z) {
    final double length = Math.sqrt(x * x + y * y + z * z);
    return new double[] {x / length, y / length, z / length};
  }
}
