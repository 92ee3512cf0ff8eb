package rendering;

import java.util.List;

import models.Group3D;
import models.Object3D;
import tracer.Hit;
import tracer.Ray;
import tracer.RayGenerator;

/**
 * How a scene becomes a picture, pixel by pixel as the assignment describes it: the ray of the pixel, the closest of its
 * hits with all objects, the colour of what is hit, or the background. {@link TileRenderer} computes the same pixels
 * faster, bit for bit. For debuggers: a breakpoint in the {@code intersectionWith} of a shape stops at each ray.
 */
public final class PixelLoop {

  private final Group3D scene;
  private final RayGenerator generator;
  private final Progress progress;
  private final PixelWriter picture;

  /**
   * A renderer of one picture.
   *
   * @param scene the scene
   * @param generator the rays of the picture, which give its size
   * @param progress is notified of finished rows
   * @param picture receives each pixel
   */
  public PixelLoop(final Group3D scene, final RayGenerator generator, final Progress progress, final PixelWriter picture) {
    this.scene = scene;
    this.generator = generator;
    this.progress = progress;
    this.picture = picture;
  }

  /**
   * Computes all pixels, the top row first.
   *
   * @return false if the rendering was stopped before its end
   */
  public boolean run() {
    final int W = generator.getWidth(), H = generator.getHeight();
    final List<Object3D> objects = scene.getMembers();
    boolean goOn = true;
    for (int n = H - 1; n >= 0 && goOn; n--) {
      for (int m = 0; m < W; m++) {
        try {
          final Ray ray = generator.getRay(m, n);
          final Hit hit = closestHit(objects, ray);
          final int pixel = (H - 1 - n) * W + m;
          if (hit.hits()) {
            picture.hit(pixel, ray, hit);
          } else {
            picture.miss(pixel, ray);
          }
        } catch (RuntimeException | StackOverflowError failure) {
          throw new FailureLocator(scene, generator, picture).explain(failure, m, n, 1, 1);
        }
      }
      goOn = progress.tileDone(0, H - 1 - n, W, 1);
    }
    return goOn;
  }

  /** The closest hit of all objects; of two at the same distance, that of the object added first. */
  private static Hit closestHit(final List<Object3D> objects, final Ray ray) {
    Hit closest = Hit.NOHIT;
    for (final Object3D object : objects) {
      final Hit hit = object.intersectionWith(ray);
      closest = hit.isCloser(closest) ? hit : closest;
    }
    return closest;
  }
}
