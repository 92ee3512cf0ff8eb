package models;

/**
 * The march to a torus along a ray, for {@link Torus}.
 *
 * <p>Sphere tracing with steps that take the direction of the ray into account. Hart's step from a point ends where the
 * ray leaves a sphere that is known to be empty, whose radius is the distance. Here the region known to be empty is
 * larger, and the point where the ray leaves it is the root of a quadratic. With D the distance to the ring and ρ that to
 * the axis, D² along the ray is a quadratic less 2 R ρ. So bounds of ρ are all that is needed; any of these serves for a
 * step of length s:
 * <ul>
 * <li>outside, ρ ≤ (ρ² + ρ₀²) / 2ρ₀ for any ρ₀ &gt; 0, the inequality between the geometric and the arithmetic mean. With
 *     it D² ≤ r² becomes a quadric of revolution that contains the torus and touches it along the circles of radius ρ₀.
 *     So a step cannot pass the surface, however thin the torus; and a ray that misses the quadric, or has left it
 *     behind, misses the torus;</li>
 * <li>inside, ρ ≥ ρ₀ + ρ₀′ s + ½ m s² with the least m that ρ″ has on the ray within the torus. A step cannot pass the
 *     far wall.</li>
 * </ul>
 * Both bounds have the value and the slope of ρ at the current point, so that near a crossing the remaining distance is
 * proportional to the square of the last step. Where a ray touches the surface to second order without crossing it, steps
 * halve. Where it almost follows the surface, touching it to higher order, such steps would hardly grow or shrink; there
 * the march goes on with bounds that have nearly the second derivative of ρ as well, and steps change by a constant factor.
 * So the number of steps is bounded by a multiple of the number of digits of a double.
 *
 * <p>A ray is given by numbers that do not depend on the frame: t counts from its point closest to the centre; h is the
 * height of that point above the ring's plane, and slope the change of height; and, seen along the axis, the ray moves at
 * a speed from a place on its way, passing the axis at the distance aside: ρ² = (place + t speed)² + aside². They are
 * passed one by one, so that a miss allocates nothing.
 *
 * <p>Source of the scheme: Hart, "Sphere tracing: a geometric method for the antialiased ray tracing of implicit
 * surfaces", The Visual Computer 12, 1996.
 */
final class TorusTrace {

  /** Maximum number of steps of a grazing ray. None of some ten million rays needed more than a quarter of them. */
  private static final int STEPS = 200;

  /** Number of steps after which a ray is treated as grazing. */
  private static final int USUAL_STEPS = 16;

  /** Error of the distance at which the march ends, relative to the smaller of r and ρ: there may be a cusp at ρ = 0. */
  private static final double CLOSE = 0x1p-24;

  /** Fraction of R + r below which ρ is ignored for {@link #CLOSE}. */
  private static final double CUSP = 0x1p-20;

  /** Rounding errors of D² − r², relative to (R + r) r: two squares of differences with an error of 2⁻⁵² (R + r). */
  private static final double NOISE = 0x1p-49;

  /** How far ahead of a start on the surface its side is determined, relative to √((R + r) r). */
  private static final double AHEAD = 0x1p-23;

  private final double R;
  private final double r;
  private final double outer;
  private final double inner;
  private final double quarter;

  TorusTrace(final double R, final double r) {
    this.R = R;
    this.r = r;
    this.outer = R + r;
    this.inner = Math.max(0, R - r);
    this.quarter = 0.25 / R;
  }

  /** The march of a ray that starts near the torus, outside or inside; on the surface, the side just ahead decides. */
  double fromStart(final double start, final double leave, final double place, final double speed,
      final double aside2, final double h, final double slope) {
    double t = start, c = excess(t, place, speed, aside2, h, slope);
    if (Math.abs(c) <= NOISE * outer * r) {
      t += AHEAD * Math.sqrt(outer * r);
      c = excess(t, place, speed, aside2, h, slope);
    }
    return c < 0 ? fromInside(t, place, speed, aside2, h, slope)
        : fromOutside(t, leave, place, speed, aside2, h, slope);
  }

  /** D² − r² at a point of the ray. */
  private double excess(final double t, final double place, final double speed, final double aside2, final double h,
      final double slope) {
    final double x = place + t * speed, height = h + t * slope, rho = Math.sqrt(x * x + aside2);
    return (rho - R - r) * (rho - R + r) + height * height;
  }

  /**
   * Marches outside. With ρ₀ = ρ the quadric touches the torus at the radius where the march is; in the hole, and close
   * to the axis, a larger radius gives a longer step. The step solves c + 2 b s + q s² = 0, all times ρ₀ to save a
   * division.
   *
   * <p>After a step with ρ₀ = ρ the remainder of D² − r² is R (ρ′s)² / ρ₀ up to terms in s³, and its slope is known as
   * well. The last step is extended accordingly, once the rest is negligible.
   */
  double fromOutside(final double from, final double leave, final double place, final double speed,
      final double aside2, final double h, final double slope) {
    double t = from, s = 0;
    for (int i = 0; i < USUAL_STEPS && t <= leave; i++) {
      final double x = place + t * speed, height = h + t * slope, rho = Math.sqrt(x * x + aside2);
      final double excess = (rho - R - r) * (rho - R + r) + height * height;
      if (excess <= 0) {
        return t;
      }
      final double touch = Math.max(rho, Math.max(inner, excess * quarter)), ahead = touch - rho, outwards = speed * x;
      final double c = touch * excess - R * ahead * ahead, b = touch * t - R * outwards, q = touch - R * speed * speed;
      final double discriminant = b * b - q * c;
      if (b >= 0 ? q >= 0 : discriminant < 0) {
        return Double.POSITIVE_INFINITY;
      }
      final double root = Math.sqrt(discriminant);
      s = b < 0 ? c / (root - b) : -(b + root) / q;
      t += s;
      final double close = close(rho);
      if (s <= close) {
        return t;
      }
      final double rest = R * s * s, left = rest * outwards * outwards, slid = root * s * rho * rho;
      if (ahead == 0 && rest * s <= close * root * rho && rest * rest * rho <= close * root * root * root
          && left <= 0.5 * slid) {
        return t + 0.5 * left * s / (slid - left);
      }
    }
    return t <= leave ? grazing(t, s, leave, place, speed, aside2, h, slope) : Double.POSITIVE_INFINITY;
  }

  /**
   * Marches outside where the ray almost follows the surface, and the steps of {@link #fromOutside} hardly grow on the way
   * out of contact. With steps of at most twice the previous one the curvature of the bound comes close to that of D²:
   * ρ ≤ ρ₀ + ρ₀′ s + ½ m s² with the greatest m that ρ″ can have within that length.
   */
  private double grazing(final double from, final double step, final double leave, final double place, final double speed,
      final double aside2, final double h, final double slope) {
    double t = from, s = step;
    for (int i = 0; i < STEPS && t <= leave; i++) {
      final double x = place + t * speed, height = h + t * slope, rho = Math.sqrt(x * x + aside2);
      final double c = (rho - R - r) * (rho - R + r) + height * height;
      if (c <= 0 || s <= close(rho)) {
        return t;
      }
      final double touch = Math.max(rho, c * quarter), ahead = touch - rho, longest = x < 0 ? 2 * s : Double.MAX_VALUE;
      final double least = x < 0 ? Math.max(Math.sqrt(aside2), rho - longest * speed) : rho;
      final double bend = ahead == 0 && least > 0 ? Math.min(1 / touch, aside2 / (least * least * least)) : 1 / touch;
      s = Math.min(longest, firstRoot(c - R * ahead * ahead / touch, t - R * speed * x / touch,
          1 - R * speed * speed * bend));
      t += s;
    }
    return Double.POSITIVE_INFINITY;
  }

  /** Smallest positive root of c + 2 b s + q s² = 0 with c > 0; infinity if none. */
  private static double firstRoot(final double c, final double b, final double q) {
    final double discriminant = b * b - q * c;
    if (b >= 0 ? q >= 0 : discriminant < 0) {
      return Double.POSITIVE_INFINITY;
    }
    return b < 0 ? c / (Math.sqrt(discriminant) - b) : -(b + Math.sqrt(discriminant)) / q;
  }

  /** Distance from the surface at which the march may end, at a point at distance ρ from the axis. */
  private double close(final double rho) {
    return CLOSE * Math.min(r, Math.max(rho, CUSP * outer));
  }

  /**
   * Marches inside, as {@link #fromOutside} does outside, with the least ρ″ of the whole torus. There is always a far
   * wall.
   */
  private double fromInside(final double from, final double place, final double speed, final double aside2,
      final double h, final double slope) {
    final double q = Math.max(r / outer, 1 - R * speed * speed * aside2 / (outer * outer * outer));
    double t = from, s = 0;
    for (int i = 0; i < USUAL_STEPS; i++) {
      final double x = place + t * speed, height = h + t * slope, rho = Math.sqrt(x * x + aside2);
      final double c = (rho - R - r) * (rho - R + r) + height * height;
      if (c >= 0) {
        return t;
      }
      final double b = t - (rho > 0 ? R * speed * x / rho : 0), root = Math.sqrt(b * b - q * c);
      s = b > 0 ? -c / (b + root) : (root - b) / q;
      t += s;
      if (s <= close(rho) || R * s * s <= 2 * close(rho) * rho * root) {
        return t;
      }
    }
    return alongWall(t, s, place, speed, aside2, h, slope);
  }

  /** Marches inside where the ray almost follows the wall, as {@link #grazing} does outside. */
  private double alongWall(final double from, final double step, final double place, final double speed,
      final double aside2, final double h, final double slope) {
    double t = from, s = step;
    for (int i = 0; i < STEPS; i++) {
      final double x = place + t * speed, height = h + t * slope, rho = Math.sqrt(x * x + aside2);
      final double c = (rho - R - r) * (rho - R + r) + height * height;
      if (c >= 0 || s <= close(rho)) {
        break;
      }
      final double longest = 2 * s, later = x + longest * speed;
      final double greatest = Math.max(rho, Math.sqrt(later * later + aside2));
      final double bend = greatest > 0 ? aside2 / (greatest * greatest * greatest) : 0;
      s = Math.min(longest, firstRoot(-c, R * speed * x / Math.max(rho, Double.MIN_NORMAL) - t,
          R * speed * speed * bend - 1));
      t += s;
    }
    return t;
  }
}
