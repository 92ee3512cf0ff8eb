package models;

/**
 * Where a line enters and leaves an egg, from the components of two vectors along and across its axis: from the centre to
 * a point of the line near it, and the line's direction.
 *
 * <p>The line is first intersected with the cylinder of radius a and height 2 b around the egg. At both ends of that
 * stretch the cubic f = ρ² q − a² (b² − y²) of {@link Egg} is at least 0, so that the line enters the egg only if f has a
 * minimum in between and is negative there. From each end, Newton's method then approaches the root monotonically,
 * because f / q = ρ² − a² (b² − y²) / q is convex: ρ² is, and (b² − y²) / q = const − y / 2w − (b² − w²)² / (4 w² q) is
 * concave.
 */
final class EggChord {

  /** More steps than Newton's method ever takes: 53 halvings along a tangent or at a sharp rim, and a few to spare. */
  private static final int STEPS = 100;

  /** Parameter at which the line enters; NaN if it misses the egg. */
  final double enter;

  /** Parameter at which the line leaves; NaN likewise. */
  final double leave;

  private final EggProfile profile;
  private final double y;
  private final double dy;
  private final double p2;
  private final double pd;
  private final double d2;

  /**
   * Intersects a line with an egg.
   *
   * @param profile the egg
   * @param px first component of the part across the axis of the point
   * @param py second component
   * @param pz third component
   * @param y the point's component along the axis
   * @param dx first component of the part across the axis of the direction
   * @param dy second component
   * @param dz third component
   * @param dAlong the direction's component along the axis
   */
  EggChord(final EggProfile profile, final double px, final double py, final double pz, final double y,
      final double dx, final double dy, final double dz, final double dAlong) {
    this.profile = profile;
    this.y = y;
    this.dy = dAlong;
    p2 = px * px + py * py + pz * pz;
    pd = px * dx + py * dy + pz * dz;
    d2 = dx * dx + dy * dy + dz * dz;
    final InfiniteCylinder side = new InfiniteCylinder(-px, -py, -pz, dx, dy, dz, profile.a);
    final double first = Math.max(side.enter, Slab.enter(y, dAlong, profile.b));
    final double last = Math.min(side.leave, Slab.leave(y, dAlong, profile.b));
    final double lowest = Math.max(first, Math.min(last, minimum()));
    final boolean hits = first <= last && value(lowest) < 0;
    enter = hits ? root(first, lowest, 1) : Double.NaN;
    leave = hits ? root(last, lowest, -1) : Double.NaN;
  }

  /** Where the cubic has its minimum; NaN if it has none. */
  private double minimum() {
    final double a2 = profile.a * profile.a, q0 = profile.denominator(profile.b + y), q1 = 2 * profile.w * dy;
    final double c3 = d2 * q1, c2 = d2 * q0 + 2 * pd * q1 + a2 * dy * dy, c1 = 2 * pd * q0 + p2 * q1 + 2 * a2 * y * dy;
    final double root = Math.sqrt(c2 * c2 - 3 * c3 * c1);
    return c2 >= 0 ? -c1 / (c2 + root) : (root - c2) / (3 * c3);
  }

  /** ρ² of the line less that of the egg at the same height. */
  private double value(final double t) {
    return p2 + t * (2 * pd + t * d2) - profile.radiusSquared(y + t * dy);
  }

  private double slope(final double t) {
    return 2 * (pd + t * d2) - dy * profile.slope(y + t * dy);
  }

  /** The root between an end of the stretch and a place inside the egg, which lies ahead (1) or behind (−1). */
  private double root(final double end, final double inside, final int ahead) {
    double t = end;
    for (int i = 0; i < STEPS; i++) {
      final double value = value(t), next = t - value / slope(t);
      if (!(value > 0 && ahead * (next - t) > 0)) {
        return t;
      }
      if (!(ahead * (inside - next) > 0)) {
        return inside;
      }
      t = next;
    }
    return t;
  }
}
