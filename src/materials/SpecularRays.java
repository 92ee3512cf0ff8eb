package materials;

/**
 * The ideal rays that leave a surface, as a {@link Material} describes them to a renderer: a reflected one and a
 * refracted one, each with the factors of its radiance. Mutable; a renderer keeps some for each thread, so that nothing
 * is allocated.
 *
 * <p>With d the direction of the incoming ray, n the normal on its side and co = −n·d, the reflected ray is d + 2 co n;
 * the refracted ray is r d + (r co − cos θt) n, r = {@link #ratio}, cos θt = {@link #refractedCosine}.
 */
public final class SpecularRays {

  private double reflectedR;
  private double reflectedG;
  private double reflectedB;
  private double refractedR;
  private double refractedG;
  private double refractedB;
  private double ratio;
  private double refractedCosine;

  /** No rays yet. */
  public SpecularRays() {
    // Filled by materials.
  }

  void reflect(final double r, final double g, final double b) {
    reflectedR = r;
    reflectedG = g;
    reflectedB = b;
  }

  void refract(final double r, final double g, final double b, final double indexRatio, final double cosine) {
    refractedR = r;
    refractedG = g;
    refractedB = b;
    ratio = indexRatio;
    refractedCosine = cosine;
  }

  void refractNothing() {
    refract(0, 0, 0, 1, 1);
  }

  /**
   * Factor of the reflected ray in red.
   *
   * @return from 0 to 1
   */
  public double reflectedR() {
    return reflectedR;
  }

  /**
   * Factor of the reflected ray in green.
   *
   * @return from 0 to 1
   */
  public double reflectedG() {
    return reflectedG;
  }

  /**
   * Factor of the reflected ray in blue.
   *
   * @return from 0 to 1
   */
  public double reflectedB() {
    return reflectedB;
  }

  /**
   * Factor of the refracted ray in red; it includes the change of radiance at an interface and can exceed 1.
   *
   * @return at least 0; 0 if nothing is refracted
   */
  public double refractedR() {
    return refractedR;
  }

  /**
   * Factor of the refracted ray in green.
   *
   * @return at least 0
   */
  public double refractedG() {
    return refractedG;
  }

  /**
   * Factor of the refracted ray in blue.
   *
   * @return at least 0
   */
  public double refractedB() {
    return refractedB;
  }

  /**
   * The index of refraction on the viewer's side, divided by that of the other side.
   *
   * @return the ratio, &gt; 0; 1 if nothing is refracted
   */
  public double ratio() {
    return ratio;
  }

  /**
   * The cosine of the angle between the refracted ray and −n.
   *
   * @return from 0 to 1; 1 if nothing is refracted
   */
  public double refractedCosine() {
    return refractedCosine;
  }
}
