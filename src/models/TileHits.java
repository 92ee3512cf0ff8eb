package models;

import java.util.Arrays;

import acceleration.RayTile;
import tracer.Hit;
import tracer.Ray;

/**
 * The closest hits found so far for the rays of a tile: for each its distance, the object that answered and what is to be
 * painted. Nothing is allocated for a hit unless {@link #hit} is called. Not safe for use by several threads.
 *
 * <p>Distances are compared as floats, as {@link Hit#isCloser} compares them, and of two at the same distance the
 * one of the object first added to the group wins, whatever the order in which they are found: so a picture does not depend
 * on how it was computed.
 */
public final class TileHits {

  private final RayTile rays;

  /** Whether the rays are those of a transformed object's frame, whose directions are not rounded to floats. */
  private final boolean isNested;

  private final double[] t = new double[RayTile.SIZE * RayTile.SIZE];
  /** The distances as floats, by which they are compared. */
  private final float[] compared = new float[RayTile.SIZE * RayTile.SIZE];
  private final int[] order = new int[RayTile.SIZE * RayTile.SIZE];
  private final int[] part = new int[RayTile.SIZE * RayTile.SIZE];
  private final Object3D[] owner = new Object3D[RayTile.SIZE * RayTile.SIZE];
  private final Object3D[] painted = new Object3D[RayTile.SIZE * RayTile.SIZE];
  private final Hit[] hit = new Hit[RayTile.SIZE * RayTile.SIZE];

  /** For each row a pixel whose hit is the farthest of the row; rows where that may have changed are marked. */
  private final int[] farthestOfRow = new int[RayTile.SIZE];
  private int changedRows;
  private double farthest;

  private Class<?> lastClass;
  private boolean lastIsPatterned;
  private int currentOrder;
  private TileHits nested;

  /**
   * Hits for the rays of a tile, to be used again each time that the tile is filled.
   *
   * @param rays the tile
   */
  public TileHits(final RayTile rays) {
    this(rays, false);
  }

  private TileHits(final RayTile rays, final boolean nested) {
    this.rays = rays;
    this.isNested = nested;
  }

  /** Forgets all hits, for the rays that the tile holds now. A pixel without a ray gets distance 0: nothing is closer. */
  public void clear() {
    Arrays.fill(owner, null);
    Arrays.fill(compared, 0);
    for (int row = 0; row < rays.rows(); row++) {
      for (int i = row * RayTile.SIZE; i < row * RayTile.SIZE + rays.columns(); i++) {
        compared[i] = rays.isPresent(i) ? Float.POSITIVE_INFINITY : 0;
        order[i] = -1;
      }
    }
    changedRows = -1 >>> 32 - rays.rows();
    currentOrder = 0;
  }

  /** Says which object of the group will make the next offers, as its number in the order of adding. */
  void setOrder(final int order) {
    currentOrder = order;
  }

  /** Offers what an object without parts answered for a ray; if that is NaN, the object is asked for the hit itself. */
  void offer(final int i, final double distance, final Object3D object) {
    if (Double.isNaN(distance)) {
      askFor(i, object);
    } else if (isCloser(i, distance, 0)) {
      take(i, distance, object, object, 0);
    }
  }

  /** Asks an object for the hit of ray i, unless the pixel has none. */
  private void askFor(final int i, final Object3D object) {
    if (rays.isPresent(i)) {
      offer(i, Object3D.askFor(object, ray(i)), object);
    }
  }

  /** Asks an object about the ray i alone. */
  void offer(final int i, final Ray ray, final Object3D object) {
    final double distance = object.distance(rays.startX(i), rays.startY(i), rays.startZ(i),
        rays.directionX(i), rays.directionY(i), rays.directionZ(i));
    if (Double.isNaN(distance)) {
      offer(i, Object3D.askFor(object, ray), object);
    } else {
      offer(i, distance, object);
    }
  }

  private void offer(final int i, final Hit found, final Object3D object) {
    if (isCloser(i, found.distance(), 0)) {
      take(i, found.distance(), object, found.getObject(), 0);
      hit[i] = found;
    }
  }

  /** Whether a hit would replace the one that ray i has. */
  boolean isCloser(final int i, final double distance, final int itsPart) {
    final float f = (float) distance, best = compared[i];
    return f > 0 && (f < best
        || f == best && (currentOrder < order[i] || currentOrder == order[i] && itsPart < part[i]));
  }

  /** Takes a hit that {@link #isCloser} approved: who answers for it, and what is to be painted. */
  void take(final int i, final double distance, final Object3D itsOwner, final Object3D itsPainted, final int itsPart) {
    t[i] = distance;
    compared[i] = (float) distance;
    order[i] = currentOrder;
    part[i] = itsPart;
    if (owner[i] != itsOwner || painted[i] != itsPainted || hit[i] != null) {
      owner[i] = itsOwner;
      painted[i] = itsPainted;
      hit[i] = null;
    }
    if (farthestOfRow[i / RayTile.SIZE] == i) {
      changedRows |= 1 << i / RayTile.SIZE;
    }
  }

  /** Distance beyond which no hit can be closer for any ray of the tile. */
  double farthest() {
    if (changedRows != 0) {
      float most = 0;
      for (int row = 0; row < rays.rows(); row++) {
        if ((changedRows >> row & 1) != 0) {
          farthestOfRow[row] = farthestOf(row);
        }
        most = Math.max(most, compared[farthestOfRow[row]]);
      }
      changedRows = 0;
      farthest = most * ClosestHit.SAME;
    }
    return farthest;
  }

  /** Distance beyond which no hit can be closer for ray i. */
  double farthest(final int i) {
    return compared[i] * ClosestHit.SAME;
  }

  private int farthestOf(final int row) {
    int most = row * RayTile.SIZE;
    for (int i = most + 1; i < row * RayTile.SIZE + rays.columns(); i++) {
      most = compared[i] > compared[most] ? i : most;
    }
    return most;
  }

  /**
   * Whether a ray meets anything.
   *
   * @param i number of the pixel, column + SIZE · row
   * @return false for a pixel without a ray
   */
  public boolean hits(final int i) {
    return owner[i] != null;
  }

  /**
   * Colour of what a ray meets.
   *
   * @param i number of the pixel; {@link #hits} must be true
   * @return sRGB with alpha
   */
  public int argb(final int i) {
    if (isPatterned(painted[i])) {
      final Hit found = hit(i);
      return found.getObject().getColorAt(found).getRGB();
    }
    return painted[i].argb(part[i]);
  }

  /** Remembers the last class: neighbours mostly show the same. */
  private boolean isPatterned(final Object3D object) {
    if (object.getClass() != lastClass) {
      lastClass = object.getClass();
      lastIsPatterned = Object3D.isPatterned(lastClass);
    }
    return lastIsPatterned || object.isTextured();
  }

  /**
   * The ray of a pixel.
   *
   * @param i number of the pixel, which must have a ray
   * @return the ray, made anew
   */
  public Ray ray(final int i) {
    return isNested ? Ray.exactly(rays.startX(i), rays.startY(i), rays.startZ(i),
        rays.directionX(i), rays.directionY(i), rays.directionZ(i))
        : Ray.along(rays.startX(i), rays.startY(i), rays.startZ(i), rays.vx(i), rays.vy(i), rays.vz(i));
  }

  /**
   * The whole hit of a ray: what the group's {@code intersectionWith} answers for it.
   *
   * @param i number of the pixel
   * @return the hit, or {@link Hit#NOHIT}
   */
  public Hit hit(final int i) {
    if (!hits(i)) {
      return Hit.NOHIT;
    }
    return hit[i] != null ? hit[i] : owner[i].hitAt(ray(i), t[i], part[i]);
  }

  RayTile rays() {
    return rays;
  }

  /** Rays and hits for the frame of a transformed object, made once. */
  TileHits nested() {
    if (nested == null) {
      nested = new TileHits(new RayTile(), true);
    }
    return nested;
  }

  double distance(final int i) {
    return t[i];
  }

  Object3D painted(final int i) {
    return painted[i];
  }

  int part(final int i) {
    return part[i];
  }
}
