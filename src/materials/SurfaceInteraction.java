package materials;

import static arguments.Arguments.direction;
import static arguments.Arguments.notNull;

import primitives.Vector3D;
import radiometry.RadianceRGB;

/**
 * Light that falls on a surface and is scattered towards a viewer, in double: the normal n on the viewer's side, the unit
 * vectors wo towards the viewer and wi towards the light, the irradiance, and the resulting radiance. Mutable; a renderer
 * keeps one for each thread, sets normal and wo for each hit, wi and irradiance for each light, and lets the
 * {@link Material} write the radiance; so nothing is allocated.
 */
public final class SurfaceInteraction {

  private double nx;
  private double ny;
  private double nz;
  private double ox;
  private double oy;
  private double oz;
  private double ix;
  private double iy;
  private double iz;
  private boolean outside;
  private double cosineIn;
  private double cosineOut;
  private double irradianceR;
  private double irradianceG;
  private double irradianceB;
  private double radianceR;
  private double radianceG;
  private double radianceB;

  /** No directions yet. */
  public SurfaceInteraction() {
    // Filled by renderers.
  }

  /** The interaction of vectors of any length, for the public methods. */
  SurfaceInteraction(final RadianceRGB irradiance, final Vector3D wi, final Vector3D wo, final Vector3D n,
      final boolean outside) {
    notNull("irradiance", irradiance);
    final double in = length(direction("wi", wi)), out = length(direction("wo", wo)), normal = length(direction("n", n));
    setView(n.x / normal, n.y / normal, n.z / normal, wo.x / out, wo.y / out, wo.z / out, outside);
    setIncident(wi.x / in, wi.y / in, wi.z / in);
    setIrradiance(irradiance.getR(), irradiance.getG(), irradiance.getB());
  }

  private static double length(final Vector3D v) {
    return Math.sqrt((double) v.x * v.x + (double) v.y * v.y + (double) v.z * v.z);
  }

  /**
   * Sets the normal and the direction towards the viewer.
   *
   * @param nX first component of the unit normal on the viewer's side, n·wo &gt; 0
   * @param nY second component
   * @param nZ third component
   * @param oX first component of the unit vector wo
   * @param oY second component
   * @param oZ third component
   * @param isOutside whether the viewer is on the side of the surface's own normal
   */
  public void setView(final double nX, final double nY, final double nZ, final double oX, final double oY, final double oZ,
      final boolean isOutside) {
    nx = nX;
    ny = nY;
    nz = nZ;
    ox = oX;
    oy = oY;
    oz = oZ;
    outside = isOutside;
    cosineOut = nx * ox + ny * oy + nz * oz;
  }

  /**
   * Sets the direction towards the light. Where n·wi &lt; 0, the light is on the other side of the surface; where the
   * geometric normal disagrees with n, the renderer leaves the light out.
   *
   * @param iX first component of the unit vector wi
   * @param iY second component
   * @param iZ third component
   */
  public void setIncident(final double iX, final double iY, final double iZ) {
    ix = iX;
    iy = iY;
    iz = iZ;
    cosineIn = nx * ix + ny * iy + nz * iz;
  }

  /**
   * Sets the irradiance on the surface: that perpendicular to the incidence, times |n·wi|.
   *
   * @param r red, at least 0
   * @param g green
   * @param b blue
   */
  public void setIrradiance(final double r, final double g, final double b) {
    irradianceR = r;
    irradianceG = g;
    irradianceB = b;
  }

  /**
   * Sets the radiance towards the viewer; called by materials.
   *
   * @param r red, at least 0
   * @param g green
   * @param b blue
   */
  public void setRadiance(final double r, final double g, final double b) {
    radianceR = r;
    radianceG = g;
    radianceB = b;
  }

  /** Sets the radiance to the irradiance times the three values of f. */
  void scatter(final double r, final double g, final double b) {
    setRadiance(r * irradianceR, g * irradianceG, b * irradianceB);
  }

  /**
   * The cosine n·wi.
   *
   * @return from −1 to 1; negative for a light on the other side
   */
  public double cosineIn() {
    return cosineIn;
  }

  /**
   * The cosine n·wo.
   *
   * @return from −1 to 1
   */
  public double cosineOut() {
    return cosineOut;
  }

  /** The product wi·wo. */
  double cosineBetween() {
    return ix * ox + iy * oy + iz * oz;
  }

  /** The squared length |a wi + b wo|². */
  double length2(final double a, final double b) {
    final double x = a * ix + b * ox, y = a * iy + b * oy, z = a * iz + b * oz;
    return x * x + y * y + z * z;
  }

  /** The squared length |n × (a wi + b wo)|²: for a unit vector, sin² of its angle to n, without cancellation near n. */
  double cross2(final double a, final double b) {
    final double x = a * ix + b * ox, y = a * iy + b * oy, z = a * iz + b * oz;
    final double cx = ny * z - nz * y, cy = nz * x - nx * z, cz = nx * y - ny * x;
    return cx * cx + cy * cy + cz * cz;
  }

  boolean outside() {
    return outside;
  }

  RadianceRGB irradiance() {
    return new RadianceRGB(irradianceR, irradianceG, irradianceB);
  }

  RadianceRGB radiance() {
    return new RadianceRGB(radianceR, radianceG, radianceB);
  }

  Vector3D incident() {
    return new Vector3D((float) ix, (float) iy, (float) iz);
  }

  Vector3D outgoing() {
    return new Vector3D((float) ox, (float) oy, (float) oz);
  }

  Vector3D normal() {
    return new Vector3D((float) nx, (float) ny, (float) nz);
  }

  /**
   * Red radiance towards the viewer.
   *
   * @return the number, at least 0
   */
  public double radianceR() {
    return radianceR;
  }

  /**
   * Green radiance towards the viewer.
   *
   * @return the number, at least 0
   */
  public double radianceG() {
    return radianceG;
  }

  /**
   * Blue radiance towards the viewer.
   *
   * @return the number, at least 0
   */
  public double radianceB() {
    return radianceB;
  }
}
