package materials;

import java.util.Random;

import primitives.Vector3D;

/** Unit vectors for tests of materials. */
final class Directions {

  private Directions() {
  }

  /** A direction of the sphere, every one equally likely. */
  static double[] random(final Random random) {
    final double z = 2 * random.nextDouble() - 1, phi = 2 * Math.PI * random.nextDouble();
    return polar(Math.acos(z), phi);
  }

  /** A direction within 90 degrees of n, sometimes just barely. */
  static double[] above(final double[] n, final Random random) {
    final double[] d = random(random);
    final double cosine = dot(n, d), side = cosine < 0 ? -1 : 1, low = random.nextInt(5) == 0 ? 0.99 * cosine : 0;
    return unit(side * d[0] - side * low * n[0], side * d[1] - side * low * n[1], side * d[2] - side * low * n[2]);
  }

  /** A direction close to another. */
  static double[] near(final double[] d, final double spread, final Random random) {
    return unit(d[0] + spread * random.nextGaussian(), d[1] + spread * random.nextGaussian(),
        d[2] + spread * random.nextGaussian());
  }

  /** The direction at an angle to the z axis, in radians. */
  static double[] polar(final double theta, final double phi) {
    return new double[] {Math.sin(theta) * Math.cos(phi), Math.sin(theta) * Math.sin(phi), Math.cos(theta)};
  }

  /** The mirrored direction of d. */
  static double[] mirrored(final double[] d, final double[] n) {
    final double c = 2 * dot(n, d);
    return unit(c * n[0] - d[0], c * n[1] - d[1], c * n[2] - d[2]);
  }

  static double[] minus(final double[] d) {
    return new double[] {-d[0], -d[1], -d[2]};
  }

  static double[] unit(final double x, final double y, final double z) {
    final double length = Math.sqrt(x * x + y * y + z * z);
    return new double[] {x / length, y / length, z / length};
  }

  static double dot(final double[] a, final double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  static Vector3D vector(final double... d) {
    return new Vector3D((float) d[0], (float) d[1], (float) d[2]);
  }

  /** f in the three channels, by the method for renderers, whatever was written before. */
  static double[] f(final Material material, final double[] wi, final double[] wo, final double[] n, final boolean outside) {
    final SurfaceInteraction interaction = new SurfaceInteraction();
    interaction.setView(n[0], n[1], n[2], wo[0], wo[1], wo[2], outside);
    interaction.setIncident(wi[0], wi[1], wi[2]);
    interaction.setIrradiance(1, 1, 1);
    interaction.setRadiance(7, 8, 9);
    material.scatter(interaction);
    return new double[] {interaction.radianceR(), interaction.radianceG(), interaction.radianceB()};
  }
}
