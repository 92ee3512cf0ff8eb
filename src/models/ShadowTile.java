package models;

import acceleration.SegmentTile;
import tracer.Ray;

/**
 * The shadow rays from the points that a tile of pixels sees to one light, and which of them are blocked: for each what
 * {@link Group3D#intersectAny} returns, found for all together. From the light's side they have nearly everything in
 * common, so boxes and triangles are left out for all of them at once; the rest is tested ray by ray, by the code for
 * single rays.
 *
 * <p>Usage: clear it, put in rays, and call {@link #findBlocked}. Not safe for use by several threads.
 */
public final class ShadowTile {

  /** Fewer rays are tested one by one. */
  private static final int FEW = 8;

  private final SegmentTile segments = new SegmentTile();
  private final Ray[] rays = new Ray[SegmentTile.MOST];
  private final double[] limits = new double[SegmentTile.MOST];
  private final boolean[] blocked = new boolean[SegmentTile.MOST];

  /** For rays in the frame of a transformed object, made once: those rays, and whose they are. */
  private ShadowTile nested;
  private final int[] outer = new int[SegmentTile.MOST];

  private int count;

  /** An empty tile. */
  public ShadowTile() {
  }

  /** Removes all rays. */
  public void clear() {
    count = 0;
    segments.clear();
  }

  /**
   * Puts in a shadow ray, which gets the next number, from 0.
   *
   * @param ray the ray, towards the light
   * @param distance distance of the light
   * @param tmax the distance before which a hit blocks the light, at most that of the light
   */
  public void put(final Ray ray, final double distance, final double tmax) {
    put(ray.startX(), ray.startY(), ray.startZ(), ray.directionX(), ray.directionY(), ray.directionZ(), distance, tmax);
    rays[count - 1] = ray;
  }

  /**
   * Puts in a shadow ray as plain numbers.
   *
   * @param x first coordinate of the start
   * @param y second coordinate of the start
   * @param z third coordinate of the start
   * @param dx first component of the direction, of unit length
   * @param dy second component of the direction
   * @param dz third component of the direction
   * @param distance distance of the light
   * @param tmax the distance before which a hit blocks the light, at most that of the light
   */
  public void put(final double x, final double y, final double z, final double dx, final double dy, final double dz,
      final double distance, final double tmax) {
    segments.add(x, y, z, dx, dy, dz, distance);
    rays[count] = null;
    limits[count] = tmax;
    blocked[count++] = false;
  }

  /** The ray with a number, created when first needed. */
  private Ray ray(final int i) {
    if (rays[i] == null) {
      rays[i] = Ray.exactly(segments.startX(i), segments.startY(i), segments.startZ(i),
          segments.directionX(i), segments.directionY(i), segments.directionZ(i));
    }
    return rays[i];
  }

  /**
   * Finds the rays that are blocked.
   *
   * @param scene the objects that block them
   */
  public void findBlocked(final Group3D scene) {
    findBlocked(scene, 0, count);
  }

  /** Tests the rays of some numbers together, or by halves if they have neither an end nor a direction in common. */
  private void findBlocked(final Object3D scene, final int first, final int end) {
    if (end - first < FEW) {
      for (int i = first; i < end; i++) {
        blocked[i] = scene.intersectsBefore(ray(i), limits[i]);
      }
    } else if (segments.close(first, end)) {
      segments.selectAll();
      scene.block(this);
    } else {
      final int middle = first + end >>> 1;
      findBlocked(scene, first, middle);
      findBlocked(scene, middle, end);
    }
  }

  /**
   * Whether a shadow ray is blocked.
   *
   * @param i number of the ray
   * @return false if it is not
   */
  public boolean isBlocked(final int i) {
    return blocked[i];
  }

  SegmentTile segments() {
    return segments;
  }

  double limit(final int i) {
    return limits[i];
  }

  void block(final int i) {
    blocked[i] = true;
    segments.block(i);
  }

  /** Tests an object against the rays that it may block. */
  void ask(final Object3D object) {
    for (int word = 0; word < SegmentTile.WORDS; word++) {
      for (long bits = segments.candidates(word); bits != 0; bits &= bits - 1) {
        final int i = word * Long.SIZE + Long.numberOfTrailingZeros(bits);
        final double t = object.distance(segments.startX(i), segments.startY(i), segments.startZ(i),
            segments.directionX(i), segments.directionY(i), segments.directionZ(i));
        if (Double.isNaN(t) ? object.intersectsBefore(ray(i), limits[i]) : t > 0 && t < limits[i]) {
          block(i);
        }
      }
    }
  }

  /** Asks a transformed object about the rays that it may block, all of them together in its frame. */
  void askInFrame(final AffineTransformation transformed) {
    if (nested == null) {
      nested = new ShadowTile();
    }
    nested.clear();
    for (int word = 0; word < SegmentTile.WORDS; word++) {
      for (long bits = segments.candidates(word); bits != 0; bits &= bits - 1) {
        final int i = word * Long.SIZE + Long.numberOfTrailingZeros(bits);
        nested.outer[nested.count] = i;
        if (rays[i] == null) {
          transformed.putInFrame(nested, segments.startX(i), segments.startY(i), segments.startZ(i), segments.directionX(i),
              segments.directionY(i), segments.directionZ(i), segments.length(i), limits[i]);
        } else {
          transformed.putInFrame(nested, rays[i], segments.length(i), limits[i]);
        }
      }
    }
    nested.findBlocked(transformed.asked(), 0, nested.count);
    for (int k = 0; k < nested.count; k++) {
      if (nested.blocked[k]) {
        block(nested.outer[k]);
      }
    }
  }
}
