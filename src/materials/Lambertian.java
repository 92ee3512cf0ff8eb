package materials;

import static arguments.Arguments.notNull;

import radiometry.ReflectanceRGB;

/**
 * A matte surface, equally bright from all directions: f = k<sub>d</sub> / π. Source: Lambert, "Photometria", 1760.
 *
 * <p><img src="doc-files/Lambertian.png" width="320" height="240" alt="A matte ball">
 */
public final class Lambertian extends DiffuseSpecular {

  private final ReflectanceRGB diffuse;

  /**
   * A matte surface.
   *
   * @param diffuse part of the light that is reflected; black is allowed
   * @throws IllegalArgumentException if it is null
   */
  public Lambertian(final ReflectanceRGB diffuse) {
    super(Channels.of(notNull("diffuse", diffuse)).times(1 / Math.PI), Channels.ZERO, Channels.ZERO, null,
        StandIn.of(diffuse));
    this.diffuse = diffuse;
  }

  @Override
  public String toString() {
    return "Lambertian(" + diffuse + ")";
  }
}
