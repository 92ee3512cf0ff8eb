package rendering;

import models.Group3D;
import tracer.Hit;
import tracer.Ray;
import tracer.RayGenerator;

/**
 * How a scene becomes a picture, pixel by pixel as the assignment says it: the ray of the pixel, its closest hit, the
 * colour of what is hit, or the background. This is what {@link TileRenderer} computes faster, bit for bit, and what a
 * debugger shows best: a breakpoint in the {@code intersectionWith} of a shape stops at each ray.
 */
final class PixelLoop {

  private final Group3D scene;
  private final RayGenerator generator;
  private final RenderSettings settings;
  private final int background;

  PixelLoop(final Group3D scene, final RayGenerator generator, final RenderSettings settings, final int background) {
    this.scene = scene;
    this.generator = generator;
    this.settings = settings;
    this.background = background;
  }

  /** Computes all pixels, the top row first; returns false if it was stopped before. */
  boolean run(final int[] pixels) {
    final int W = generator.getWidth(), H = generator.getHeight();
    for (int n = H - 1; n >= 0; n--) {
      for (int m = 0; m < W; m++) {
        pixels[(H - 1 - n) * W + m] = argb(m, n);
      }
      if (!settings.progress().tileDone(0, H - 1 - n, W, 1)) {
        return false;
      }
    }
    return true;
  }

  private int argb(final int m, final int n) {
    try {
      final Ray ray = generator.getRay(m, n);
      final Hit hit = scene.intersectionWith(ray);
      return hit.hits() ? settings.shading().argb(ray, hit) : background;
    } catch (RuntimeException | StackOverflowError failure) {
      throw new FailureLocator(scene, generator, settings.shading()).explain(failure, m, n, 1, 1);
    }
  }
}
