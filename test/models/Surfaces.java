package models;

import java.util.Random;

import primitives.Point3D;
import primitives.Vector3D;

/** Random rays about tori and ellipsoids, aimed by random points of their surfaces. */
final class Surfaces {

  private Surfaces() {
  }

  static RandomRays ofTorus(final Random random, final Point3D C, final Vector3D axis, final float R, final float r) {
    final double[] u = CrossingOracle.normalised(axis.x, axis.y, axis.z), i = perpendicular(u), k = RandomRays.cross(i, u);
    final double widest = r > R ? Math.acos(-(double) R / r) : Math.PI;
    return new RandomRays(random, C, axis, (double) R + r, () -> {
      final double around = 2 * Math.PI * random.nextDouble(), tube = widest * (2 * random.nextDouble() - 1);
      final double cos = Math.cos(tube), sin = Math.sin(tube), ca = Math.cos(around), sa = Math.sin(around);
      final double[] s = new double[6], c = {C.x, C.y, C.z};
      for (int n = 0; n < 3; n++) {
        final double out = ca * i[n] + sa * k[n];
        s[3 + n] = cos * out + sin * u[n];
        s[n] = c[n] + R * out + r * s[3 + n];
      }
      return s;
    });
  }

  static RandomRays ofEllipsoid(final Random random, final Point3D C, final Vector3D axis, final Vector3D aux,
      final float... radii) {
    final double[] i = CrossingOracle.normalised(axis.x, axis.y, axis.z);
    final double[] k = RandomRays.normalised(RandomRays.cross(i, new double[] {aux.x, aux.y, aux.z}));
    final double[] j = RandomRays.cross(k, i);
    final double size = Math.max(radii[0], Math.max(radii[1], radii[2]));
    return new RandomRays(random, C, axis, size, () -> {
      final double[] q = RandomRays.normalised(
          new double[] {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()});
      final double[] s = new double[6], c = {C.x, C.y, C.z}, g = new double[3];
      for (int n = 0; n < 3; n++) {
        s[n] = c[n] + radii[0] * q[0] * i[n] + radii[1] * q[1] * j[n] + radii[2] * q[2] * k[n];
        g[n] = q[0] / radii[0] * i[n] + q[1] / radii[1] * j[n] + q[2] / radii[2] * k[n];
      }
      System.arraycopy(RandomRays.normalised(g), 0, s, 3, 3);
      return s;
    });
  }

  private static double[] perpendicular(final double[] u) {
    final double[] other = Math.abs(u[0]) < 0.6 ? new double[] {1, 0, 0} : new double[] {0, 1, 0};
    return RandomRays.normalised(RandomRays.cross(u, other));
  }
}
