package materials;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.awt.Color;

import org.junit.jupiter.api.Test;

import radiometry.ReflectanceRGB;

class IdealConductorTest implements BRDFContract {

  @Override
  public BRDF brdf() {
    return new IdealConductor(new ReflectanceRGB(1, 0.75f, 0.25f));
  }

  @Test
  void theFactorIsTheSameAtEveryAngle() {
    for (final double cosine : new double[] {0, 1e-9, 0.3, 1}) {
      final ReflectanceRGB factor = brdf().mirror(cosine);
      assertArrayEquals(new float[] {1, 0.75f, 0.25f}, new float[] {factor.getR(), factor.getG(), factor.getB()});
    }
  }

  @Test
  void itShowsNoLights() {
    final double[] n = {0, 0, 1};
    assertArrayEquals(new double[3], Directions.f(brdf(), n, n, n, true));
    assertFalse(brdf().scatters());
    assertEquals(new Color(255, 191, 64), brdf().getColor());
    assertEquals("IdealConductor(ReflectanceRGB(1.0, 0.75, 0.25))", brdf().toString());
  }
}
