package models;

import static arguments.Arguments.notNull;

import java.awt.Color;

import primitives.Point3D;
import tracer.Hit;
import tracer.Ray;

/**
 * An object whose intersections are found by marching along the ray, each step no longer than a bound of the distance
 * to the surface.
 *
 * <p>A subclass implements {@link #SDF} and {@link #distanceUpperBound}, and {@link #intersectionWith} by calling
 * {@link #rayMarching}. Its accuracy is then limited by the floats that {@code SDF} takes and returns. The subclasses of
 * this package do better by overriding package-private methods: {@link #signedDistance}, in doubles; {@link #hitAt}, for
 * a closed form of the normal; or {@link #march} itself, for steps that take the direction of the ray into account, as
 * {@link Torus} and {@link Ellipsoid} do.
 *
 * <p>Source of the scheme: Hart, "Sphere tracing: a geometric method for the antialiased ray tracing of implicit
 * surfaces", The Visual Computer 12, 1996; of the longer steps: Keinert et al., "Enhanced Sphere Tracing", STAG 2014.
 */
abstract class ProceduralObject3D extends Object3D {

  /**
   * Fraction of the object's size within which a ray counts as in contact with the surface: there steps have a minimum
   * length, so that a march ends, and the sign of the distance decides instead of its value.
   */
  private static final double CONTACT = 0x1p-16;

  /** Relative rounding to float of the coordinates of a point and of its distance. */
  private static final double FLOAT_NOISE = 0x1p-22;

  /** Factor by which steps grow while the ray stays in contact, so that it can follow a flat face from end to end. */
  private static final double GROWTH = 1.25;

  /** Length of a step, in distances; a step is undone if the sphere around its end does not reach that around its start. */
  private static final double RELAXATION = 1.6;

  /**
   * More steps than any march with an upper bound can need: out of contact each is longer than {@link #CONTACT} times
   * the size, and none goes beyond the bound. It cuts off only marches along unbounded objects.
   */
  private static final int STEPS = 1 << 18;

  /** Fraction of the size over which the gradient of the distance is measured for the normal. */
  private static final double SLOPE_BASE = 0x1p-11;

  /**
   * An object of one colour.
   *
   * @param color its colour
   * @throws IllegalArgumentException if the colour is null
   */
  protected ProceduralObject3D(final Color color) {
    super(color);
  }

  /** An object of an appearance that has been checked. */
  ProceduralObject3D(final Appearance appearance) {
    super(appearance);
  }

  /**
   * Signed distance to the surface, or a lower bound of it.
   *
   * @param P a point of the scene
   * @return a number that is positive outside, negative inside, and whose absolute value is never above the true
   *     distance from P to the surface
   */
  protected abstract float SDF(Point3D P);

  /**
   * Upper bound of the distance to any point of the object.
   *
   * @param P a point of the scene
   * @return a distance; no point of the object is farther from P
   */
  protected abstract float distanceUpperBound(Point3D P);

  /**
   * Marches along a ray from its start to the first point of the surface: where the sign of {@link #SDF} changes.
   *
   * @param ray the ray; {@link Ray#NORAY} hits nothing
   * @return the intersection, or {@link Hit#NOHIT}
   * @throws IllegalArgumentException if the ray is null
   */
  protected Hit rayMarching(final Ray ray) {
    notNull("ray", ray);
    final double t = march(ray.startX(), ray.startY(), ray.startZ(),
        ray.directionX(), ray.directionY(), ray.directionZ());
    return Hit.isDistance(t) ? hitAt(ray, t, 0) : Hit.NOHIT;
  }

  /** {@link #SDF} in double; by default no more accurate than SDF and the floats of its point. */
  double signedDistance(final double x, final double y, final double z) {
    return SDF(new Point3D((float) x, (float) y, (float) z));
  }

  /**
   * The march: the distance at which a ray first hits the surface, or infinity. A ray that starts on the surface counts
   * as starting on the side that it is on a little farther ahead.
   */
  double march(final double x, final double y, final double z, final double dx, final double dy, final double dz) {
    final double end = upperBound(x, y, z), start = startOfMarch(x, y, z);
    final double side = side(x + start * dx, y + start * dy, z + start * dz);
    double t = start, last = start, free = 0, shortest = 0;
    boolean relaxed = false;
    for (int i = 0; i < STEPS && t <= end; i++) {
      final double px = x + t * dx, py = y + t * dy, pz = z + t * dz;
      final double distance = side * signedDistance(px, py, pz);
      if (relaxed && distance < t - last - free) {
        relaxed = false;
        t = last + free;
        continue;
      }
      if (!(distance >= 0)) {
        return distance < 0 ? crossing(last, t, side, x, y, z, dx, dy, dz) : Double.POSITIVE_INFINITY;
      }
      final double contact = contact(px, py, pz);
      relaxed = distance > contact;
      shortest = relaxed ? contact / 16 : shortest * GROWTH;
      shortest = shortest == 0 ? contact / 16 : shortest;
      last = t;
      free = distance;
      t += relaxed ? Math.max(distance, Math.min(RELAXATION * distance, end - t)) : Math.max(distance, shortest);
    }
    return Double.POSITIVE_INFINITY;
  }

  /** Where to begin: at the start, or, if that lies on the surface, just far enough ahead to determine the side. */
  private double startOfMarch(final double x, final double y, final double z) {
    final double contact = contact(x, y, z);
    return Math.abs(signedDistance(x, y, z)) <= contact / 16 ? contact : 0;
  }

  private double side(final double x, final double y, final double z) {
    return signedDistance(x, y, z) < 0 ? -1 : 1;
  }

  /** Distance to the surface that counts as contact; also for an unbounded object, which has no size. */
  private double contact(final double x, final double y, final double z) {
    final double noise = FLOAT_NOISE * Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
    final double size = upperBound(x, y, z);
    return size < Float.POSITIVE_INFINITY ? CONTACT * size + noise : noise;
  }

  private double upperBound(final double x, final double y, final double z) {
    return distanceUpperBound(new Point3D((float) x, (float) y, (float) z));
  }

  /** Where a ray crosses the surface between two points on either side of it, by bisection. */
  double crossing(final double before, final double after, final double side,
      final double x, final double y, final double z, final double dx, final double dy, final double dz) {
    double low = before, high = after;
    double middle = 0.5 * (low + high);
    while (low < middle && middle < high) {
      if (side * signedDistance(x + middle * dx, y + middle * dy, z + middle * dz) < 0) {
        high = middle;
      } else {
        low = middle;
      }
      middle = 0.5 * (low + high);
    }
    return high;
  }

  /** The hit at a distance known from the march; its normal is the gradient of the distance, by central differences. */
  @Override
  Hit hitAt(final Ray ray, final double t, final int part) {
    final double x = ray.startX() + t * ray.directionX(), y = ray.startY() + t * ray.directionY(),
        z = ray.startZ() + t * ray.directionZ();
    final double size = upperBound(x, y, z);
    final double base = size < Float.POSITIVE_INFINITY ? SLOPE_BASE * size : contact(x, y, z) / SLOPE_BASE;
    final float east = (float) (x + base), west = (float) (x - base), north = (float) (y + base),
        south = (float) (y - base), high = (float) (z + base), low = (float) (z - base);
    return Hit.of(t, x, y, z,
        (signedDistance(east, y, z) - signedDistance(west, y, z)) / ((double) east - west),
        (signedDistance(x, north, z) - signedDistance(x, south, z)) / ((double) north - south),
        (signedDistance(x, y, high) - signedDistance(x, y, low)) / ((double) high - low), this);
  }

  @Override
  int cost(final Ray ray) {
    return SphereTrace.along(ray, this).steps().size();
  }

  /** A distance rounded to the float next to it that does not exceed it. */
  static float roundedDown(final double distance) {
    final float rounded = (float) distance;
    return rounded > distance ? Math.nextDown(rounded) : rounded;
  }

  /** A distance rounded to the float next to it that is not below it. */
  static float roundedUp(final double distance) {
    final float rounded = (float) distance;
    return rounded < distance ? Math.nextUp(rounded) : rounded;
  }
}
