package window;

import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Set;

import materials.BTDF;
import radiometry.RadianceRGB;
import rendering.LightObserver;
import tracer.Ray;

/** Sums the contributions to a pixel without some effects. */
final class SelectiveSum implements LightObserver {

  /** Effects that can be left out. */
  enum Effect {
    /** Objects block light. */
    SHADOWS,
    /** Conductors reflect ideally. */
    MIRRORS,
    /** Dielectrics reflect and refract ideally. */
    GLASS
  }

  private final Set<Effect> omitted;
  private final Map<Ray, Boolean> isRayOmitted = new IdentityHashMap<>();
  private boolean isGlass;
  private boolean isOmitted;
  private RadianceRGB sum = RadianceRGB.NORADIANCE;

  SelectiveSum(final Set<Effect> omitted) {
    this.omitted = omitted;
  }

  RadianceRGB sum() {
    return sum;
  }

  @Override
  public void surface(final Surface surface) {
    isGlass = surface.material() instanceof BTDF;
    isOmitted = isRayOmitted.getOrDefault(surface.ray(), false);
  }

  @Override
  public void light(final Contribution light) {
    final boolean counts = light.outcome() == Outcome.LIT
        || light.outcome() == Outcome.BLOCKED && omitted.contains(Effect.SHADOWS);
    if (counts && !isOmitted) {
      sum = sum.plus(light.radiance());
    }
  }

  @Override
  public void specular(final Specular specular) {
    if (specular.fate() == Fate.FOLLOWED) {
      isRayOmitted.put(specular.ray(), isOmitted || omitted.contains(isGlass ? Effect.GLASS : Effect.MIRRORS));
    }
  }

  @Override
  public void background(final Ray ray, final int depth, final RadianceRGB radiance) {
    if (!isRayOmitted.getOrDefault(ray, false)) {
      sum = sum.plus(radiance);
    }
  }
}
