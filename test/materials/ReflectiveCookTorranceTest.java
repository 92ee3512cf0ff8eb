package materials;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

import radiometry.ReflectanceRGB;

class ReflectiveCookTorranceTest implements BRDFContract {

  @Override
  public BRDF brdf() {
    return new ReflectiveCookTorrance(new ReflectanceRGB(0, 0.25f, 0.75f), new ReflectanceRGB(1, 0.5f, 0.25f),
        new Beckmann(25));
  }

  /** Frontally, wi = wo = n: k_d/π + k_s D(0)/4. */
  @Test
  void frontally() {
    final double[] n = {0, 0, 1};
    final double peak = new Beckmann(25).density(1, 0) / 4;
    final double[] f = Directions.f(brdf(), n, n, n, true);
    assertEquals(peak, f[0], 1e-9);
    assertEquals(0.25 / Math.PI + 0.5 * peak, f[1], 1e-9);
    assertEquals(0.75 / Math.PI + 0.25 * peak, f[2], 1e-9);
  }

  /** With both directions 80° from the normal and from each other, facets are masked: G = 2 cos 80° / c. */
  @Test
  void facetsMaskEachOther() {
    final double[] n = {0, 0, 1}, wi = Directions.polar(1.4, 0), wo = Directions.polar(1.4, 0);
    final double c = 1, nh = Math.cos(1.4), co = nh, d = new Beckmann(25).density(nh, 1 - nh * nh);
    assertEquals(d * 2 * nh * co / c / (4 * co * co), Directions.f(brdf(), wi, wo, n, true)[0], 1e-9 * d);
  }

  /** Towards grazing directions f grows, but stays finite. */
  @Test
  void grazingDirectionsStayFinite() {
    final double[] n = {0, 0, 1};
    for (double co = 1; co > 1e-100; co /= 10) {
      final double[] wi = {Math.sqrt(1 - co * co), 0, co}, wo = {-Math.sqrt(1 - co * co), 0, co};
      final double f = Directions.f(brdf(), wi, wo, n, true)[0];
      assertEquals(true, f > 0 && f * co < Double.POSITIVE_INFINITY, () -> "f = " + f);
    }
  }

  @Test
  void itsColourIsTheSumOfItsReflectances() {
    assertEquals(new java.awt.Color(255, 191, 255), brdf().getColor());
    assertEquals("ReflectiveCookTorrance(ReflectanceRGB(0.0, 0.25, 0.75), ReflectanceRGB(1.0, 0.5, 0.25), Beckmann(25.0))",
        brdf().toString());
  }
}
