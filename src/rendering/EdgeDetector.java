package rendering;

import models.Group3D;
import models.Object3D;
import models.TileHits;
import tracer.Hit;
import tracer.Ray;

/**
 * Writes colours, remembers which object each pixel shows and which lights reach it there, and so finds the edges between
 * pixels; see {@link AdaptiveSampling}. For one thread.
 */
final class EdgeDetector extends ColourWriter {

  private final Group3D scene;
  private final int[] pixels;
  private final Object3D[] objects;
  private final long[] lit;
  private final long[] shadowed;
  /** For pixels that belong to no tile; null if pixels do not show light. */
  private final WhittedTracer tracer;
  private final Illumination illumination;

  /** A writer into an array of sRGB with alpha, the top row first. */
  EdgeDetector(final Group3D scene, final Shading shading, final int[] pixels, final int background) {
    super(shading, pixels, background);
    this.scene = scene;
    this.pixels = pixels;
    this.objects = new Object3D[pixels.length];
    this.illumination = shading instanceof Illumination light ? light : null;
    this.tracer = illumination == null ? null : illumination.tracer();
    this.lit = new long[illumination == null ? 0 : pixels.length];
    this.shadowed = new long[lit.length];
  }

  @Override
  public void hit(final int pixel, final Ray ray, final Hit hit) {
    hit(pixel, ray, hit, scene.objectHitBy(ray));
  }

  @Override
  void hit(final int pixel, final Ray ray, final Hit hit, final Object3D object) {
    if (tracer == null) {
      super.hit(pixel, ray, hit);
    } else {
      tracer.trace(ray, hit, LightObserver.NONE);
      pixels[pixel] = illumination.encoded(tracer.r(), tracer.g(), tracer.b());
      keepLights(pixel, tracer.lit(), tracer.shadowed());
    }
    objects[pixel] = object;
  }

  @Override
  public void miss(final int pixel, final Ray ray) {
    super.miss(pixel, ray);
    objects[pixel] = null;
    keepLights(pixel, 0, 0);
  }

  @Override
  void paint(final int at, final TileHits hits, final int first, final int width) {
    super.paint(at, hits, first, width);
    for (int i = 0; i < width; i++) {
      objects[at + i] = hits.hits(first + i) ? hits.object(first + i) : null;
    }
  }

  @Override
  void paint(final int pixel, final TileHits hits, final int i, final LitTile tile) {
    super.paint(pixel, hits, i, tile);
    objects[pixel] = hits.object(i);
    keepLights(pixel, tile.lit(i), tile.shadowed(i));
  }

  private void keepLights(final int pixel, final long itsLit, final long itsShadowed) {
    if (tracer != null) {
      lit[pixel] = itsLit;
      shadowed[pixel] = itsShadowed;
    }
  }

  /** Whether two pixels differ so much that an edge between them can be seen. */
  boolean isEdge(final int p, final int q) {
    final int difference = difference(pixels[p], pixels[q]);
    return difference > AdaptiveSampling.STEP || difference > AdaptiveSampling.EDGE
        && (objects[p] != objects[q] || tracer != null && ((lit[p] & shadowed[q]) | (shadowed[p] & lit[q])) != 0);
  }

  /** The difference of two colours in that channel, of alpha too, in which it is greatest. */
  private static int difference(final int p, final int q) {
    int most = 0;
    for (int shift = 0; shift < Integer.SIZE && p != q; shift += Byte.SIZE) {
      most = Math.max(most, Math.abs((p >> shift & 0xff) - (q >> shift & 0xff)));
    }
    return most;
  }
}
