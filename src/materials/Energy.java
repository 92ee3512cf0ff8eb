package materials;

import static arguments.Arguments.wrong;

import radiometry.ReflectanceRGB;

/**
 * Checks of reflectances that depend on each other: a surface reflects something, and no more than it receives.
 */
final class Energy {

  /** How far the sum of two reflectances, each rounded to a float, may exceed 1. */
  private static final double TOLERANCE = 1e-6;

  private Energy() {
  }

  /** Checks a reflectance that a material requires. */
  static ReflectanceRGB notBlack(final String name, final ReflectanceRGB k) {
    if (Channels.isAbsent(k)) {
      throw wrong("black", name, k);
    }
    return k;
  }

  /** Checks a diffuse and a specular reflectance of which one may be missing and whose sum must not exceed 1. */
  static void check(final ReflectanceRGB diffuse, final ReflectanceRGB specular) {
    if (Channels.isAbsent(diffuse) && Channels.isAbsent(specular)) {
      throw wrong("noReflectance", diffuse, specular);
    }
    if (!(Channels.of(diffuse).plus(Channels.of(specular)).largest() <= 1 + TOLERANCE)) {
      throw wrong("energy", diffuse, specular);
    }
  }
}
