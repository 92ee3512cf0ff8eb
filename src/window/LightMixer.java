package window;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.BitSet;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

import lights.LightGroup;
import radiometry.RadianceRGB;
import rendering.Illumination;
import rendering.LightObserver;
import scenes.SceneFile;
import tracer.Hit;
import tracer.Ray;
import tracer.RayGenerator;

/**
 * Mixes pictures of a lit scene from any of its lights. As radiance is linear in the lights, each light is rendered once,
 * alone and before a black background, and the background once without lights; a mixture is their sum.
 */
final class LightMixer {

  /** What was rendered: a light by its number, or the background by −1, for a recursion depth and without some effects. */
  private record Part(int light, int depth, Set<SelectiveSum.Effect> omitted) {
  }

  private static final int BACKGROUND = -1;

  private final SceneFile scene;
  private final int W;
  private final int H;
  private final Map<Part, float[]> radiances = new HashMap<>();

  /** A mixer for pictures of W by H pixels of a lit scene. */
  LightMixer(final SceneFile scene, final int W, final int H) {
    this.scene = scene;
    this.W = W;
    this.H = H;
  }

  /**
   * The picture with some of the lights. Not to be called by two threads at once.
   *
   * @param on the lights that are on
   * @param depth recursion depth
   * @param omitted effects that are left out
   * @param isCancelled asked between rows; if it returns true, null is returned
   */
  BufferedImage mix(final BitSet on, final int depth, final Set<SelectiveSum.Effect> omitted,
      final BooleanSupplier isCancelled) {
    final float[] sum = part(new Part(BACKGROUND, depth, Set.copyOf(omitted)), isCancelled);
    final float[] mixed = sum == null ? null : sum.clone();
    for (int i = on.nextSetBit(0); i >= 0 && mixed != null; i = on.nextSetBit(i + 1)) {
      final float[] part = part(new Part(i, depth, Set.copyOf(omitted)), isCancelled);
      if (part == null) {
        return null;
      }
      for (int k = 0; k < mixed.length; k++) {
        mixed[k] += part[k];
      }
    }
    return mixed == null ? null : picture(mixed);
  }

  private float[] part(final Part key, final BooleanSupplier isCancelled) {
    float[] part = radiances.get(key);
    if (part == null) {
      part = render(illumination(key.light, key.depth), key.omitted, isCancelled);
      if (part != null) {
        radiances.put(key, part);
      }
    }
    return part;
  }

  private Illumination illumination(final int light, final int depth) {
    final LightGroup lights = light == BACKGROUND ? new LightGroup()
        : new LightGroup(scene.lights().getLights().get(light));
    return new Illumination(scene.objects(), lights, depth, light == BACKGROUND ? scene.background() : Color.BLACK)
        .withExposure(scene.exposure());
  }

  /** Renders the radiance of all pixels; NaN where the ray hits nothing, null if cancelled. */
  private float[] render(final Illumination illumination, final Set<SelectiveSum.Effect> omitted,
      final BooleanSupplier isCancelled) {
    final float[] radiance = new float[3 * W * H];
    final RayGenerator generator = scene.camera().getRayGenerator(W, H);
    final boolean completed = IntStream.range(0, H).parallel().allMatch(n -> {
      for (int m = 0; m < W; m++) {
        final Ray ray = generator.getRay(m, n);
        final Hit hit = ray == Ray.NORAY ? Hit.NOHIT : scene.objects().intersectionWith(ray);
        final RadianceRGB L = hit.hits() ? radiance(illumination, ray, hit, omitted) : null;
        final int at = 3 * ((H - 1 - n) * W + m);
        radiance[at] = L == null ? Float.NaN : (float) L.getR();
        radiance[at + 1] = L == null ? Float.NaN : (float) L.getG();
        radiance[at + 2] = L == null ? Float.NaN : (float) L.getB();
      }
      return !isCancelled.getAsBoolean();
    });
    return completed ? radiance : null;
  }

  private static RadianceRGB radiance(final Illumination illumination, final Ray ray, final Hit hit,
      final Set<SelectiveSum.Effect> omitted) {
    if (omitted.isEmpty()) {
      return illumination.radiance(ray, hit, LightObserver.NONE);
    }
    final SelectiveSum observer = new SelectiveSum(omitted);
    illumination.radiance(ray, hit, observer);
    return observer.sum();
  }

  private BufferedImage picture(final float[] radiance) {
    final Illumination illumination = illumination(BACKGROUND, 0);
    final int background = scene.background().getRGB();
    final BufferedImage picture = new BufferedImage(W, H, BufferedImage.TYPE_INT_ARGB);
    for (int i = 0; i < W * H; i++) {
      picture.setRGB(i % W, i / W, Float.isNaN(radiance[3 * i]) ? background
          : illumination.argb(new RadianceRGB(radiance[3 * i], radiance[3 * i + 1], radiance[3 * i + 2])));
    }
    return picture;
  }
}
