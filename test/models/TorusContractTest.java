package models;

import java.awt.Color;

/** The laws for a torus; its accuracy in difficult cases is tested separately. */
class TorusContractTest implements Object3DContract {

  @Override
  public Object3D shape(final RandomPlacement at) {
    return new Torus(at.point(-1, 2, 0.5), at.direction(1, 2, 2), at.length(2), at.length(0.75f), Color.RED);
  }

  @Override
  public double signedDistance(final double x, final double y, final double z) {
    final double px = x + 1, py = y - 2, pz = z - 0.5, h = (px + 2 * py + 2 * pz) / 3;
    final double rho = Math.sqrt(Math.max(0, px * px + py * py + pz * pz - h * h));
    return Math.hypot(rho - 2, h) - 0.75;
  }

  @Override
  public double accuracy() {
    return 1e-8;
  }
}
