package lights;

import static arguments.Arguments.finite;
import static arguments.Arguments.notNull;
import static arguments.Arguments.positive;
import static arguments.Arguments.wrongState;

import primitives.Point3D;
import primitives.Vector3D;
import radiometry.RadianceRGB;
import radiometry.SpectrumRGB;

/**
 * A source of light with a position and a power. A new kind of light extends this class and implements
 * {@link #getIrradianceAt}: see {@link lights}.
 */
public abstract class Light {

  /** Limit of irradiances: far beyond any picture, and products with materials do not overflow. */
  static final double LARGEST = 0x1p600;

  private final float x;
  private final float y;
  private final float z;
  private final SpectrumRGB spectrum;
  private final float power;
  private final RadianceRGB channels;

  /**
   * A light.
   *
   * @param position its position
   * @param spectrum how the power is shared among the channels
   * @param power emitted power, &gt; 0
   * @throws IllegalArgumentException if an argument is null or not finite, or if the power is not positive
   */
  protected Light(final Point3D position, final SpectrumRGB spectrum, final float power) {
    this.x = finite("position", position).x;
    this.y = position.y;
    this.z = position.z;
    this.spectrum = notNull("spectrum", spectrum);
    this.power = positive("power", power);
    this.channels = spectrum.distribute(power);
  }

  /**
   * Position of the light.
   *
   * @return a new point
   */
  public Point3D getPosition() {
    return new Point3D(x, y, z);
  }

  /**
   * The power in each channel.
   *
   * @return 3 · share · power, so that white light has the power in each
   */
  public RadianceRGB getPower() {
    return channels;
  }

  /**
   * The irradiance of this light at a point, perpendicular to the direction from which it comes, as if nothing blocked
   * it.
   *
   * @param P the point
   * @return the irradiance, {@link RadianceRGB#NORADIANCE} outside the field of the light; never null
   * @throws IllegalArgumentException if P is null
   */
  public abstract RadianceRGB getIrradianceAt(Point3D P);

  /**
   * The point from which a point is lit. Objects between the two cast a shadow.
   *
   * @param P the point
   * @return a new point; by default the position of the light
   * @throws IllegalArgumentException if P is null
   */
  public Point3D getPosition(final Point3D P) {
    notNull("P", P);
    return getPosition();
  }

  /**
   * The direction towards the light.
   *
   * @param P a point
   * @return a new vector of unit length from P to {@link #getPosition(Point3D)}; the zero vector if they coincide
   * @throws IllegalArgumentException if P is null
   */
  public final Vector3D getIncidenceDirection(final Point3D P) {
    notNull("P", P);
    final Incidence incidence = new Incidence();
    final boolean apart = direct(P.x, P.y, P.z, incidence);
    return !apart ? new Vector3D()
        : new Vector3D((float) incidence.directionX(), (float) incidence.directionY(), (float) incidence.directionZ());
  }

  /**
   * For renderers: irradiance, direction and distance of this light at a point, without allocation by the lights of this
   * package. The default calls {@link #getIrradianceAt} and {@link #getPosition(Point3D)}.
   *
   * @param px first coordinate of the point
   * @param py second coordinate
   * @param pz third coordinate
   * @param incidence what the result is written to; unspecified if the result is false
   * @return false if no light arrives at the point, or if the light comes from the point itself
   * @throws IllegalStateException if one of these two methods returns null, or a point that is not finite
   */
  public boolean illuminate(final double px, final double py, final double pz, final Incidence incidence) {
    final RadianceRGB irradiance = getIrradianceAt(new Point3D((float) px, (float) py, (float) pz));
    if (irradiance == null) {
      throw wrongState("nullResult", getClass().getName(), "getIrradianceAt");
    }
    incidence.setIrradiance(irradiance.getR(), irradiance.getG(), irradiance.getB());
    return irradiance.getR() + irradiance.getG() + irradiance.getB() > 0 && direct(px, py, pz, incidence);
  }

  /**
   * For renderers: {@link #illuminate(double, double, double, Incidence)} for each of some points.
   *
   * @param n number of points
   * @param px first coordinates of the points
   * @param py second coordinates
   * @param pz third coordinates
   * @param incidence what the results are written to
   */
  public void illuminate(final int n, final double[] px, final double[] py, final double[] pz,
      final TileIncidence incidence) {
    incidence.ask(this, n, px, py, pz);
  }

  /** Writes direction and distance of the point from which a point is lit; returns false if the two coincide. */
  boolean direct(final double px, final double py, final double pz, final Incidence incidence) {
    final Point3D from = getPosition(new Point3D((float) px, (float) py, (float) pz));
    if (from == null) {
      throw wrongState("nullResult", getClass().getName(), "getPosition");
    }
    if (!(Float.isFinite(from.x) && Float.isFinite(from.y) && Float.isFinite(from.z))) {
      throw wrongState("wrongResult", getClass().getName(), "getPosition", from);
    }
    return incidence.aim(from.x - px, from.y - py, from.z - pz);
  }

  /** Writes the irradiance of the power spread over an area. */
  final void spread(final double area, final Incidence incidence) {
    incidence.setIrradiance(Math.min(LARGEST, channels.getR() / area), Math.min(LARGEST, channels.getG() / area),
        Math.min(LARGEST, channels.getB() / area));
  }

  /** {@link #getIrradianceAt} for a light that has {@link #illuminate} of its own. */
  final RadianceRGB irradianceAt(final Point3D P) {
    final Incidence incidence = new Incidence();
    final boolean lit = illuminate(notNull("P", P).x, P.y, P.z, incidence);
    return !lit ? RadianceRGB.NORADIANCE
        : new RadianceRGB(incidence.irradianceR(), incidence.irradianceG(), incidence.irradianceB());
  }

  /** The arguments that all lights have, spectrum and power, for {@code toString}. */
  final String emission() {
    return spectrum + ", power=" + power;
  }
}
