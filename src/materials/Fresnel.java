package materials;

/** The fraction of light that a smooth interface reflects. */
final class Fresnel {

  private Fresnel() {
  }

  /**
   * (1 − c)⁵, the rise of a reflectance towards grazing directions. Source: Schlick, "An inexpensive BRDF model for
   * physically-based rendering", Eurographics 1994.
   */
  static double schlick(final double cosine) {
    final double d = Math.max(0, 1 - cosine), d2 = d * d;
    return d2 * d2 * d;
  }

  /**
   * The cosine of the refracted ray's angle by Snell's law, √(1 − r² (1 − c²)) in a form that is exact if both indices
   * are equal.
   *
   * @param cosine cosine of the incident ray's angle, from 0 to 1
   * @param ratio index of refraction on its side, divided by that of the other
   * @return the cosine; NaN if none, that is, for total reflection
   */
  static double refractedCosine(final double cosine, final double ratio) {
    return Math.sqrt(cosine * cosine + (1 - ratio) * (1 + ratio) * (1 - cosine) * (1 + cosine));
  }

  /**
   * Reflectance of a dielectric for unpolarised light. Source: Pharr, Jakob and Humphreys, "Physically Based Rendering", 4th
   * edition, 2023, section 9.3.
   *
   * @param cosine cosine of the incident ray's angle, from 0 to 1
   * @param ratio index of refraction on its side, divided by that of the other
   * @param refractedCosine what {@link #refractedCosine} returns for these
   * @return from 0 to 1; 1 for total reflection
   */
  static double reflectance(final double cosine, final double ratio, final double refractedCosine) {
    if (!(refractedCosine > 0)) {
      return 1;
    }
    final double across = (ratio * cosine - refractedCosine) / (ratio * cosine + refractedCosine);
    final double along = (cosine - ratio * refractedCosine) / (cosine + ratio * refractedCosine);
    return (across * across + along * along) / 2;
  }
}
