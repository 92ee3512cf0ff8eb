package materials;

import primitives.Vector3D;
import radiometry.RadianceRGB;
import radiometry.ReflectanceRGB;

/** A material as a student would write it: three steps of brightness. */
public class Toon extends BRDF {
  private final ReflectanceRGB k;

  /** The reflectance. */
  public Toon(final ReflectanceRGB k) {
    this.k = k;
  }

  @Override
  public RadianceRGB reflect(final RadianceRGB E, final Vector3D wi, final Vector3D wo, final Vector3D n) {
    final double c = n.dot(wi);
    return E.times(k).times(Math.ceil(3 * c) / (3 * c) / Math.PI);
  }
}
