package models;

import java.awt.Color;

/** The laws for an ellipsoid; how exact it is in its harder places is the matter of a test of its own. */
class EllipsoidContractTest implements Object3DContract {

  @Override
  public Object3D shape(final Placement at) {
    return new Ellipsoid(at.point(1, 1, -2), at.direction(2, 2, 1), at.direction(-2, 1, 0), at.length(3), at.length(1),
        at.length(1.5f), Color.RED);
  }

  /** i = (2, 2, 1)/3; k = i × (−2, 1, 0) normalised = (−1, −2, 6)/√41; j = k × i. */
  @Override
  public double signedDistance(final double x, final double y, final double z) {
    final double px = x - 1, py = y - 1, pz = z + 2, s = Math.sqrt(41), kx = -1 / s, ky = -2 / s, kz = 6 / s;
    final double jx = (ky - 2 * kz) / 3, jy = (2 * kz - kx) / 3, jz = (2 * kx - 2 * ky) / 3;
    final double a = (2 * px + 2 * py + pz) / 9, b = jx * px + jy * py + jz * pz, c = (kx * px + ky * py + kz * pz) / 1.5;
    final double k = Math.sqrt(a * a + b * b + c * c), g = Math.sqrt(a * a / 9 + b * b + c * c / 2.25);
    return k < 0.01 ? -0.9 : k * (k - 1) / g;
  }

  @Override
  public double accuracy() {
    return 1e-8;
  }
}
