package materials;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

import radiometry.ReflectanceRGB;

class AshikhminShirleyTest implements BRDFContract {

  @Override
  public BRDF brdf() {
    return new AshikhminShirley(new ReflectanceRGB(1, 0.5f, 0.25f), new ReflectanceRGB(0.5f, 1, 0), new GGX(30));
  }

  /** Frontally, wi = wo = n: 28/(23π) k_d (1 − k_s) (31/32)² + k_s D(0)/4. */
  @Test
  void frontally() {
    final double[] n = {0, 0, 1};
    final double peak = new GGX(30).density(1, 0) / 4, below = 28 / (23 * Math.PI) * Math.pow(31 / 32.0, 2);
    final double[] f = Directions.f(brdf(), n, n, n, true);
    assertEquals(0.5 * below + 0.5 * peak, f[0], 1e-9);
    assertEquals(peak, f[1], 1e-9);
    assertEquals(0.25 * below, f[2], 1e-9);
  }

  /** Below a coat that hardly reflects, the albedo is 31/32 from the front: ∫ (1 − (1 − c/2)⁵) 2c dc = 23/28. */
  @Test
  void theLightFromBelowIsWhatTheCoatLetsThrough() {
    final BRDF below = new AshikhminShirley(new ReflectanceRGB(1, 1, 1), new ReflectanceRGB(1e-6f, 1e-6f, 1e-6f), null);
    assertEquals(31 / 32.0, Albedo.ofSide(below, 0, true, 1, 300)[0], 1e-4);
  }

  @Test
  void itsColourIsTheSumOfItsReflectances() {
    assertEquals(new java.awt.Color(255, 255, 64), brdf().getColor());
    assertEquals("AshikhminShirley(ReflectanceRGB(1.0, 0.5, 0.25), ReflectanceRGB(0.5, 1.0, 0.0), GGX(30.0))",
        brdf().toString());
  }
}
