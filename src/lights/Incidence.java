package lights;

/**
 * The light that a {@link Light} sends to a point: how much, from which direction, from how far. For renderers, which
 * reuse one per thread for all lights, so that nothing is allocated. Mutable, for one thread at a time.
 */
public final class Incidence {

  private double r;
  private double g;
  private double b;
  private double x;
  private double y;
  private double z;
  private double distance;

  /** All numbers are 0. */
  public Incidence() {
    // Filled by lights.
  }

  /**
   * Sets the irradiance perpendicular to the incidence.
   *
   * @param red its red channel, at least 0
   * @param green its green channel
   * @param blue its blue channel
   */
  public void setIrradiance(final double red, final double green, final double blue) {
    r = red;
    g = green;
    b = blue;
  }

  /**
   * Sets the direction and the distance of the point from which the light comes.
   *
   * @param dx first component of a vector of unit length, from the lit point towards the light
   * @param dy second component
   * @param dz third component
   * @param d distance in scene units, &gt; 0
   */
  public void setDirection(final double dx, final double dy, final double dz, final double d) {
    x = dx;
    y = dy;
    z = dz;
    distance = d;
  }

  /** Sets direction and distance from a vector to the light; returns false if its length is 0 or not finite. */
  boolean aim(final double dx, final double dy, final double dz) {
    final double d = Math.sqrt(dx * dx + dy * dy + dz * dz);
    setDirection(dx / d, dy / d, dz / d, d);
    return d > 0 && d < Double.POSITIVE_INFINITY;
  }

  /**
   * Red irradiance.
   *
   * @return the number, at least 0
   */
  public double irradianceR() {
    return r;
  }

  /**
   * Green irradiance.
   *
   * @return the number, at least 0
   */
  public double irradianceG() {
    return g;
  }

  /**
   * Blue irradiance.
   *
   * @return the number, at least 0
   */
  public double irradianceB() {
    return b;
  }

  /**
   * First component of the unit vector from the lit point towards the light.
   *
   * @return the number
   */
  public double directionX() {
    return x;
  }

  /**
   * Second component of that vector.
   *
   * @return the number
   */
  public double directionY() {
    return y;
  }

  /**
   * Third component of that vector.
   *
   * @return the number
   */
  public double directionZ() {
    return z;
  }

  /**
   * Distance to the point from which the light comes: obstacles that are farther away cast no shadow.
   *
   * @return the distance in scene units, &gt; 0
   */
  public double distance() {
    return distance;
  }
}
