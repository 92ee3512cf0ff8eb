package materials;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;

import org.junit.jupiter.api.Test;

import primitives.Vector3D;
import radiometry.RadianceRGB;
import radiometry.ReflectanceRGB;

class LambertianTest implements BRDFContract {

  private static final ReflectanceRGB KD = new ReflectanceRGB(1, 0.5f, 0);

  @Override
  public BRDF brdf() {
    return new Lambertian(KD);
  }

  @Test
  void radianceIsTheSameFromEverywhere() {
    final RadianceRGB L = brdf().reflect(new RadianceRGB(Math.PI, Math.PI, Math.PI), new Vector3D(0, 0.6f, 0.8f),
        new Vector3D(0.6f, 0, 0.8f), new Vector3D(0, 0, 1));
    assertArrayEquals(new double[] {1, 0.5, 0}, new double[] {L.getR(), L.getG(), L.getB()}, 1e-12);
    final double[] albedo = Albedo.ofSide(brdf(), 1, true, 1, 300);
    assertArrayEquals(new double[] {1, 0.5, 0}, albedo, 1e-4);
  }

  @Test
  void nothingIsSeenAlongTheSurface() {
    final double[] n = {0, 0, 1}, along = {1, 0, 0};
    assertArrayEquals(new double[3], Directions.f(brdf(), along, n, n, true));
    assertArrayEquals(new double[3], Directions.f(brdf(), n, along, n, true));
    assertTrue(Directions.f(brdf(), n, n, n, true)[0] > 0.3);
  }

  @Test
  void itDoesNotMirror() {
    assertNull(brdf().mirror(0));
    assertFalse(brdf().specular(0, true, new SpecularRays()));
    assertTrue(brdf().scatters());
    assertFalse(brdf().transmits());
  }

  @Test
  void blackIsAColourToo() {
    final BRDF black = new Lambertian(new ReflectanceRGB(Color.BLACK));
    assertFalse(black.scatters());
    assertEquals(Color.BLACK, black.getColor());
    assertEquals(new Color(255, 128, 0), brdf().getColor());
    assertEquals("Lambertian(ReflectanceRGB(1.0, 0.5, 0.0))", brdf().toString());
    assertTrue(new Lambertian(new ReflectanceRGB(0, 0, 0.1f)).scatters());
    assertTrue(new Lambertian(new ReflectanceRGB(0, 0.1f, 0)).scatters());
  }
}
