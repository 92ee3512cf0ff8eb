package models;

import java.util.Arrays;

import org.apache.commons.numbers.core.DD;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;

/**
 * Where a ray crosses a torus, by the roots of a quartic: with D the distance to the ring and E that to its farthest
 * point, (D² − r²)(E² − r²) = (|p|² + R² − r²)² − 4 R² ρ². Of a torus with r &gt; R the roots with E = r, where
 * |p|² + R² &lt; r², are within the solid and do not count.
 */
final class TorusOracle extends CrossingOracle {

  private final DD[] centre;
  private final DD[] axis;
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
    final DD[] d = direction(ray), l = minus(start(ray), centre);
    final double closest = -dot(l, d).hi();
    final DD[] p = ahead(l, d, closest);
    final DD h = dot(p, axis), slope = dot(d, axis);
    final DD p2 = dot(p, p), pd = dot(p, d), d2 = dot(d, d);
    final DD R2 = DD.ofProduct(R, R), g = p2.add(R2).subtract(DD.ofProduct(r, r));
    final DD four = R2.multiply(4);
    final double[] roots = PolynomialRoots.within(2 * size(),
        g.multiply(g).subtract(four.multiply(p2.subtract(h.multiply(h)))),
        g.multiply(pd).multiply(4).subtract(four.multiply(pd.subtract(h.multiply(slope))).multiply(2)),
        g.multiply(d2).multiply(2).add(pd.multiply(pd).multiply(4))
            .subtract(four.multiply(d2.subtract(slope.multiply(slope)))),
        d2.multiply(pd).multiply(4), d2.multiply(d2));
    return Arrays.stream(roots)
        .filter(t -> g.add(pd.multiply(2 * t)).add(d2.multiply(t).multiply(t)).hi() >= 0).map(t -> t + closest).toArray();
  }

  @Override
  double signedDistance(final double x, final double y, final double z) {
    final double[] v = fromCentre(x, y, z);
    return Math.sqrt((v[0] - R) * (v[0] - R) + v[1] * v[1]) - r;
  }

  @Override
  double[] normal(final double x, final double y, final double z) {
    final double px = x - centre[0].hi(), py = y - centre[1].hi(), pz = z - centre[2].hi();
    final double[] u = {axis[0].hi(), axis[1].hi(), axis[2].hi()};
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
    final double px = x - centre[0].hi(), py = y - centre[1].hi(), pz = z - centre[2].hi();
    final double h = px * axis[0].hi() + py * axis[1].hi() + pz * axis[2].hi();
    final double qx = px - h * axis[0].hi(), qy = py - h * axis[1].hi(), qz = pz - h * axis[2].hi();
    return new double[] {Math.sqrt(qx * qx + qy * qy + qz * qz), h};
  }
}
