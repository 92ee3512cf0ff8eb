package lights;

import static arguments.Arguments.wrong;

import primitives.Point3D;
import radiometry.RadianceRGB;
import radiometry.SpectrumRGB;

/**
 * A point that shines equally in all directions of a cone, and nowhere else: E = Φ / (Ω d²), Ω = 4π sin²(A/2), for points
 * whose direction from the light is within the angle A of the axis. Source: Pharr, Jakob and Humphreys, "Physically Based
 * Rendering", 4th edition, 2023, section 12.2.
 *
 * <p><img src="doc-files/Spot.png" width="320" height="240" alt="A ball in the cone of a spotlight">
 */
public final class Spot extends Light {

  private final Point3D lookAt;
  private final float aperture;
  private final Axis axis;
  private final double x;
  private final double y;
  private final double z;
  private final double sine;
  private final double cosine;
  private final double solidAngle;

  /**
   * A spotlight.
   *
   * @param position apex of the cone
   * @param lookAt a point of its axis, other than the position
   * @param aperture angle between the axis and the edge in degrees, half of the whole opening; 0 &lt; aperture ≤ 90
   * @param spectrum how the power is shared among the channels
   * @param power emitted power, &gt; 0
   * @throws IllegalArgumentException if an argument is null or not finite, if both points are equal, if the aperture is not
   *     in (0, 90], or if the power is not positive
   */
  public Spot(final Point3D position, final Point3D lookAt, final float aperture, final SpectrumRGB spectrum,
      final float power) {
    super(position, spectrum, power);
    this.x = position.x;
    this.y = position.y;
    this.z = position.z;
    this.axis = new Axis(position, lookAt);
    this.lookAt = new Point3D(lookAt);
    if (!(aperture > 0 && aperture <= 90)) {
      throw wrong("aperture", aperture);
    }
    this.aperture = aperture;
    final double angle = Math.toRadians(aperture), half = Math.sin(angle / 2);
    this.sine = Math.sin(angle);
    this.cosine = Math.cos(angle);
    this.solidAngle = 4 * Math.PI * half * half;
  }

  @Override
  public RadianceRGB getIrradianceAt(final Point3D P) {
    return irradianceAt(P);
  }

  @Override
  public boolean illuminate(final double px, final double py, final double pz, final Incidence incidence) {
    final boolean apart = incidence.aim(x - px, y - py, z - pz);
    final double d = incidence.distance();
    spread(solidAngle * d * d, incidence);
    return apart && axis.beside(px, py, pz) * cosine - axis.ahead(px, py, pz) * sine <= Axis.EDGE * d;
  }

  @Override
  public String toString() {
    return "Spot(" + getPosition() + ", lookAt=" + lookAt + ", aperture=" + aperture + ", " + emission() + ")";
  }
}
