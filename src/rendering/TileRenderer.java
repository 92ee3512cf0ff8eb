package rendering;

import java.util.concurrent.ThreadFactory;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;

import acceleration.RayTile;
import acceleration.SegmentTile;
import models.Group3D;
import models.Object3D;
import models.TileHits;
import tracer.Hit;
import tracer.Ray;
import tracer.RayGenerator;

/**
 * Renders one image: its tiles of 32 × 32 pixels are distributed among threads, each of which takes the next one. Every
 * pixel depends on its own ray alone, so the threads share nothing but the number of the next tile.
 */
public final class TileRenderer {

  private final Group3D scene;
  private final RayGenerator generator;
  private final RenderSettings rendering;
  private final PixelWriter picture;
  private final int W;
  private final int H;
  private final int across;
  private final int tiles;
  /** The order in which the tiles are computed; null for that of their numbers, without an observer. */
  private final int[] order;
  private final AtomicInteger next = new AtomicInteger();
  private final AtomicReference<Throwable> failure = new AtomicReference<>();
  private volatile boolean stopped;

  /**
   * A renderer of one picture.
   *
   * @param scene the scene
   * @param generator the rays of the picture, which give its size
   * @param rendering number of threads, and observer
   * @param picture what becomes of each pixel
   */
  public TileRenderer(final Group3D scene, final RayGenerator generator, final RenderSettings rendering,
      final PixelWriter picture) {
    this.scene = scene;
    this.generator = generator;
    this.rendering = rendering;
    this.picture = picture;
    this.W = generator.getWidth();
    this.H = generator.getHeight();
    this.across = (W + RayTile.SIZE - 1) / RayTile.SIZE;
    this.tiles = Math.multiplyExact(across, (H + RayTile.SIZE - 1) / RayTile.SIZE);
    this.order = rendering.progress() == Progress.NONE ? null : TileOrder.centreOutwards(across, tiles / across);
  }

  /**
   * Computes all pixels, on the calling thread and others.
   *
   * @param factory makes the other threads
   * @return false if the rendering was stopped before its end
   */
  public boolean run(final ThreadFactory factory) {
    Workers.run(Math.min(rendering.threads(), tiles), factory, this::work);
    Workers.rethrow(failure.get());
    return !stopped;
  }

  private void work() {
    try {
      final RayTile rays = new RayTile();
      final TileHits hits = new TileHits(rays);
      final LitTile lit = picture instanceof ColourWriter colours ? colours.litTile() : null;
      for (int i = next.getAndIncrement(); i < tiles && !stopped; i = next.getAndIncrement()) {
        final int tile = order == null ? i : order[i];
        compute(tile % across * RayTile.SIZE, tile / across * RayTile.SIZE, rays, hits, lit);
      }
    } catch (Throwable e) {
      failure.compareAndSet(null, e);
      stopped = true;
    }
  }

  /** Computes the tile whose lowest leftmost pixel is (m, n). */
  private void compute(final int m, final int n, final RayTile rays, final TileHits hits, final LitTile lit) {
    final int width = Math.min(RayTile.SIZE, W - m), height = Math.min(RayTile.SIZE, H - n);
    try {
      rays.open(width, height);
      generator.fill(rays, m, n);
      rays.close();
      final boolean wanted = !(generator instanceof MaskedRays masked) || masked.mask(rays, m, n);
      hits.clear();
      if (wanted) {
        scene.closestHits(rays, hits);
      }
      if (lit == null) {
        paint(hits, null, 0, width, height, (H - 1 - n) * W + m);
      } else {
        paintLit(hits, lit, width, height, (H - 1 - n) * W + m);
      }
    } catch (RuntimeException | StackOverflowError e) {
      throw new FailureLocator(scene, generator, picture).explain(e, m, n, width, height);
    }
    if (!rendering.progress().tileDone(m, H - n - height, width, height)) {
      stopped = true;
    }
  }

  /** Lights and paints parts of a tile: as many pixels at a time as share their shadow queries. */
  private void paintLit(final TileHits hits, final LitTile lit, final int width, final int height, final int at) {
    for (int row = 0; row < height; row += SegmentTile.SIZE) {
      for (int column = 0; column < width; column += SegmentTile.SIZE) {
        final int first = row * RayTile.SIZE + column;
        final int across = Math.min(SegmentTile.SIZE, width - column), up = Math.min(SegmentTile.SIZE, height - row);
        lit.prepare(hits, first, across, up);
        paint(hits, lit, first, across, up, at - row * W + column);
      }
    }
  }

  private void paint(final TileHits hits, final LitTile lit, final int first, final int width, final int height,
      final int at) {
    for (int row = 0; row < height; row++) {
      paintRow(hits, lit, first + row * RayTile.SIZE, width, at - row * W);
    }
  }

  private void paintRow(final TileHits hits, final LitTile lit, final int first, final int width, final int at) {
    if (lit == null && picture instanceof ColourWriter colours && colours.isPlain()) {
      colours.paint(at, hits, first, width);
    } else if (lit != null && picture instanceof ColourWriter colours) {
      for (int i = first; i < first + width; i++) {
        if (lit.hits(i)) {
          colours.paint(at + i - first, hits, i, lit);
        } else {
          colours.miss(at + i - first, Ray.NORAY);
        }
      }
    } else {
      for (int i = 0; i < width; i++) {
        final Ray ray = hits.isPresent(first + i) ? hits.ray(first + i) : Ray.NORAY;
        write(at + i, ray, hits.hit(first + i), hits.object(first + i));
      }
    }
  }

  /** A hit that overflows float counts as a miss. */
  private void write(final int pixel, final Ray ray, final Hit hit, final Object3D object) {
    if (!hit.hits()) {
      picture.miss(pixel, ray);
    } else if (picture instanceof ColourWriter colours) {
      colours.hit(pixel, ray, hit, object);
    } else {
      picture.hit(pixel, ray, hit);
    }
  }
}
