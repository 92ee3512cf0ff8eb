package models;

import java.util.Arrays;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;

/**
 * Where a ray crosses a torus, by the roots of a quartic: with D the distance to the ring and E that to its farthest
 * point, (D² − r²)(E² − r²) = (|p|² + R² − r²)² − 4 R² ρ². Of a torus with r &gt; R the roots with E = r, where
 * |p|² + R² &lt; r², are within the solid and do not count.
 */
final class TorusOracle extends CrossingOracle {

  private final DoubleDouble[] centre;
  private final DoubleDouble[] axis;
  private final double R;
  private final double r;

  TorusOracle(final Point3D C, final Vector3D axis, final float R, final float r) {
    super((double) R + r);
    this.centre = exact(C);
    this.axis = unit(axis);
    this.R = R;
    this.r = r;
  }

  @Override
  double[] crossings(final Ray ray) {
    final DoubleDouble[] d = direction(ray), l = minus(start(ray), centre);
    final double closest = -DoubleDouble.dot(l, d).high();
    final DoubleDouble[] p = ahead(l, d, closest);
    final DoubleDouble h = DoubleDouble.dot(p, axis), slope = DoubleDouble.dot(d, axis);
    final DoubleDouble p2 = DoubleDouble.dot(p, p), pd = DoubleDouble.dot(p, d), d2 = DoubleDouble.dot(d, d);
    final DoubleDouble R2 = DoubleDouble.product(R, R), g = p2.plus(R2).minus(DoubleDouble.product(r, r));
    final DoubleDouble four = R2.times(4);
    final double[] roots = PolynomialRoots.within(2 * size(),
        g.times(g).minus(four.times(p2.minus(h.times(h)))),
        g.times(pd).times(4).minus(four.times(pd.minus(h.times(slope))).times(2)),
        g.times(d2).times(2).plus(pd.times(pd).times(4)).minus(four.times(d2.minus(slope.times(slope)))),
        d2.times(pd).times(4), d2.times(d2));
    return Arrays.stream(roots).filter(t -> g.plus(pd.times(2 * t)).plus(d2.times(t).times(t)).sign() >= 0)
        .map(t -> t + closest).toArray();
  }

  @Override
  double signedDistance(final double x, final double y, final double z) {
    final double[] v = fromCentre(x, y, z);
    return Math.sqrt((v[0] - R) * (v[0] - R) + v[1] * v[1]) - r;
  }

  @Override
  double[] normal(final double x, final double y, final double z) {
    final double px = x - centre[0].high(), py = y - centre[1].high(), pz = z - centre[2].high();
    final double[] u = {axis[0].high(), axis[1].high(), axis[2].high()};
    final double h = px * u[0] + py * u[1] + pz * u[2];
    final double qx = px - h * u[0], qy = py - h * u[1], qz = pz - h * u[2];
    final double k = R / Math.sqrt(qx * qx + qy * qy + qz * qz);
    return normalised(px - k * qx, py - k * qy, pz - k * qz);
  }

  /** Not so next to the cusps that a torus without a hole has on its axis. */
  @Override
  boolean isSmooth(final double x, final double y, final double z) {
    return fromCentre(x, y, z)[0] > 0x1p-12 * size();
  }

  /** Distance from the axis and height of a point. */
  private double[] fromCentre(final double x, final double y, final double z) {
    final double px = x - centre[0].high(), py = y - centre[1].high(), pz = z - centre[2].high();
    final double h = px * axis[0].high() + py * axis[1].high() + pz * axis[2].high();
    final double qx = px - h * axis[0].high(), qy = py - h * axis[1].high(), qz = pz - h * axis[2].high();
    return new double[] {Math.sqrt(qx * qx + qy * qy + qz * qz), h};
  }
}
