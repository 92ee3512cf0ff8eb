package materials;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

import primitives.Vector3D;
import radiometry.RadianceRGB;
import radiometry.ReflectanceRGB;

class PhongLafortuneTest implements BRDFContract {

  @Override
  public BRDF brdf() {
    return new PhongLafortune(new ReflectanceRGB(0, 0.25f, 0.75f), new ReflectanceRGB(1, 0.5f, 0.25f), new Blinn(15));
  }

  /** Frontally, wi = wo = n: k_d/π + k_s D(0)/4 with D(0) = (q + 2) / 2π. */
  @Test
  void frontally() {
    final double[] n = {0, 0, 1};
    final double q = -Math.log(2) / Math.log(Math.cos(Math.toRadians(15))), peak = (q + 2) / (2 * Math.PI) / 4;
    final double[] f = Directions.f(brdf(), n, n, n, true);
    assertEquals(peak, f[0], 1e-9);
    assertEquals(0.25 / Math.PI + 0.5 * peak, f[1], 1e-9);
    assertEquals(0.75 / Math.PI + 0.25 * peak, f[2], 1e-9);
  }

  /** With Blinn's lobe and both angles equal, the highlight is (q + 2) / (8π cos² θ), θ the angle of both. */
  @Test
  void alongTheMirroredDirection() {
    final double[] n = {0, 0, 1}, wi = Directions.polar(1, Math.PI), wo = Directions.polar(1, 0);
    final double q = -Math.log(2) / Math.log(Math.cos(Math.toRadians(15)));
    assertEquals((q + 2) / (8 * Math.PI * Math.cos(1) * Math.cos(1)), Directions.f(brdf(), wi, wo, n, true)[0], 1e-9);
  }

  /** The public methods accept vectors of any length, as unit vectors in floats are not exact. */
  @Test
  void lengthsOfVectorsDoNotMatter() {
    final double[] wi = Directions.unit(0.3, 0.4, 0.5), wo = Directions.unit(-0.2, -0.5, 0.6);
    final double[] n = Directions.unit(0.1, -0.1, 1);
    final Vector3D i = Directions.vector(2 * wi[0], 2 * wi[1], 2 * wi[2]);
    final Vector3D o = Directions.vector(3 * wo[0], 3 * wo[1], 3 * wo[2]);
    final Vector3D long5 = Directions.vector(5 * n[0], 5 * n[1], 5 * n[2]);
    final RadianceRGB L = brdf().reflect(new RadianceRGB(1, 1, 1), i, o, long5);
    final double[] f = Directions.f(brdf(), wi, wo, n, true);
    assertEquals(f[0], L.getR(), 1e-5 * f[0]);
    assertEquals(f[2], L.getB(), 1e-5 * f[2]);
  }

  @Test
  void itsColourIsTheSumOfItsReflectances() {
    assertEquals(new java.awt.Color(255, 191, 255), brdf().getColor());
    assertEquals("PhongLafortune(ReflectanceRGB(0.0, 0.25, 0.75), ReflectanceRGB(1.0, 0.5, 0.25), Blinn(15.0))",
        brdf().toString());
    assertEquals("PhongLafortune(null, ReflectanceRGB(1.0, 0.5, 0.25), null)",
        new PhongLafortune(null, new ReflectanceRGB(1, 0.5f, 0.25f), null).toString());
  }
}
