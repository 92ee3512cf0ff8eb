package materials;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;

import org.junit.jupiter.api.Test;

import primitives.Vector3D;
import radiometry.RadianceRGB;
import radiometry.ReflectanceRGB;
import trials.Trials;

/**
 * The laws that every {@link BRDF} must obey, as tests. The test of a material implements this interface and so inherits
 * them; it has to implement one method:
 *
 * <pre>{@code
 * class PlasterTest implements BRDFContract {
 *   public BRDF brdf() {
 *     return new Lambertian(new ReflectanceRGB(0.9f, 0.9f, 0.8f));
 *   }
 * }
 * }</pre>
 *
 * <p>A material that violates a law on purpose, as cartoon shading does, overrides {@link #isReciprocal} or
 * {@link #conservesEnergy}.
 */
public interface BRDFContract {

  /**
   * The material to be tested.
   *
   * @return a material
   */
  BRDF brdf();

  /**
   * Whether f(wi, wo) = f(wo, wi).
   *
   * @return true unless overridden
   */
  default boolean isReciprocal() {
    return true;
  }

  /**
   * Whether no more light is reflected than arrives.
   *
   * @return true unless overridden
   */
  default boolean conservesEnergy() {
    return true;
  }

  /** Compares up to a relative tolerance: vectors in floats are uncertain by 6e-8, and steep lobes multiply that. */
  private static void assertSame(final double[] expected, final double[] actual, final double tolerance) {
    for (int c = 0; c < 3; c++) {
      final double e = expected[c], a = actual[c];
      assertTrue(Math.abs(e - a) <= tolerance * Math.max(Math.abs(e), Math.abs(a)),
          () -> Arrays.toString(expected) + " and " + Arrays.toString(actual));
    }
  }

  /** Radiance is not null, at least 0 in each channel, and proportional to the irradiance. */
  @Test
  default void radianceIsNotNegative() {
    Trials.of(2000, random -> {
      final double[] n = Directions.random(random), wi = Directions.above(n, random), wo = Directions.above(n, random);
      final Vector3D vi = Directions.vector(wi), vo = Directions.vector(wo), vn = Directions.vector(n);
      if (vn.dot(vi) > 0 && vn.dot(vo) > 0) {
        final RadianceRGB L = brdf().reflect(new RadianceRGB(1, 1, 1), vi, vo, vn);
        assertNotNull(L);
        final RadianceRGB more = brdf().reflect(new RadianceRGB(2, 4, 8), vi, vo, vn);
        assertSame(new double[] {2 * L.getR(), 4 * L.getG(), 8 * L.getB()},
            new double[] {more.getR(), more.getG(), more.getB()}, 1e-9);
        assertEquals(L.toString(), brdf().reflect(new RadianceRGB(1, 1, 1), vi, vo, vn).toString(), "asked again");
      }
    });
  }

  /** The method for renderers agrees with the public one. */
  @Test
  default void renderersSeeTheSameMaterial() {
    Trials.of(2000, random -> {
      final double[] n = Directions.random(random), wi = Directions.above(n, random), wo = Directions.above(n, random);
      final Vector3D vi = Directions.vector(wi), vo = Directions.vector(wo), vn = Directions.vector(n);
      if (vn.dot(vi) > 1e-3 && vn.dot(vo) > 1e-3) {
        final RadianceRGB L = brdf().reflect(new RadianceRGB(1, 1, 1), vi, vo, vn);
        assertSame(new double[] {L.getR(), L.getG(), L.getB()}, Directions.f(brdf(), wi, wo, n, true), 2e-3);
      }
    });
  }

  /** Nothing is reflected of light from below the surface, or towards a viewer there. */
  @Test
  default void nothingIsSeenFromBelow() {
    Trials.of(500, random -> {
      final double[] n = Directions.random(random), wi = Directions.above(n, random), wo = Directions.above(n, random);
      assertEquals("[0.0, 0.0, 0.0]", Arrays.toString(Directions.f(brdf(), Directions.minus(wi), wo, n, true)));
      assertEquals("[0.0, 0.0, 0.0]", Arrays.toString(Directions.f(brdf(), wi, Directions.minus(wo), n, true)));
    });
  }

  /** Paths of light can be reversed. */
  @Test
  default void theBrdfIsReciprocal() {
    Trials.of(isReciprocal() ? 3000 : 0, random -> {
      final double[] n = Directions.random(random), wi = Directions.above(n, random);
      final double[] wo = random.nextBoolean() ? Directions.above(n, random)
          : Directions.near(Directions.mirrored(wi, n), 0.1 * random.nextDouble(), random);
      assertSame(Directions.f(brdf(), wi, wo, n, true), Directions.f(brdf(), wo, wi, n, true), 1e-6);
    });
  }

  /** Lobes and mirror together reflect no more than arrives. */
  @Test
  default void noMoreIsReflectedThanArrives() {
    for (int degrees = conservesEnergy() ? 0 : 90; degrees < 90; degrees += degrees == 80 ? 9 : 20) {
      final double theta = Math.toRadians(degrees);
      final double[] albedo = Albedo.ofSide(brdf(), theta, true, 1, 150);
      final ReflectanceRGB mirror = brdf().mirror(Math.cos(theta));
      final ReflectanceRGB m = mirror == null ? new ReflectanceRGB(0, 0, 0) : mirror;
      assertTrue(albedo[0] + m.getR() <= 1.001 && albedo[1] + m.getG() <= 1.001 && albedo[2] + m.getB() <= 1.001,
          () -> Arrays.toString(albedo) + " and " + m + " at " + Math.toDegrees(theta) + " degrees");
    }
  }
}
