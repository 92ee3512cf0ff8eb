package lights;

import primitives.Point3D;
import radiometry.RadianceRGB;
import radiometry.SpectrumRGB;

/** A light as a student would write it, which stays bounded near by. */
public class Candle extends Light {

  /** Position, spectrum and power. */
  public Candle(final Point3D S, final SpectrumRGB spectrum, final float power) {
    super(S, spectrum, power);
  }

  @Override
  public RadianceRGB getIrradianceAt(final Point3D P) {
    final float d = P.distance(getPosition());
    return getPower().times(1 / (4 * Math.PI * (1 + d * d * d)));
  }
}
