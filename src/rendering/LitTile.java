package rendering;

import acceleration.RayTile;
import acceleration.SegmentTile;
import materials.Material;
import materials.SpecularRays;
import models.TileHits;
import tracer.Hit;
import tracer.Ray;

/**
 * Shades the pixels of a tile under an {@link Illumination}: direct light is computed for all first hits together, then
 * mirrors and glass are followed pixel by pixel, and what the lights bring to the surfaces seen in them is found for many
 * of those together. One for each thread.
 */
final class LitTile {

  private static final int MOST = RayTile.SIZE * RayTile.SIZE;

  private final Illumination illumination;
  private final WhittedTracer tracer;
  private final TileSurfaces surfaces = new TileSurfaces();
  private final DirectLight light;
  private final DeferredLight deferred;
  private final TracerCalls calls;
  private final ViewedSurface viewed = new ViewedSurface();
  private final SpecularRays specular = new SpecularRays();
  private final Ray[] rays = new Ray[MOST];
  private final Hit[] found = new Hit[MOST];
  private final Material[] materials = new Material[MOST];
  /** The number of the surface of each pixel; −1 if its material does not scatter. */
  private final int[] numbers = new int[MOST];

  LitTile(final Illumination illumination) {
    this.illumination = illumination;
    this.tracer = illumination.tracer();
    this.light = new DirectLight(illumination, surfaces);
    this.deferred = new DeferredLight(illumination);
    this.calls = new TracerCalls(illumination.scene());
  }

  /** Finds the hits of a rectangle of pixels, no larger than {@link SegmentTile#SIZE}, and their radiances. */
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
    for (int row = 0; row < height; row++) {
      for (int i = first + row * RayTile.SIZE; i < first + row * RayTile.SIZE + width; i++) {
        if (found[i].hits()) {
          follow(i);
        }
      }
    }
    deferred.find();
  }

  private void prepare(final int i, final Ray ray, final Hit hit) {
    rays[i] = ray;
    found[i] = hit;
    numbers[i] = -1;
    if (hit.hits()) {
      materials[i] = calls.material(ray, hit);
      if (materials[i].scatters()) {
        numbers[i] = surfaces.count();
        viewed.set(ray, hit);
        surfaces.add(ray, hit, viewed, materials[i]);
      }
    }
  }

  /** Follows the rays that leave the surface of a pixel, to what is added to what its lights bring. */
  private void follow(final int i) {
    final int k = numbers[i];
    deferred.begin(i, k < 0 ? 0 : light.r(k), k < 0 ? 0 : light.g(k), k < 0 ? 0 : light.b(k));
    if (illumination.recursionDepth() > 0 && (k < 0 || calls.findSpecular(materials[i], rays[i], surfaces.cosine[k],
        surfaces.outside[k], specular))) {
      tracer.traceSpecular(rays[i], found[i], materials[i], deferred);
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

  /** The first 64 lights that contribute to a pixel: bit i for light i. */
  long lit(final int i) {
    return numbers[i] < 0 ? 0 : light.lit(numbers[i]);
  }

  /** The first 64 lights that would contribute to a pixel, but are blocked. */
  long shadowed(final int i) {
    return numbers[i] < 0 ? 0 : light.shadowed(numbers[i]);
  }

  /** The colour of a pixel that hits something. */
  int argb(final int i) {
    return illumination.encoded(deferred.r(i), deferred.g(i), deferred.b(i));
  }
}
