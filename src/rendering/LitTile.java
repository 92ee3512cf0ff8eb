package rendering;

import acceleration.RayTile;
import acceleration.SegmentTile;
import materials.Material;
import materials.SpecularRays;
import models.TileHits;
import tracer.Hit;
import tracer.Ray;

/**
 * Shades the pixels of a tile under an {@link Illumination}: what the lights bring is found for all first hits together,
 * then mirrors and glass are followed pixel by pixel. One for each thread.
 */
final class LitTile {

  private static final int MOST = RayTile.SIZE * RayTile.SIZE;

  private final Illumination illumination;
  private final WhittedTracer tracer;
  private final TileSurfaces surfaces = new TileSurfaces();
  private final DirectLight light;
  private final SpecularRays specular = new SpecularRays();
  private final Ray[] rays = new Ray[MOST];
  private final Hit[] found = new Hit[MOST];
  /** The number of each pixel among the surfaces, −1 if its material does not scatter. */
  private final int[] numbers = new int[MOST];

  LitTile(final Illumination illumination) {
    this.illumination = illumination;
    this.tracer = illumination.tracer();
    this.light = new DirectLight(illumination, surfaces);
  }

  /** Finds the hits of a rectangle of pixels, no larger than {@link SegmentTile#SIZE}, and what the lights bring to them. */
  void prepare(final TileHits hits, final int first, final int width, final int height) {
    surfaces.clear();
    for (int row = 0; row < height; row++) {
      for (int i = first + row * RayTile.SIZE; i < first + row * RayTile.SIZE + width; i++) {
        found[i] = Hit.NOHIT;
        if (hits.hits(i)) {
          final Ray ray = hits.ray(i);
          prepare(i, ray, hits.hit(i, ray));
        }
      }
    }
    light.find();
  }

  private void prepare(final int i, final Ray ray, final Hit hit) {
    rays[i] = ray;
    found[i] = hit;
    numbers[i] = -1;
    if (hit.hits()) {
      final Material material = tracer.material(ray, hit);
      if (material.scatters()) {
        numbers[i] = surfaces.count();
        surfaces.add(ray, hit, material);
      }
    }
  }

  /** Whether a pixel's ray hits anything. */
  boolean hits(final int i) {
    return found[i].hits();
  }

  /** The hit of a pixel. */
  Hit hit(final int i) {
    return found[i];
  }

  /** Which of the first 64 lights bring something to a pixel: bit i stands for light i. */
  long lit(final int i) {
    return numbers[i] < 0 ? 0 : light.lit(numbers[i]);
  }

  /** Which of the first 64 lights would bring something to a pixel, but are blocked. */
  long shadowed(final int i) {
    return numbers[i] < 0 ? 0 : light.shadowed(numbers[i]);
  }

  /** The colour of a pixel that hits something. */
  int argb(final int i) {
    final int k = numbers[i];
    if (k < 0) {
      tracer.trace(rays[i], found[i], LightObserver.NONE);
    } else if (illumination.recursionDepth() > 0 && isSpecular(k)) {
      tracer.traceSpecular(rays[i], found[i], surfaces.materials[k], light.r(k), light.g(k), light.b(k));
    } else {
      return illumination.encoded(light.r(k), light.g(k), light.b(k));
    }
    return illumination.encoded(tracer.r(), tracer.g(), tracer.b());
  }

  private boolean isSpecular(final int k) {
    return surfaces.materials[k].specular(Math.max(0, Math.min(1, surfaces.cosine[k])), surfaces.outside[k], specular);
  }
}
