package lights;

import primitives.Point3D;
import primitives.Vector3D;
import radiometry.RadianceRGB;

/** The power of a light that passes through a sphere about it, by the midpoint rule in rings of equal area. */
final class Flux {

  private static final int RINGS = 1000;
  private static final int SECTORS = 200;

  private Flux() {
  }

  /** Power that leaves the sphere less power that enters it, in each channel. */
  static double[] through(final Light light, final double radius) {
    final Point3D S = light.getPosition();
    final double[] flux = new double[3];
    final double area = 4 * Math.PI * radius * radius / RINGS / SECTORS;
    for (int i = 0; i < RINGS; i++) {
      final double z = 2 * (i + 0.5) / RINGS - 1, rho = Math.sqrt(1 - z * z);
      for (int j = 0; j < SECTORS; j++) {
        final double phi = 2 * Math.PI * (j + 0.5 + 0.3 * (i % 3)) / SECTORS;
        final double x = rho * Math.cos(phi), y = rho * Math.sin(phi);
        final Point3D P = new Point3D((float) (S.x + radius * x), (float) (S.y + radius * y), (float) (S.z + radius * z));
        final RadianceRGB E = light.getIrradianceAt(P);
        if (E.getR() + E.getG() + E.getB() > 0) {
          final Vector3D wi = light.getIncidenceDirection(P);
          final double cosine = -(x * wi.x + y * wi.y + z * wi.z);
          flux[0] += area * cosine * E.getR();
          flux[1] += area * cosine * E.getG();
          flux[2] += area * cosine * E.getB();
        }
      }
    }
    return flux;
  }
}
