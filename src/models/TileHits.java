package models;

import java.util.Arrays;

import acceleration.RayTile;
import tracer.Hit;
import tracer.Ray;

/**
 * The closest hits found so far for the rays of a tile: for each its distance, the object that was hit, and the part that
 * is to be painted. Nothing is allocated for a hit unless {@link #hit} is called. Not safe for use by several threads.
 *
 * <p>Distances are compared as floats, as {@link Hit#isCloser} compares them, and of two at the same distance the
 * one of the object first added to the group wins, whatever the order in which they are found: so a picture does not depend
 * on how it was computed.
 */
public final class TileHits {

  private static final int INFINITE = Float.floatToRawIntBits(Float.POSITIVE_INFINITY);

  private final RayTile rays;

  /** Whether the rays are those of a transformed object's frame, whose directions are not rounded to floats. */
  private final boolean isNested;

  private final double[] t = new double[RayTile.SIZE * RayTile.SIZE];

  /**
   * The distances by which hits are compared, as the bits of floats: the order of positive floats is that of their bits, and
   * what is not positive has bits that are not either, but for a NaN, whose bits are greater than those of infinity.
   */
  private final int[] compared = new int[RayTile.SIZE * RayTile.SIZE];
  private final int[] source = new int[RayTile.SIZE * RayTile.SIZE];
  private final int[] part = new int[RayTile.SIZE * RayTile.SIZE];
  private final HitSources sources = new HitSources();

  /** The hits that user-written objects returned; null if none did. */
  private Hit[] returned;

  /** For each row the farthest of its hits, unless the row is marked: then it may have come nearer. */
  private final int[] farthestOfRow = new int[RayTile.SIZE];
  private int changedRows;
  private double farthest;

  /** Number of rays that have no hit yet. */
  private int open;

  private int currentOrder;
  private TileHits nested;

  /**
   * Hits for the rays of a tile, reused each time that the tile is filled.
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

  /** Clears all hits, for the rays that the tile has now. A pixel without a ray gets distance 0: nothing is closer. */
  public void clear() {
    Arrays.fill(source, 0);
    sources.clear();
    returned = null;
    open = RayTile.SIZE * rays.rows();
    Arrays.fill(compared, 0, open, INFINITE);
    for (int i = 0; !rays.isComplete() && i < RayTile.SIZE * rays.rows(); i++) {
      if (!rays.isPresent(i)) {
        compared[i] = 0;
        open--;
      }
    }
    changedRows = -1 >>> 32 - rays.rows();
    currentOrder = 0;
  }

  /** Sets the object of the group that makes the next offers, as its number in the order of adding. */
  void setOrder(final int order) {
    currentOrder = order;
  }

  /** Asks an object for the hit of ray i, if there is one. */
  void askFor(final int i, final Object3D object) {
    if (rays.isPresent(i)) {
      offer(i, Object3D.askFor(object, ray(i)), object);
    }
  }

  /** Tests an object against the single ray i. */
  void offer(final int i, final Ray ray, final Object3D object) {
    final double distance = object.distance(rays.startX(i), rays.startY(i), rays.startZ(i),
        rays.directionX(i), rays.directionY(i), rays.directionZ(i));
    if (Double.isNaN(distance)) {
      offer(i, Object3D.askFor(object, ray), object);
    } else if (isCloser(i, distance, 0)) {
      take(i, distance, source(object, object), 0);
    }
  }

  private void offer(final int i, final Hit found, final Object3D object) {
    if (isCloser(i, found.distance(), 0)) {
      take(i, found.distance(), source(object, found.getObject()), 0);
      if (returned == null) {
        returned = new Hit[RayTile.SIZE * RayTile.SIZE];
      }
      returned[i] = found;
    }
  }

  /** Whether a hit would replace the one that ray i has. */
  boolean isCloser(final int i, final double distance, final int itsPart) {
    final int f = Float.floatToRawIntBits((float) distance), best = compared[i];
    return f > 0 && (f < best || f == best && isBefore(i, itsPart));
  }

  private boolean isBefore(final int i, final int itsPart) {
    final int order = sources.order(source[i]);
    return currentOrder < order || currentOrder == order && itsPart < part[i];
  }

  /** The number by which {@link #take} knows the object that makes offers: the hits' owner, and what is to be painted. */
  int source(final Object3D owner, final Object3D painted) {
    return sources.number(currentOrder, owner, painted);
  }

  /** Takes a hit that {@link #isCloser} approved. */
  void take(final int i, final double distance, final int itsSource, final int itsPart) {
    final int row = i / RayTile.SIZE, before = compared[i];
    t[i] = distance;
    compared[i] = Float.floatToRawIntBits((float) distance);
    open -= before == INFINITE ? 1 : 0;
    changedRows |= (before == farthestOfRow[row] ? 1 : 0) << row;
    source[i] = itsSource;
    part[i] = itsPart;
    if (returned != null) {
      returned[i] = null;
    }
  }

  /** Distance beyond which no hit can be closer for any ray of the tile. */
  double farthest() {
    if (open > 0) {
      return Double.POSITIVE_INFINITY;
    }
    if (changedRows != 0) {
      int most = 0;
      for (int row = 0; row < rays.rows(); row++) {
        if ((changedRows >> row & 1) != 0) {
          farthestOfRow[row] = farthestOf(row * RayTile.SIZE);
        }
        most = Math.max(most, farthestOfRow[row]);
      }
      changedRows = 0;
      farthest = Float.intBitsToFloat(most) * ClosestHit.SAME;
    }
    return farthest;
  }

  /** Distance beyond which no hit can be closer for ray i. */
  double farthest(final int i) {
    return Float.intBitsToFloat(compared[i]) * ClosestHit.SAME;
  }

  /** The farthest hit of a row; pixels without a ray have 0. Two chains, so that neither waits for the other. */
  private int farthestOf(final int first) {
    int even = 0, odd = 0;
    for (int i = first; i < first + RayTile.SIZE; i += 2) {
      even = Math.max(even, compared[i]);
      odd = Math.max(odd, compared[i + 1]);
    }
    return Math.max(even, odd);
  }

  /**
   * Whether a pixel has a ray.
   *
   * @param i number of the pixel, column + SIZE · row
   * @return false if the projection sends none through it
   */
  public boolean isPresent(final int i) {
    return rays.isPresent(i);
  }

  /**
   * Whether a ray hits anything.
   *
   * @param i number of the pixel, column + SIZE · row
   * @return false for a pixel without a ray
   */
  public boolean hits(final int i) {
    return source[i] != 0;
  }

  /**
   * Writes the colours of what some rays of a row hit, as sRGB with alpha.
   *
   * @param first number of the first pixel, column + SIZE · row
   * @param width how many pixels
   * @param pixels where to write
   * @param at place of the first colour there
   * @param background colour of the pixels whose ray hits nothing
   */
  public void paint(final int first, final int width, final int[] pixels, final int at, final int background) {
    int last = 0, colour = background;
    for (int k = 0; k < width; k++) {
      final int number = source[first + k];
      if (number != last) {
        colour = number == 0 ? background : argb(first + k);
        last = number == 0 || sources.hasOneColor(number) ? number : -1;
      }
      pixels[at + k] = colour;
    }
  }

  /** Colour of what a ray hits, as sRGB with alpha. */
  int argb(final int i) {
    if (sources.isPatterned(source[i])) {
      final Hit found = hit(i);
      return found.getObject().getColorAt(found).getRGB();
    }
    return sources.argb(source[i], part[i]);
  }

  /**
   * The ray of a pixel.
   *
   * @param i number of the pixel, which must have a ray
   * @return a new ray
   */
  public Ray ray(final int i) {
    return isNested ? Ray.exactly(rays.startX(i), rays.startY(i), rays.startZ(i),
        rays.directionX(i), rays.directionY(i), rays.directionZ(i))
        : Ray.along(rays.startX(i), rays.startY(i), rays.startZ(i), rays.vx(i), rays.vy(i), rays.vz(i));
  }

  /**
   * The object of the group that a ray hits, as {@link Group3D#objectHitBy} returns it.
   *
   * @param i number of the pixel
   * @return the object, perhaps a transformation; null if the ray hits nothing
   */
  public Object3D object(final int i) {
    return sources.owner(source[i]);
  }

  /**
   * The whole hit of a ray: what the group's {@code intersectionWith} returns for it.
   *
   * @param i number of the pixel
   * @return the hit, or {@link Hit#NOHIT}
   */
  public Hit hit(final int i) {
    return hits(i) ? hit(i, null) : Hit.NOHIT;
  }

  /**
   * The whole hit of a ray that has one.
   *
   * @param i number of the pixel; {@link #hits} must be true
   * @param ray what {@link #ray} returns for it; null to have it made if it is needed
   * @return the hit, or {@link Hit#NOHIT} if no float holds its numbers
   */
  public Hit hit(final int i, final Ray ray) {
    return returned != null && returned[i] != null ? returned[i]
        : sources.owner(source[i]).hitAt(ray == null ? ray(i) : ray, t[i], part[i]);
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
    return sources.painted(source[i]);
  }

  int part(final int i) {
    return part[i];
  }
}
