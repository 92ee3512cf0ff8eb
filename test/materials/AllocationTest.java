package materials;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.lang.management.ManagementFactory;
import java.util.List;

import org.junit.jupiter.api.Test;

import lights.Directional;
import lights.Incidence;
import lights.Light;
import lights.Omnidirectional;
import lights.Spot;
import primitives.Point3D;
import radiometry.ReflectanceRGB;
import radiometry.SpectrumRGB;

/** The methods for renderers allocate nothing, even before they are compiled. */
class AllocationTest {

  private static final ReflectanceRGB HALF = new ReflectanceRGB(0.5f, 0.5f, 0.5f);
  private static final List<Material> MATERIALS = List.of(new Lambertian(HALF),
      new PhongLafortune(HALF, HALF, new Blinn(20)),
      new ReflectiveCookTorrance(HALF, HALF, new GGX(20)), new AshikhminShirley(HALF, HALF, new Beckmann(20)),
      new OrenNayar(HALF, 20), new IdealConductor(HALF), new IdealDielectric(HALF, 1.5f, 1),
      new TransmissiveCookTorrance(HALF, 1.5f, 1, new Torrance(20)), new PhongLafortune(HALF, HALF, new Horn(20)));
  private static final SpectrumRGB WHITE = new SpectrumRGB(0.25f, 0.5f, 0.25f);
  private static final Point3D S = new Point3D(1, 5, 1);
  private static final Point3D O = new Point3D();
  private static final List<Light> LIGHTS = List.of(new Omnidirectional(S, WHITE, 1), new Spot(S, O, 30, WHITE, 1),
      new Directional(S, O, 4, WHITE, 1));

  /** As a renderer does, n times over. */
  private static double render(final int n, final Incidence incidence, final SurfaceInteraction interaction,
      final SpecularRays rays) {
    double sum = 0;
    for (int i = 0; i < n; i++) {
      interaction.setView(0, 1, 0, 0.6, 0.8, 0, i % 2 == 0);
      for (int j = 0; j < LIGHTS.size(); j++) {
        LIGHTS.get(j).illuminate(1e-4 * i, 0, 0, incidence);
        interaction.setIncident(incidence.directionX(), incidence.directionY() * (i % 3 - 1), incidence.directionZ());
        interaction.setIrradiance(incidence.irradianceR(), incidence.irradianceG(), incidence.irradianceB());
        for (int k = 0; k < MATERIALS.size(); k++) {
          MATERIALS.get(k).scatter(interaction);
          sum += interaction.radianceR() + (MATERIALS.get(k).specular(0.8, true, rays) ? rays.reflectedR() : 0);
        }
      }
    }
    return sum;
  }

  @Test
  void nothingIsAllocatedOnTheWayOfALight() {
    assumeTrue(ManagementFactory.getThreadMXBean() instanceof com.sun.management.ThreadMXBean);
    final com.sun.management.ThreadMXBean bean = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    assumeTrue(bean.isThreadAllocatedMemorySupported() && bean.isThreadAllocatedMemoryEnabled());
    final Incidence incidence = new Incidence();
    final SurfaceInteraction interaction = new SurfaceInteraction();
    final SpecularRays rays = new SpecularRays();
    render(10, incidence, interaction, rays);
    final long thread = Thread.currentThread().getId(), before = bean.getThreadAllocatedBytes(thread);
    final double sum = render(5000, incidence, interaction, rays);
    final long bytes = bean.getThreadAllocatedBytes(thread) - before;
    assertTrue(sum > 0 && bytes < 5000, () -> bytes + " bytes");
  }
}
