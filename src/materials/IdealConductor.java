package materials;

import radiometry.ReflectanceRGB;

/**
 * A polished metal: ideal reflection with the factor k<sub>s</sub> at every angle, and no lobe. Source: Whitted, "An
 * improved illumination model for shaded display", Communications of the ACM 23(6), 1980.
 *
 * <p><img src="doc-files/IdealConductor.png" width="320" height="240" alt="A mirror ball">
 */
public final class IdealConductor extends DiffuseSpecular {

  private final ReflectanceRGB specular;

  /**
   * A mirror.
   *
   * @param specular k<sub>s</sub>, not black
   * @throws IllegalArgumentException if it is null or black
   */
  public IdealConductor(final ReflectanceRGB specular) {
    super(Channels.ZERO, Channels.of(Energy.notBlack("specular", specular)), Channels.ZERO, null, StandIn.of(specular));
    this.specular = specular;
  }

  @Override
  public String toString() {
    return "IdealConductor(" + specular + ")";
  }
}
