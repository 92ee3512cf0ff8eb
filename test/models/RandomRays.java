package models;

import java.util.Random;
import java.util.function.Supplier;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;

/** Rays of every kind about a closed shape: from outside, from inside, grazing, along its axis, from afar, and so on. */
final class RandomRays {

  /** The kinds of rays of {@link #next}. */
  enum Kind {
    OUTSIDE, AT_SURFACE, INSIDE, TANGENT, GRAZING, NEAR, ON_SURFACE, PARALLEL, IN_PLANE, NEAR_AXIS, FAR, FAR_GRAZING
  }

  private final Random random;
  private final double[] centre;
  private final double[] axis;
  private final double size;
  private final Supplier<double[]> surface;

  /**
   * Rays for a shape.
   *
   * @param size radius of a sphere about the shape
   * @param surface gives random points of the surface, each with its outward normal: six numbers
   */
  RandomRays(final Random random, final Point3D C, final Vector3D axis, final double size,
      final Supplier<double[]> surface) {
    this.random = random;
    this.centre = new double[] {C.x, C.y, C.z};
    this.axis = new double[] {axis.x, axis.y, axis.z};
    this.size = size;
    this.surface = surface;
  }

  /** A random point of the surface with its outward normal: six numbers. */
  double[] surfacePoint() {
    return surface.get();
  }

  /** A ray; its numbers are floats or, every other time, doubles. */
  Ray next(final Kind kind) {
    final double[] s = surface.get(), n = {s[3], s[4], s[5]};
    final double[] tangent = normalised(cross(n, direction()));
    final double small = Math.pow(10, -12 * random.nextDouble()), away = size * Math.pow(10, 2 * random.nextDouble() - 1);
    final double far = size * Math.pow(10, 1 + 5 * random.nextDouble()), sign = random.nextBoolean() ? 1 : -1;
    switch (kind) {
      case OUTSIDE: return towards(plus(centre, direction(), 1.5 * size), plus(centre, direction(), size));
      case AT_SURFACE: return towards(plus(centre, direction(), away + size), s);
      case INSIDE: return along(plus(s, n, -size * small), direction());
      case TANGENT: return along(plus(plus(s, n, sign * small * size), tangent, -away), tangent);
      case GRAZING: return along(plus(s, tangent, -away), plus(tangent, n, sign * small));
      case NEAR: return along(plus(s, n, sign * small * size), direction());
      case ON_SURFACE: return along(s, random.nextBoolean() ? direction() : tangent);
      case PARALLEL: return along(plus(s, n, size * random.nextDouble() * sign), axis);
      case IN_PLANE: return along(plus(centre, cross(axis, direction()), 2 * size), cross(axis, direction()));
      case NEAR_AXIS: return towards(plus(plus(centre, direction(), small * size), axis, sign * away),
          plus(centre, direction(), small * size));
      case FAR: return towards(plus(centre, direction(), far), plus(centre, direction(), size));
      default: return along(plus(plus(s, n, sign * small * size), tangent, -far), tangent);
    }
  }

  private Ray towards(final double[] from, final double[] to) {
    return along(from, plus(to, from, -1));
  }

  private Ray along(final double[] from, final double[] v) {
    final double[] d = normalised(v);
    return random.nextBoolean() ? Ray.exactly(from[0], from[1], from[2], d[0], d[1], d[2])
        : Ray.towards(from[0], from[1], from[2], v[0], v[1], v[2]);
  }

  /** A random unit vector. */
  double[] direction() {
    return normalised(new double[] {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()});
  }

  private static double[] plus(final double[] p, final double[] v, final double factor) {
    return new double[] {p[0] + factor * v[0], p[1] + factor * v[1], p[2] + factor * v[2]};
  }

  static double[] cross(final double[] a, final double[] b) {
    return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  static double[] normalised(final double[] v) {
    return CrossingOracle.normalised(v[0], v[1], v[2]);
  }
}
