package lights;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;

import org.junit.jupiter.api.Test;

import primitives.Point3D;
import primitives.Vector3D;
import radiometry.RadianceRGB;
import trials.Trials;

/**
 * The laws that every {@link Light} must obey, as tests. The test of a light implements this interface and so inherits
 * them; it has to implement one method:
 *
 * <pre>{@code
 * class BulbTest implements LightContract {
 *   public Light light() {
 *     return new Omnidirectional(new Point3D(1, 2, 3), new SpectrumRGB(0.5f, 0.25f, 0.25f), 100);
 *   }
 * }
 * }</pre>
 *
 * <p>A light whose field is much larger or smaller than a unit overrides {@link #size}; one that violates conservation of
 * energy on purpose, {@link #conservesEnergy}.
 */
public interface LightContract {

  /**
   * The light to be tested.
   *
   * @return a light that lights points within about {@link #size} of its position
   */
  Light light();

  /**
   * The distance from the light within which points are tried.
   *
   * @return 5 unless overridden
   */
  default double size() {
    return 5;
  }

  /**
   * Whether no more than the light's power leaves it.
   *
   * @return true unless overridden
   */
  default boolean conservesEnergy() {
    return true;
  }

  /** A point about the light, sometimes very near it. */
  private Point3D point(final Random random) {
    final double far = random.nextInt(4) == 0 ? 1e-3 * size() : size();
    final Point3D S = light().getPosition();
    return new Point3D((float) (S.x + far * random.nextGaussian()), (float) (S.y + far * random.nextGaussian()),
        (float) (S.z + far * random.nextGaussian()));
  }

  /** Irradiance is not null, at least 0 and finite in each channel, and the same when computed again. */
  @Test
  default void irradianceIsNotNegative() {
    final int[] lit = {0};
    Trials.of(1000, random -> {
      final Point3D P = point(random);
      final RadianceRGB E = light().getIrradianceAt(P);
      assertNotNull(E, () -> "at " + P);
      lit[0] += E.getR() + E.getG() + E.getB() > 0 ? 1 : 0;
      assertEquals(E.toString(), light().getIrradianceAt(new Point3D(P)).toString(), () -> "again, at " + P);
    });
    assertTrue(lit[0] > 20, () -> "only " + lit[0] + " of 1000 points are lit");
  }

  /** The light comes from its stated point, along a unit vector. */
  @Test
  default void directionsAreUnitVectorsTowardsTheLight() {
    Trials.of(1000, random -> {
      final Point3D P = point(random), before = new Point3D(P), from = light().getPosition(P);
      assertNotNull(from, () -> "at " + P);
      final Vector3D wi = light().getIncidenceDirection(P);
      assertEquals(before, P, "the point is left as it is");
      assertEquals(1, wi.length(), 1e-6, () -> "at " + P);
      final double d = from.distance(P);
      final double rounding = 1e-6 * (d + Math.abs(P.x) + Math.abs(P.y) + Math.abs(P.z));
      assertEquals(from.x, P.x + d * wi.x, rounding, () -> "at " + P);
      assertEquals(from.y, P.y + d * wi.y, rounding, () -> "at " + P);
      assertEquals(from.z, P.z + d * wi.z, rounding, () -> "at " + P);
    });
  }

  /** The method for renderers agrees with the public ones. */
  @Test
  default void renderersSeeTheSameLight() {
    final Incidence incidence = new Incidence();
    Trials.of(1000, random -> {
      final Point3D P = point(random);
      final RadianceRGB E = light().getIrradianceAt(P);
      final boolean lit = E.getR() + E.getG() + E.getB() > 0;
      assertEquals(lit, light().illuminate(P.x, P.y, P.z, incidence), () -> "lit at " + P);
      if (lit) {
        assertEquals(E.getR(), incidence.irradianceR(), 1e-9 * E.getR());
        assertEquals(E.getG(), incidence.irradianceG(), 1e-9 * E.getG());
        assertEquals(E.getB(), incidence.irradianceB(), 1e-9 * E.getB());
        final Vector3D wi = light().getIncidenceDirection(P);
        assertEquals(wi.x, incidence.directionX(), 1e-6);
        assertEquals(wi.y, incidence.directionY(), 1e-6);
        assertEquals(wi.z, incidence.directionZ(), 1e-6);
        assertEquals(light().getPosition(P).distance(P), incidence.distance(), 1e-6 * (incidence.distance() + size()));
      }
    });
  }

  /** Through a sphere around the light passes no more than its power, in each channel. */
  @Test
  default void noMoreThanThePowerLeavesTheLight() {
    for (final double r : new double[] {0.1 * size(), 0.7 * size(), 3 * size()}) {
      final double[] flux = Flux.through(light(), r);
      final RadianceRGB power = light().getPower();
      assertTrue(!conservesEnergy() || flux[0] <= 1.02 * power.getR() && flux[1] <= 1.02 * power.getG()
          && flux[2] <= 1.02 * power.getB(), () -> flux[0] + ", " + flux[1] + ", " + flux[2] + " at distance " + r);
    }
  }
}
