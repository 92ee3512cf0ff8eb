package lights;

import primitives.Point3D;
import radiometry.RadianceRGB;
import radiometry.SpectrumRGB;

/**
 * A point that shines equally in all directions: E = Φ / (4π d²) at the distance d &gt; 0. Source: Pharr, Jakob and
 * Humphreys, "Physically Based Rendering", 4th edition, 2023, section 12.2.
 *
 * <p><img src="doc-files/Omnidirectional.png" width="320" height="240" alt="A ball in the light of a point">
 */
public final class Omnidirectional extends Light {

  private final double x;
  private final double y;
  private final double z;

  /**
   * A point light.
   *
   * @param position where it is
   * @param spectrum how the power is shared among the channels
   * @param power emitted power, &gt; 0
   * @throws IllegalArgumentException if an argument is null or not finite, or if the power is not positive
   */
  public Omnidirectional(final Point3D position, final SpectrumRGB spectrum, final float power) {
    super(position, spectrum, power);
    this.x = position.x;
    this.y = position.y;
    this.z = position.z;
  }

  @Override
  public RadianceRGB getIrradianceAt(final Point3D P) {
    return irradianceAt(P);
  }

  @Override
  public boolean illuminate(final double px, final double py, final double pz, final Incidence incidence) {
    final boolean lit = incidence.aim(x - px, y - py, z - pz);
    spread(4 * Math.PI * incidence.distance() * incidence.distance(), incidence);
    return lit;
  }

  @Override
  public void illuminate(final int n, final double[] px, final double[] py, final double[] pz,
      final TileIncidence incidence) {
    incidence.radiate(x, y, z, getPower().getR(), getPower().getG(), getPower().getB(), n, px, py, pz);
  }

  @Override
  public String toString() {
    return "Omnidirectional(" + getPosition() + ", " + emission() + ")";
  }
}
