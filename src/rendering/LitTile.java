package rendering;

import acceleration.RayTile;
import acceleration.SegmentTile;
import models.TileHits;
import tracer.Hit;
import tracer.Ray;

/**
 * Shades the pixels of a tile under an {@link Illumination}: the shadow rays of the first hits are asked light by light, all
 * pixels of the tile together, and then each pixel is shaded as it is alone. One for each thread.
 */
final class LitTile {

  private final Illumination illumination;
  private final WhittedTracer tracer;
  private final Ray[] rays = new Ray[RayTile.SIZE * RayTile.SIZE];
  private final Hit[] found = new Hit[RayTile.SIZE * RayTile.SIZE];

  LitTile(final Illumination illumination) {
    this.illumination = illumination;
    this.tracer = illumination.tracer();
  }

  /** Finds the hits of a rectangle of pixels, no larger than {@link SegmentTile#SIZE}, and which shadow rays are blocked. */
  void prepare(final TileHits hits, final int first, final int width, final int height) {
    tracer.clearShadows();
    for (int row = 0; row < height; row++) {
      for (int i = first + row * RayTile.SIZE; i < first + row * RayTile.SIZE + width; i++) {
        found[i] = Hit.NOHIT;
        if (hits.hits(i)) {
          rays[i] = hits.ray(i);
          found[i] = hits.hit(i);
          tracer.castShadows(i, rays[i], found[i]);
        }
      }
    }
    tracer.findShadows();
  }

  /** Whether a pixel's ray hits anything. */
  boolean hits(final int i) {
    return found[i].hits();
  }

  /** The hit of a pixel. */
  Hit hit(final int i) {
    return found[i];
  }

  /** What was traced last. */
  WhittedTracer tracer() {
    return tracer;
  }

  /** The colour of a pixel that hits something. */
  int argb(final int i) {
    tracer.trace(i, rays[i], found[i]);
    return illumination.encoded(tracer.r(), tracer.g(), tracer.b());
  }
}
