package primitives;

import static arguments.Arguments.notNull;
import static arguments.Arguments.wrong;

/**
 * An axis-aligned box, given by its corners of least and greatest coordinates.
 *
 * <p>Immutable. A box computed in double is rounded outwards ({@link #around}), so that points inside it in exact
 * arithmetic are inside it in floats too. The empty box, {@link #EMPTY}, goes from +∞ to −∞, so that a union needs no
 * special case; the box of all space, {@link #UNBOUNDED}, goes from −∞ to +∞.
 */
public final class BoundingBox {

  /** The box that contains no point. */
  public static final BoundingBox EMPTY = new BoundingBox(Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY,
      Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY);

  /** The box of all space: every ray hits it. */
  public static final BoundingBox UNBOUNDED = new BoundingBox(Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY,
      Float.NEGATIVE_INFINITY, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY);

  /**
   * By how much a computed box is widened, relative to its coordinates: points of a surface carry a few rounding errors
   * of 2⁻⁵³ each, which rounding to floats does not cover where a side is close to 0.
   */
  private static final double WIDER = 0x1p-48;

  /** One plus the relative error of a far side: a subtraction and a division on either side of the comparison. */
  private static final double FAR = 1 + 0x1p-50;

  private final float minX;
  private final float minY;
  private final float minZ;
  private final float maxX;
  private final float maxY;
  private final float maxZ;

  /**
   * The box between two corners.
   *
   * @param min corner of least coordinates; −∞ is allowed
   * @param max corner of greatest coordinates, none less than that of min; +∞ is allowed
   * @throws IllegalArgumentException if a corner is null, holds NaN, or if min exceeds max in a coordinate
   */
  public BoundingBox(final Point3D min, final Point3D max) {
    this(notNull("min", min).x, min.y, min.z, notNull("max", max).x, max.y, max.z);
    if (!(minX <= maxX && minY <= maxY && minZ <= maxZ)) {
      throw wrong("order", "min", min, "max", max);
    }
  }

  private BoundingBox(final float minX, final float minY, final float minZ,
      final float maxX, final float maxY, final float maxZ) {
    this.minX = minX;
    this.minY = minY;
    this.minZ = minZ;
    this.maxX = maxX;
    this.maxY = maxY;
    this.maxZ = maxZ;
  }

  /**
   * The box about a centre, rounded outwards to floats and widened by the rounding of doubles.
   *
   * @param x first coordinate of the centre
   * @param y second coordinate of the centre
   * @param z third coordinate of the centre
   * @param halfX half its extent along the first axis, at least 0
   * @param halfY half its extent along the second axis
   * @param halfZ half its extent along the third axis
   * @return the box; {@link #UNBOUNDED} if a number is NaN
   */
  public static BoundingBox around(final double x, final double y, final double z,
      final double halfX, final double halfY, final double halfZ) {
    final double hx = halfX + WIDER * (Math.abs(x) + halfX), hy = halfY + WIDER * (Math.abs(y) + halfY),
        hz = halfZ + WIDER * (Math.abs(z) + halfZ);
    return between(x - hx, y - hy, z - hz, x + hx, y + hy, z + hz);
  }

  /**
   * The box between two corners given in double, rounded outwards to floats.
   *
   * @param minX least first coordinate
   * @param minY least second coordinate
   * @param minZ least third coordinate
   * @param maxX greatest first coordinate
   * @param maxY greatest second coordinate
   * @param maxZ greatest third coordinate
   * @return the box; {@link #UNBOUNDED} if a number is NaN
   */
  public static BoundingBox between(final double minX, final double minY, final double minZ,
      final double maxX, final double maxY, final double maxZ) {
    if (Double.isNaN(minX + minY + minZ) || Double.isNaN(maxX + maxY + maxZ)) {
      return UNBOUNDED;
    }
    return new BoundingBox(Math.nextDown((float) minX), Math.nextDown((float) minY), Math.nextDown((float) minZ),
        Math.nextUp((float) maxX), Math.nextUp((float) maxY), Math.nextUp((float) maxZ));
  }

  /**
   * The union: the smallest box that contains this one and another.
   *
   * @param box the other box
   * @return the box of both
   * @throws IllegalArgumentException if the other box is null
   */
  public BoundingBox union(final BoundingBox box) {
    notNull("box", box);
    return new BoundingBox(Math.min(minX, box.minX), Math.min(minY, box.minY), Math.min(minZ, box.minZ),
        Math.max(maxX, box.maxX), Math.max(maxY, box.maxY), Math.max(maxZ, box.maxZ));
  }

  /**
   * Whether both corners are finite, as those of an unbounded box and of {@link #EMPTY} are not.
   *
   * @return true if no coordinate is infinite
   */
  public boolean isFinite() {
    return minX > Float.NEGATIVE_INFINITY && minY > Float.NEGATIVE_INFINITY && minZ > Float.NEGATIVE_INFINITY
        && maxX < Float.POSITIVE_INFINITY && maxY < Float.POSITIVE_INFINITY && maxZ < Float.POSITIVE_INFINITY
        && !isEmpty();
  }

  /**
   * Whether the box is empty.
   *
   * @return true for {@link #EMPTY}
   */
  public boolean isEmpty() {
    return !(minX <= maxX);
  }

  /**
   * Whether a point lies inside or on the boundary.
   *
   * @param P the point
   * @return true if it does; false if a coordinate is NaN
   * @throws IllegalArgumentException if P is null
   */
  public boolean contains(final Point3D P) {
    notNull("P", P);
    return P.x >= minX && P.x <= maxX && P.y >= minY && P.y <= maxY && P.z >= minZ && P.z <= maxZ;
  }

  /**
   * Whether a ray hits the box, by the slab test (Kay and Kajiya, "Ray tracing complex scenes", SIGGRAPH 1986), in
   * double, with the far side moved outwards by its rounding error (Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013). A
   * direction component of 0 has a branch of its own, where 0 · ∞ would be NaN.
   *
   * @param x first coordinate of the start of the ray
   * @param y second coordinate of the start
   * @param z third coordinate of the start
   * @param dx first component of its direction
   * @param dy second component of its direction
   * @param dz third component of its direction
   * @return true if some point R + t d, t ≥ 0, lies in the box; false if a number is NaN
   */
  public boolean isCrossedBy(final double x, final double y, final double z,
      final double dx, final double dy, final double dz) {
    final double enter = Math.max(Math.max(near(x, dx, minX, maxX), near(y, dy, minY, maxY)), near(z, dz, minZ, maxZ));
    final double leave = Math.min(Math.min(far(x, dx, minX, maxX), far(y, dy, minY, maxY)), far(z, dz, minZ, maxZ));
    return leave >= 0 && enter <= leave * FAR;
  }

  private static double near(final double start, final double direction, final float min, final float max) {
    if (direction == 0) {
      return start >= min && start <= max ? Double.NEGATIVE_INFINITY : Double.NaN;
    }
    return ((direction > 0 ? min : max) - start) / direction;
  }

  private static double far(final double start, final double direction, final float min, final float max) {
    return direction == 0 ? Double.POSITIVE_INFINITY : ((direction > 0 ? max : min) - start) / direction;
  }

  /**
   * Least first coordinate.
   *
   * @return the number, perhaps infinite
   */
  public float minX() {
    return minX;
  }

  /**
   * Greatest first coordinate.
   *
   * @return the number, perhaps infinite
   */
  public float maxX() {
    return maxX;
  }

  /**
   * Least second coordinate.
   *
   * @return the number, perhaps infinite
   */
  public float minY() {
    return minY;
  }

  /**
   * Greatest second coordinate.
   *
   * @return the number, perhaps infinite
   */
  public float maxY() {
    return maxY;
  }

  /**
   * Least third coordinate.
   *
   * @return the number, perhaps infinite
   */
  public float minZ() {
    return minZ;
  }

  /**
   * Greatest third coordinate.
   *
   * @return the number, perhaps infinite
   */
  public float maxZ() {
    return maxZ;
  }

  /**
   * The corner of least coordinates.
   *
   * @return a new point, with infinite coordinates where the box is unbounded
   */
  public Point3D getMin() {
    return new Point3D(minX, minY, minZ);
  }

  /**
   * The corner of greatest coordinates.
   *
   * @return a new point, with infinite coordinates where the box is unbounded
   */
  public Point3D getMax() {
    return new Point3D(maxX, maxY, maxZ);
  }

  @Override
  public String toString() {
    return "BoundingBox(" + getMin() + ", " + getMax() + ")";
  }
}
