package materials;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Locale;
import java.util.function.BiFunction;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;

import primitives.Vector3D;
import radiometry.RadianceRGB;
import radiometry.ReflectanceRGB;

/** Invalid arguments of materials are refused with name and value. */
class WrongMaterialsTest {

  private static final ReflectanceRGB HALF = new ReflectanceRGB(0.5f, 0.5f, 0.5f);
  private static final ReflectanceRGB MORE = new ReflectanceRGB(0.5f, 0.50001f, 0.5f);
  private static final ReflectanceRGB BLACK = new ReflectanceRGB(0, 0, 0);
  private static final NormalDistributionFunction NDF = new Blinn(20);
  private static final List<BiFunction<ReflectanceRGB, ReflectanceRGB, BRDF>> SUMS = List.of(
      (d, s) -> new PhongLafortune(d, s, NDF), (d, s) -> new ReflectiveCookTorrance(d, s, NDF));

  private static void assertRefused(final String name, final Object value, final Executable call) {
    final String message = assertThrows(IllegalArgumentException.class, call).getMessage();
    assertTrue(message.startsWith(name), message);
    assertTrue(message.contains(String.valueOf(value)), message);
  }

  @Test
  void moreLightThanArrives() {
    for (final BiFunction<ReflectanceRGB, ReflectanceRGB, BRDF> make : SUMS) {
      assertRefused("diffuse and specular reflectance must not exceed 1", MORE, () -> make.apply(HALF, MORE));
      assertRefused("diffuse and specular reflectance must not exceed 1", HALF, () -> make.apply(MORE, HALF));
      for (final ReflectanceRGB one : new ReflectanceRGB[] {new ReflectanceRGB(1, 0, 0), new ReflectanceRGB(0, 1, 0),
        new ReflectanceRGB(0, 0, 1)}) {
        assertThrows(IllegalArgumentException.class, () -> make.apply(one, HALF));
      }
      assertDoesNotThrow(() -> make.apply(HALF, HALF));
      assertDoesNotThrow(() -> make.apply(HALF, new ReflectanceRGB(0.5f, 0.5000009f, 0.5f)));
      assertThrows(IllegalArgumentException.class, () -> make.apply(HALF, new ReflectanceRGB(0.5f, 0.5000011f, 0.5f)));
      assertDoesNotThrow(() -> make.apply(new ReflectanceRGB(1, 1, 1), null));
    }
    assertDoesNotThrow(() -> new AshikhminShirley(new ReflectanceRGB(1, 1, 1), new ReflectanceRGB(1, 1, 1), NDF));
  }

  @Test
  void nothingToReflect() {
    for (final ReflectanceRGB none : new ReflectanceRGB[] {null, BLACK}) {
      for (final BiFunction<ReflectanceRGB, ReflectanceRGB, BRDF> make : SUMS) {
        assertRefused("diffuse and specular must not both be null or black", none, () -> make.apply(none, BLACK));
        assertRefused("diffuse and specular must not both be null or black", none, () -> make.apply(null, none));
        assertDoesNotThrow(() -> make.apply(HALF, none));
        assertDoesNotThrow(() -> make.apply(none, HALF));
      }
      assertRefused("diffuse must", none, () -> new AshikhminShirley(none, HALF, NDF));
      assertRefused("specular must", none, () -> new AshikhminShirley(HALF, none, NDF));
      assertRefused("diffuse must", none, () -> new OrenNayar(none, 20));
      assertRefused("specular must", none, () -> new IdealConductor(none));
    }
    assertRefused("diffuse must not be null", null, () -> new Lambertian(null));
  }

  @Test
  void numbers() {
    for (final float wrong : new float[] {-Float.MIN_VALUE, Math.nextUp(90f), Float.NaN, Float.POSITIVE_INFINITY}) {
      assertRefused("sigma must", wrong, () -> new OrenNayar(HALF, wrong));
    }
    assertDoesNotThrow(() -> new OrenNayar(HALF, 90));
    for (final float wrong : new float[] {0, -0f, -1.5f, Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY}) {
      assertRefused("eta_int must", wrong, () -> new IdealDielectric(HALF, wrong, 1));
      assertRefused("eta_ext must", wrong, () -> new IdealDielectric(HALF, 1.5f, wrong));
      assertRefused("eta_int must", wrong, () -> new TransmissiveCookTorrance(HALF, wrong, 1, NDF));
      assertRefused("eta_ext must", wrong, () -> new TransmissiveCookTorrance(HALF, 1.5f, wrong, NDF));
    }
    assertDoesNotThrow(() -> new IdealDielectric(null, Float.MIN_VALUE, Float.MAX_VALUE));
  }

  @Test
  void vectorsOfTheOpenInterface() {
    final BRDF phong = new PhongLafortune(HALF, HALF, NDF);
    final BTDF glass = new TransmissiveCookTorrance(HALF, 1.5f, 1, NDF);
    final RadianceRGB E = new RadianceRGB(1, 1, 1);
    final Vector3D z = new Vector3D(0, 0, 1);
    for (final Vector3D wrong : new Vector3D[] {null, new Vector3D(), new Vector3D(0, Float.NaN, 1)}) {
      assertRefused("wi must", wrong, () -> phong.reflect(E, wrong, z, z));
      assertRefused("wo must", wrong, () -> phong.reflect(E, z, wrong, z));
      assertRefused("n must", wrong, () -> phong.reflect(E, z, z, wrong));
      assertRefused("wi must", wrong, () -> glass.scatter(E, wrong, z, z, true));
    }
    assertRefused("irradiance must", null, () -> phong.reflect(null, z, z, z));
    assertRefused("irradiance must", null, () -> glass.scatter(null, z, z, z, true));
  }

  @Test
  void messagesAreSpanishWhereTheLanguageIs() {
    final Locale before = Locale.getDefault();
    Locale.setDefault(new Locale("es", "ES"));
    try {
      assertRefused("diffuse no debe ser null ni negro, pero es null", "", () -> new OrenNayar(null, 20));
      assertRefused("las reflectancias difusa y especular no deben superar juntas 1", MORE,
          () -> SUMS.get(0).apply(HALF, MORE));
    } finally {
      Locale.setDefault(before);
    }
    assertEquals("diffuse must not be null or black, but it is null",
        assertThrows(IllegalArgumentException.class, () -> new OrenNayar(null, 20)).getMessage());
  }
}
