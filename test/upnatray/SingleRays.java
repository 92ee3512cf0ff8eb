package upnatray;

import models.Object3D;
import rendering.Shading;
import tracer.Hit;
import tracer.Ray;
import tracer.RayGenerator;
import view.Camera;

/** The image of a scene pixel by pixel, as the assignment describes it, by one thread and single rays. */
final class SingleRays {

  private SingleRays() {
  }

  /** Colours in the order of the {@code BufferedImage}: rows from the top. */
  static int[] pixels(final Object3D scene, final Camera camera, final int W, final int H, final int background,
      final Shading shading) {
    final RayGenerator generator = camera.getRayGenerator(W, H);
    final int[] pixels = new int[W * H];
    for (int n = 0; n < H; n++) {
      for (int m = 0; m < W; m++) {
        final Ray ray = generator.getRay(m, n);
        final Hit hit = scene.intersectionWith(ray);
        pixels[(H - 1 - n) * W + m] = hit.hits() ? shading.argb(ray, hit) : background;
      }
    }
    return pixels;
  }
}
