package lights;

import static arguments.Arguments.notNull;
import static arguments.Arguments.positive;

import primitives.Point3D;
import radiometry.RadianceRGB;
import radiometry.SpectrumRGB;

/**
 * A collimated beam: a disc about the position that shines along its axis û. With a = (P − S)·û, a point is lit if a &gt;
 * 0 and its distance from the axis is at most the radius r; then E = Φ / (π r²) at any distance, and the light comes from
 * Q = P − a û, the point of the disc in front of P. This kind of light is the course's own.
 *
 * <p><img src="doc-files/Directional.png" width="320" height="240" alt="A ball in a beam">
 */
public final class Directional extends Light {

  private final Point3D lookAt;
  private final float radius;
  private final Axis axis;
  private final double area;

  /**
   * A beam.
   *
   * @param position middle of the disc
   * @param lookAt a point of the axis before the disc, other than the position
   * @param radius radius of the disc in scene units, &gt; 0
   * @param spectrum how the power is shared among the channels
   * @param power emitted power, &gt; 0
   * @throws IllegalArgumentException if an argument is null or not finite, if both points are equal, or if radius or power
   *     is not positive
   */
  public Directional(final Point3D position, final Point3D lookAt, final float radius, final SpectrumRGB spectrum,
      final float power) {
    super(position, spectrum, power);
    this.axis = new Axis(position, lookAt);
    this.lookAt = new Point3D(lookAt);
    this.radius = positive("radius", radius);
    this.area = Math.PI * this.radius * this.radius;
  }

  @Override
  public RadianceRGB getIrradianceAt(final Point3D P) {
    return irradianceAt(P);
  }

  @Override
  public Point3D getPosition(final Point3D P) {
    final double a = axis.ahead(notNull("P", P).x, P.y, P.z);
    return new Point3D((float) (P.x - a * axis.directionX()), (float) (P.y - a * axis.directionY()),
        (float) (P.z - a * axis.directionZ()));
  }

  @Override
  public boolean illuminate(final double px, final double py, final double pz, final Incidence incidence) {
    final double a = axis.ahead(px, py, pz), beside = axis.beside(px, py, pz);
    spread(area, incidence);
    direct(px, py, pz, incidence);
    return a > 0 && beside - radius <= Axis.EDGE * (a + beside);
  }

  @Override
  boolean direct(final double px, final double py, final double pz, final Incidence incidence) {
    final double a = axis.ahead(px, py, pz), sign = a < 0 ? 1 : -1;
    incidence.setDirection(sign * axis.directionX(), sign * axis.directionY(), sign * axis.directionZ(), Math.abs(a));
    return a != 0;
  }

  @Override
  public String toString() {
    return "Directional(" + getPosition() + ", lookAt=" + lookAt + ", radius=" + radius + ", " + emission() + ")";
  }
}
