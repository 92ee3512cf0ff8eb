package models;

import org.apache.commons.numbers.core.DD;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;

/** Where a ray crosses an ellipsoid: the roots of |q|² = 1 for the ray transformed to the unit ball. */
final class EllipsoidOracle extends CrossingOracle {

  private final DD[] centre;
  private final DD[][] rows = new DD[3][];

  EllipsoidOracle(final Point3D C, final Vector3D i, final Vector3D aux, final float... radii) {
    super(Math.max(radii[0], Math.max(radii[1], radii[2])));
    this.centre = exact(C);
    final DD[] a = unit(i), c = unit(cross(a, exact(aux))), b = cross(c, a);
    final DD[][] axes = {a, b, c};
    for (int n = 0; n < 3; n++) {
      final DD radius = DD.of(radii[n]);
      rows[n] = new DD[] {axes[n][0].divide(radius), axes[n][1].divide(radius), axes[n][2].divide(radius)};
    }
  }

  private static DD[] cross(final DD[] a, final DD[] b) {
    return new DD[] {a[1].multiply(b[2]).subtract(a[2].multiply(b[1])), a[2].multiply(b[0]).subtract(a[0].multiply(b[2])),
        a[0].multiply(b[1]).subtract(a[1].multiply(b[0]))};
  }

  private DD[] toBall(final DD[] v) {
    return new DD[] {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
  }

  @Override
  double[] crossings(final Ray ray) {
    final DD[] d = direction(ray), l = minus(start(ray), centre);
    final double closest = -dot(l, d).hi();
    final DD[] p = ahead(l, d, closest);
    final DD[] q = toBall(p), v = toBall(d);
    final double[] roots = PolynomialRoots.within(2 * size(), dot(q, q).subtract(DD.of(1)),
        dot(q, v).multiply(2), dot(v, v));
    for (int n = 0; n < roots.length; n++) {
      roots[n] += closest;
    }
    return roots;
  }

  private double[] inBall(final double x, final double y, final double z) {
    final double px = x - centre[0].hi(), py = y - centre[1].hi(), pz = z - centre[2].hi();
    final double[] q = new double[3];
    for (int n = 0; n < 3; n++) {
      q[n] = rows[n][0].hi() * px + rows[n][1].hi() * py + rows[n][2].hi() * pz;
    }
    return q;
  }

  /** To first order: (|q|² − 1) over its slope. */
  @Override
  double signedDistance(final double x, final double y, final double z) {
    final double[] q = inBall(x, y, z);
    final double excess = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] - 1, slope = 2 * length(gradient(q));
    return excess / Math.max(slope, 1 / size());
  }

  @Override
  double[] normal(final double x, final double y, final double z) {
    final double[] g = gradient(inBall(x, y, z));
    return normalised(g[0], g[1], g[2]);
  }

  @Override
  boolean isSmooth(final double x, final double y, final double z) {
    return true;
  }

  private double[] gradient(final double[] q) {
    final double[] g = new double[3];
    for (int n = 0; n < 3; n++) {
      for (int m = 0; m < 3; m++) {
        g[n] += q[m] * rows[m][n].hi();
      }
    }
    return g;
  }

  private static double length(final double[] g) {
    return Math.sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
  }
}
