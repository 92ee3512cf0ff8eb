package inspection;

import java.util.Optional;

import view.Angular;
import view.FishEye;
import view.Projection;

/**
 * The spherical cap through which a fish-eye looks. The window lies in the plane of the cap's rim; each point of the window
 * inside the rim is projected onto the cap along z.
 *
 * @param projection the fish-eye
 * @param rim radius of the rim
 * @param rimName that radius as a formula in the opening ω
 * @param radius2 square of the radius of the sphere
 * @param radius2Name that square as a formula in the opening ω
 */
record FishEyeCap(Projection projection, double rim, String rimName, double radius2, String radius2Name) {

  /** Part of the rim's radius up to which points are inside it, although the radius is rounded to floats. */
  private static final double INSIDE = 1 - 0x1p-23;

  /** The cap of a projection; empty if it is not a fish-eye. */
  static Optional<FishEyeCap> of(final Projection projection) {
    final double rim = projection.getWidth() / 2.0;
    if (projection instanceof Angular) {
      return Optional.of(new FishEyeCap(projection, rim, "tan(ω/2)", 1 + rim * rim, "1/cos²(ω/2)"));
    }
    return projection instanceof FishEye ? Optional.of(new FishEyeCap(projection, rim, "sin(ω/2)", 1, "1"))
        : Optional.empty();
  }

  /** z of the cap in the camera's frame at distance rho from the z axis, 0 &lt;= rho &lt;= rim up to rounding. */
  double z(final double rho) {
    final double z = projection.zAt(rho, 0);
    return Double.isNaN(z) ? projection.zAt(INSIDE * rho, 0) : z;
  }
}
