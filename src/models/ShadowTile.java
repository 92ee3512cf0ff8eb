package models;

import java.util.Arrays;

import acceleration.RayTile;
import acceleration.SegmentTile;
import tracer.Ray;

/**
 * The shadow rays from the points that a tile of pixels sees to one light, and which of them are blocked: for each what
 * {@link Group3D#intersectAny} returns, found for all together. From the light's side they have nearly everything in common,
 * so boxes and triangles are left out for all of them at once; what remains is asked ray by ray, by the same code as a ray
 * alone.
 *
 * <p>Who uses one clears it, puts in rays and calls {@link #findBlocked}. Not safe for use by several threads.
 */
public final class ShadowTile {

  /** Triangles for each ray that may be looked at together; if there are more, a part of the rays is quicker. */
  private static final int WORTHWHILE = 2;

  /** How many triangles an object of a group counts for. */
  private static final int OBJECT = 4;

  private static final int QUARTERS = 4;

  private final SegmentTile segments = new SegmentTile();
  private final Ray[] rays = new Ray[SegmentTile.SIZE * SegmentTile.SIZE];
  private final double[] lengths = new double[SegmentTile.SIZE * SegmentTile.SIZE];
  private final double[] limits = new double[SegmentTile.SIZE * SegmentTile.SIZE];
  private final boolean[] present = new boolean[SegmentTile.SIZE * SegmentTile.SIZE];
  private final boolean[] blocked = new boolean[SegmentTile.SIZE * SegmentTile.SIZE];

  private int count;
  private int visited;

  /** An empty tile. */
  public ShadowTile() {
  }

  /** Removes all rays. */
  public void clear() {
    count = 0;
    visited = 0;
    segments.clear();
    Arrays.fill(present, false);
    Arrays.fill(blocked, false);
  }

  /**
   * Puts in the shadow ray of a pixel.
   *
   * @param pixel number of the pixel, column + {@link RayTile#SIZE} · row
   * @param ray the ray, towards the light
   * @param distance distance of the light
   * @param tmax the distance before which a hit blocks the light, at most that of the light
   */
  public void put(final int pixel, final Ray ray, final double distance, final double tmax) {
    final int i = SegmentTile.number(pixel);
    rays[i] = ray;
    limits[i] = tmax;
    lengths[i] = distance;
    present[i] = true;
    add(i);
  }

  /**
   * Finds the rays that are blocked.
   *
   * @param scene the objects that block them
   */
  public void findBlocked(final Group3D scene) {
    if (!isFoundTogether(scene)) {
      for (int quarter = 0; quarter < QUARTERS; quarter++) {
        takeQuarter(quarter);
        if (!isFoundTogether(scene)) {
          findOneByOne(scene);
        }
      }
    }
  }

  /** Asks the scene about all segments that are in the tile; returns whether that was not given up. */
  private boolean isFoundTogether(final Group3D scene) {
    visited = 0;
    if (count == 0) {
      return true;
    }
    if (!segments.close()) {
      return false;
    }
    scene.block(this);
    return !isTooWide();
  }

  /** Puts the rays of a quarter of the tile, of 8 × 8 pixels, that are not blocked into it. */
  private void takeQuarter(final int quarter) {
    segments.clear();
    count = 0;
    for (int i = 0; i < rays.length; i++) {
      if ((i >> 5 & 1 | i >> 6 & 2) == quarter && present[i] && !blocked[i]) {
        add(i);
      }
    }
  }

  private void add(final int i) {
    final Ray ray = rays[i];
    segments.add(i, ray.startX(), ray.startY(), ray.startZ(), ray.directionX(), ray.directionY(), ray.directionZ(),
        lengths[i]);
    count++;
  }

  private void findOneByOne(final Group3D scene) {
    for (int block = 0; block < SegmentTile.BLOCK; block++) {
      for (int bits = segments.open(block); bits != 0; bits &= bits - 1) {
        final int i = block * SegmentTile.BLOCK + Integer.numberOfTrailingZeros(bits);
        blocked[i] = scene.intersectAny(rays[i], limits[i]);
      }
    }
  }

  /** Counts triangles that were looked at for all rays; if they become too many, the rays have too little in common. */
  void visitTriangles(final int number) {
    visited += number;
  }

  /** Counts objects, as triangles are. */
  void visitObjects(final int number) {
    visited += OBJECT * number;
  }

  /** Whether the rays that are left are better asked one by one. */
  boolean isTooWide() {
    return visited > WORTHWHILE * count;
  }

  /** What is still to be looked at: nothing once it is too much. */
  double farthest() {
    return isTooWide() ? Double.NEGATIVE_INFINITY : segments.limit();
  }

  /**
   * Whether the shadow ray of a pixel was put in.
   *
   * @param pixel number of the pixel
   * @return false if it was not
   */
  public boolean holds(final int pixel) {
    return present[SegmentTile.number(pixel)];
  }

  /**
   * Whether the shadow ray of a pixel is blocked.
   *
   * @param pixel number of the pixel
   * @return false if it is not, or was not put in
   */
  public boolean isBlocked(final int pixel) {
    return blocked[SegmentTile.number(pixel)];
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

  /** Asks an object about all rays on which the frustum's last projection may lie. */
  void ask(final Object3D object) {
    for (int block = 0; block < SegmentTile.BLOCK; block++) {
      for (int bits = segments.candidates(block); bits != 0; bits &= bits - 1) {
        final int i = block * SegmentTile.BLOCK + Integer.numberOfTrailingZeros(bits);
        if (segments.isCandidate(i) && object.intersectsBefore(rays[i], limits[i])) {
          block(i);
        }
      }
    }
  }
}
