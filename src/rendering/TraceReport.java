package rendering;

import lights.Incidence;
import lights.Light;
import materials.BTDF;
import materials.SpecularRays;
import materials.SurfaceInteraction;
import radiometry.RadianceRGB;
import tracer.Ray;

/** Reports the steps of a {@link WhittedTracer} to an observer. Unused without one. */
final class TraceReport {

  private final LightObserver observer;
  private final Incidence incidence;
  private final SurfaceInteraction interaction;
  private final SpecularRays specular;
  private boolean refracts;

  TraceReport(final LightObserver observer, final Incidence incidence, final SurfaceInteraction interaction,
      final SpecularRays specular) {
    this.observer = observer;
    this.incidence = incidence;
    this.interaction = interaction;
    this.specular = specular;
  }

  void surface(final LightObserver.Surface surface) {
    refracts = surface.material() instanceof BTDF;
    observer.surface(surface);
  }

  void background(final Ray ray, final int depth, final RadianceRGB radiance) {
    observer.background(ray, depth, radiance);
  }

  /** A light that is not examined further, because of its field, the side of the surface or the material. */
  void dark(final Light light, final int number, final LightObserver.Outcome outcome) {
    final boolean hasField = outcome != LightObserver.Outcome.OUTSIDE_FIELD;
    observer.light(new LightObserver.Contribution(light, number, outcome,
        hasField ? irradiance() : RadianceRGB.NORADIANCE, hasField ? Math.abs(interaction.cosineIn()) : 0,
        RadianceRGB.NORADIANCE, RadianceRGB.NORADIANCE, Ray.NORAY, hasField ? incidence.distance() : 0));
  }

  private RadianceRGB irradiance() {
    return new RadianceRGB(incidence.irradianceR(), incidence.irradianceG(), incidence.irradianceB());
  }

  /** A light that the surface reflects or transmits, unless an object blocks it. */
  void light(final Light light, final int number, final boolean isBlocked, final RadianceRGB radiance, final Ray shadowRay,
      final double distance) {
    observer.light(new LightObserver.Contribution(light, number,
        isBlocked ? LightObserver.Outcome.BLOCKED : LightObserver.Outcome.LIT, irradiance(),
        Math.abs(interaction.cosineIn()),
        new RadianceRGB(interaction.radianceR(), interaction.radianceG(), interaction.radianceB()), radiance, shadowRay,
        distance));
  }

  /** An ideal ray, with the factor that {@link SpecularRays} holds for it. */
  void specular(final Ray ray, final boolean refracted, final LightObserver.Fate fate) {
    if (refracted && !refracts) {
      return;
    }
    final RadianceRGB factor = refracted
        ? new RadianceRGB(specular.refractedR(), specular.refractedG(), specular.refractedB())
        : new RadianceRGB(specular.reflectedR(), specular.reflectedG(), specular.reflectedB());
    final boolean isTotal = refracted && fate == LightObserver.Fate.NEGLIGIBLE
        && factor.getR() + factor.getG() + factor.getB() == 0;
    observer.specular(new LightObserver.Specular(ray, refracted, factor,
        isTotal ? LightObserver.Fate.TOTAL_REFLECTION : fate));
  }
}
