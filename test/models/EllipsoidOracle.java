package models;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;

/** Where a ray crosses an ellipsoid: the roots of |q|² = 1 for the ray taken to the unit ball. */
final class EllipsoidOracle extends CrossingOracle {

  private final DoubleDouble[] centre;
  private final DoubleDouble[][] rows = new DoubleDouble[3][];

  EllipsoidOracle(final Point3D C, final Vector3D i, final Vector3D aux, final float... radii) {
    super(Math.max(radii[0], Math.max(radii[1], radii[2])));
    this.centre = exact(C);
    final DoubleDouble[] a = unit(i), c = unit(cross(a, exact(aux))), b = cross(c, a);
    final DoubleDouble[][] axes = {a, b, c};
    for (int n = 0; n < 3; n++) {
      final DoubleDouble radius = DoubleDouble.of(radii[n]);
      rows[n] = new DoubleDouble[] {axes[n][0].over(radius), axes[n][1].over(radius), axes[n][2].over(radius)};
    }
  }

  private static DoubleDouble[] cross(final DoubleDouble[] a, final DoubleDouble[] b) {
    return new DoubleDouble[] {a[1].times(b[2]).minus(a[2].times(b[1])), a[2].times(b[0]).minus(a[0].times(b[2])),
        a[0].times(b[1]).minus(a[1].times(b[0]))};
  }

  private DoubleDouble[] toBall(final DoubleDouble[] v) {
    return new DoubleDouble[] {DoubleDouble.dot(rows[0], v), DoubleDouble.dot(rows[1], v), DoubleDouble.dot(rows[2], v)};
  }

  @Override
  double[] crossings(final Ray ray) {
    final DoubleDouble[] d = direction(ray), l = minus(start(ray), centre);
    final double closest = -DoubleDouble.dot(l, d).high();
    final DoubleDouble[] p = ahead(l, d, closest);
    final DoubleDouble[] q = toBall(p), v = toBall(d);
    final double[] roots = PolynomialRoots.within(2 * size(), DoubleDouble.dot(q, q).minus(DoubleDouble.of(1)),
        DoubleDouble.dot(q, v).times(2), DoubleDouble.dot(v, v));
    for (int n = 0; n < roots.length; n++) {
      roots[n] += closest;
    }
    return roots;
  }

  private double[] inBall(final double x, final double y, final double z) {
    final double px = x - centre[0].high(), py = y - centre[1].high(), pz = z - centre[2].high();
    final double[] q = new double[3];
    for (int n = 0; n < 3; n++) {
      q[n] = rows[n][0].high() * px + rows[n][1].high() * py + rows[n][2].high() * pz;
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
        g[n] += q[m] * rows[m][n].high();
      }
    }
    return g;
  }

  private static double length(final double[] g) {
    return Math.sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
  }
}
