package upnatray;

import models.Group3D;
import models.Object3D;
import rendering.PixelLoop;
import rendering.Progress;
import rendering.RenderSettings;
import rendering.Shading;
import view.Camera;

/** The image of a scene by {@link PixelLoop}, the oracle of all that is faster. */
final class SingleRays {

  private SingleRays() {
  }

  /** Colours in the order of the {@code BufferedImage}: rows from the top. */
  static int[] pixels(final Object3D scene, final Camera camera, final int W, final int H, final int background,
      final Shading shading) {
    final Group3D group = new Group3D();
    group.addObject(scene);
    final int[] pixels = new int[W * H];
    new PixelLoop(group, camera.getRayGenerator(W, H), Progress.NONE,
        RenderSettings.STANDARD.withShading(shading).colours(pixels, background)).run();
    return pixels;
  }
}
