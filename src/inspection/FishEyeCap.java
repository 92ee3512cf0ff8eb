package inspection;

import java.util.Optional;

import view.FishEye;
import view.Angular;
import view.Projection;

/**
 * The part of a sphere about the camera through which a fish-eye looks. Over each point of the window that is within the rim
 * lies one of the cap; the window is where the rim is.
 *
 * @param rim radius of the rim
 * @param rimName what that is, as a formula of the opening ω
 * @param radius2 square of the radius of the sphere
 * @param radius2Name what that is, as a formula of the opening ω
 */
record FishEyeCap(double rim, String rimName, double radius2, String radius2Name) {

  /** The cap of a projection; empty if it is no fish-eye. */
  static Optional<FishEyeCap> of(final Projection projection) {
    final double rim = projection.getWidth() / 2.0;
    if (projection instanceof Angular) {
      return Optional.of(new FishEyeCap(rim, "tan(ω/2)", 1 + rim * rim, "1/cos²(ω/2)"));
    }
    return projection instanceof FishEye ? Optional.of(new FishEyeCap(rim, "sin(ω/2)", 1, "1")) : Optional.empty();
  }

  /** z of the cap in the camera's frame at a distance from its z axis, at most that of the rim but for rounding. */
  double z(final double rho) {
    return -Math.sqrt(Math.max(0, radius2 - rho * rho));
  }
}
