package models;

import java.math.BigDecimal;

import primitives.BoundingBox;

/**
 * Where a ray hits a triangle, without cracks between triangles that share an edge or a vertex.
 *
 * <p>Let A, B, C be the vertices less the start of the ray and d its direction. The ray's line passes on one side of the
 * edge BC or the other by the sign of d · (B × C), and it hits the triangle if the three signs do not differ; zero counts
 * as either. A triangle across the edge computes exactly the negated number, so a line cannot pass between the two.
 * Around a vertex that is not enough: there all the signs must come from one geometry. So a sign that rounding could have
 * changed is computed once more exactly, which is rare. The form by signed volumes is that of Davis, Davis, and
 * Amanatides as reported by Segura and Feito, "Algorithms to test ray-triangle intersection", WSCG 2001; the aim, though
 * not the method, is that of Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013; the filter
 * before exact arithmetic that of Shewchuk, "Adaptive Precision Floating-Point Arithmetic", 1997.
 *
 * <p>t = A·N / d·N with the normal N = (B − A) × (C − A), whose edges do not cancel as the volumes do.
 */
final class WatertightTest {

  /**
   * Bound of the error of d · (B × C), relative to the square of the greatest coordinate m of A, B and C: with u = 2^-53
   * a component of the product is wrong by at most 4 u m², the sum over a unit d of three of them by √3 (4 + 2 + 4) u m².
   */
  private static final double ERROR = 0x1p-48;

  private WatertightTest() {
  }

  /** Greatest error that a sign can have for vertices within a box, seen from a point. */
  static double error(final BoundingBox box, final double x, final double y, final double z) {
    return error(greatest(box, x, y, z));
  }

  /** Greatest coordinate of a point of a box, seen from a point. */
  static double greatest(final BoundingBox box, final double x, final double y, final double z) {
    final double a = Math.max(Math.abs(box.minX() - x), Math.abs(box.maxX() - x));
    final double b = Math.max(Math.abs(box.minY() - y), Math.abs(box.maxY() - y));
    final double c = Math.max(Math.abs(box.minZ() - z), Math.abs(box.maxZ() - z));
    return Math.max(a, Math.max(b, c));
  }

  /** Greatest error that a sign can have for vertices whose coordinates, less the start, are no greater than m. */
  static double error(final double m) {
    return ERROR * m * m;
  }

  /** Whether three numbers have no two different signs, whatever errors of the given size they have. */
  static boolean isInside(final double e, final double f, final double g, final double error) {
    return e > error && f > error && g > error || e < -error && f < -error && g < -error;
  }

  /** Whether two of three numbers have different signs, whatever errors of the given size they have. */
  static boolean isOutside(final double e, final double f, final double g, final double error) {
    return (e > error || f > error || g > error) && (e < -error || f < -error || g < -error);
  }

  /**
   * Distance at which a ray hits a triangle.
   *
   * @param error what {@link #error} returned for a box of the triangle
   * @return the t, negative if the triangle is behind the start; NaN if the line misses it or lies in its plane
   */
  static double distance(final double ax, final double ay, final double az,
      final double bx, final double by, final double bz, final double cx, final double cy, final double cz,
      final double dx, final double dy, final double dz, final double error) {
    final double e = volume(dx, dy, dz, bx, by, bz, cx, cy, cz);
    final double f = volume(dx, dy, dz, cx, cy, cz, ax, ay, az);
    final double g = volume(dx, dy, dz, ax, ay, az, bx, by, bz);
    if (isOutside(e, f, g, error)) {
      return Double.NaN;
    }
    if (!isInside(e, f, g, error) && !isInsideExactly(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz)) {
      return Double.NaN;
    }
    return planeDistance(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz);
  }

  /** d · (B × C). */
  private static double volume(final double dx, final double dy, final double dz,
      final double bx, final double by, final double bz, final double cx, final double cy, final double cz) {
    return dx * (by * cz - bz * cy) + dy * (bz * cx - bx * cz) + dz * (bx * cy - by * cx);
  }

  /** t of the plane of a triangle, by its normal. */
  static double planeDistance(final double ax, final double ay, final double az,
      final double bx, final double by, final double bz, final double cx, final double cy, final double cz,
      final double dx, final double dy, final double dz) {
    final double px = bx - ax, py = by - ay, pz = bz - az, qx = cx - ax, qy = cy - ay, qz = cz - az;
    final double nx = py * qz - pz * qy, ny = pz * qx - px * qz, nz = px * qy - py * qx;
    return (ax * nx + ay * ny + az * nz) / (dx * nx + dy * ny + dz * nz);
  }

  /** Whether the three signs, computed exactly, have no two different ones. */
  static boolean isInsideExactly(final double ax, final double ay, final double az,
      final double bx, final double by, final double bz, final double cx, final double cy, final double cz,
      final double dx, final double dy, final double dz) {
    if (!Double.isFinite(ax + ay + az + bx + by + bz + cx + cy + cz + dx + dy + dz)) {
      return false;
    }
    final BigDecimal[] a = exact(ax, ay, az), b = exact(bx, by, bz), c = exact(cx, cy, cz), d = exact(dx, dy, dz);
    final int e = sign(d, b, c), f = sign(d, c, a), g = sign(d, a, b);
    return e >= 0 && f >= 0 && g >= 0 || e <= 0 && f <= 0 && g <= 0;
  }

  private static BigDecimal[] exact(final double x, final double y, final double z) {
    return new BigDecimal[] {new BigDecimal(x), new BigDecimal(y), new BigDecimal(z)};
  }

  private static int sign(final BigDecimal[] d, final BigDecimal[] b, final BigDecimal[] c) {
    BigDecimal sum = BigDecimal.ZERO;
    for (int i = 0; i < 3; i++) {
      final int j = (i + 1) % 3, k = (i + 2) % 3;
      sum = sum.add(d[i].multiply(b[j].multiply(c[k]).subtract(b[k].multiply(c[j]))));
    }
    return sum.signum();
  }
}
