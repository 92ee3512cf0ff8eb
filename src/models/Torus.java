package models;

import static arguments.Arguments.notNull;
import static arguments.Arguments.positive;

import java.awt.Color;

import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/**
 * A torus: the points no farther than r from a circle of radius R, the ring, about C in the plane perpendicular to the
 * axis. With r ≥ R it is a solid without a hole, and only its outer surface counts.
 *
 * <p>For a point at height h over the ring's plane and at distance ρ from the axis, the squared distance to the ring is
 * D² = (ρ − R)² + h², and {@link #SDF} is D − r: the exact distance, except inside a torus with r &gt; R, where it is a
 * bound.
 *
 * <p>The march is sphere tracing whose steps know the direction. Hart's step from a point ends where the ray leaves a
 * sphere known to be empty, of radius |SDF|. Here the region known to be empty is larger, and the ray leaves it at the
 * root of a quadratic. Along the ray D² is a quadratic less 2 R ρ, so all that is needed are bounds of ρ:
 * <ul>
 * <li>outside, ρ ≤ (ρ² + ρ₀²) / 2ρ₀ for any ρ₀ &gt; 0. With it D² ≤ r² becomes a quadric of revolution that contains the
 *     torus and touches it all along the circles of radius ρ₀. So a step cannot pass the surface, however thin the
 *     torus; and a ray that misses the quadric, or has left it behind, misses the torus;</li>
 * <li>inside, ρ ≥ ρ₀ + ρ₀′ s + ½ m s² with the least m that ρ″ has on the ray within the torus.</li>
 * </ul>
 * Both bounds touch at the point where the march is, so the steps shrink quadratically on the way to a crossing. Towards
 * a point of tangency they halve, which a double can bear some 50 times.
 *
 * <p>Source of the scheme: Hart, "Sphere tracing", The Visual Computer 12, 1996; the bound of ρ is the inequality
 * between the geometric and the arithmetic mean.
 */
public class Torus extends ProceduralObject3D {

  /** Bound of the steps. The halving towards a tangency takes the most of them; no ray was seen to need half as many. */
  private static final int STEPS = 200;

  /** Error of the distance at which the march ends, as a part of ρ, so that it stays small next to a cusp on the axis. */
  private static final double CLOSE = 0x1p-25;

  /** Part of R + r below which ρ no longer counts for {@link #CLOSE}. */
  private static final double CUSP = 0x1p-20;

  /** A ray whose direction has a smaller component along the axis has one height from end to end. */
  private static final double LEVEL = 0x1p-100;

  /** Rounding errors of D² − r², as a part of (R + r) r: two squares of differences that are off by 2⁻⁵² (R + r). */
  private static final double NOISE = 0x1p-49;

  /** Rounding errors of {@link #SDF}, as a part of the distance from the centre plus R + r. */
  private static final double SDF_NOISE = 0x1p-49;

  /** How far ahead it is decided on which side a ray begins that starts on the surface, as a part of √((R + r) r). */
  private static final double AHEAD = 0x1p-23;

  private final Axis axis;
  private final double R;
  private final double r;
  private final double outer;
  private final double outer2;
  private final double inner;
  private final double inner2;
  private final double quarter;

  /**
   * A torus.
   *
   * @param C centre
   * @param axis direction of the axis of revolution, of any length but 0
   * @param R distance from the axis to the centre of the circle that is revolved, &gt; 0
   * @param r radius of that circle, &gt; 0; may be R or more
   * @param color colour
   * @throws IllegalArgumentException if an argument is null or not finite, if the axis is zero, or if a radius is not
   *     positive
   */
  public Torus(final Point3D C, final Vector3D axis, final float R, final float r, final Color color) {
    super(color);
    this.axis = new Axis("C", C, "axis", axis);
    this.R = positive("R", R);
    this.r = positive("r", r);
    this.outer = this.R + this.r;
    this.outer2 = outer * outer;
    this.inner = Math.max(0, this.R - this.r);
    this.inner2 = inner > 0 ? inner * inner : Double.NEGATIVE_INFINITY;
    this.quarter = 0.25 / this.R;
  }

  @Override
  public Hit intersectionWith(final Ray ray) {
    return rayMarching(ray);
  }

  @Override
  double distance(final double x, final double y, final double z, final double dx, final double dy, final double dz) {
    return march(x, y, z, dx, dy, dz);
  }

  /**
   * Cuts the ray with the sphere of radius R + r about the centre. From here on t counts from the point p of the ray
   * that is closest to the centre, so that nothing cancels when the ray comes from far away.
   */
  @Override
  double march(final double x, final double y, final double z, final double dx, final double dy, final double dz) {
    final double lx = x - axis.x, ly = y - axis.y, lz = z - axis.z;
    final double start = lx * dx + ly * dy + lz * dz;
    final double px = lx - start * dx, py = ly - start * dy, pz = lz - start * dz;
    final double p2 = px * px + py * py + pz * pz, room = outer2 - p2;
    if (!(room > 0)) {
      return Double.POSITIVE_INFINITY;
    }
    final double half = Math.sqrt(room), h = axis.along(px, py, pz), slope = axis.along(dx, dy, dz);
    double enter = -half, leave = half;
    if (Math.abs(slope) > LEVEL) {
      final double middle = -h / slope, reach = r / Math.abs(slope);
      enter = Math.max(enter, middle - reach);
      leave = Math.min(leave, middle + reach);
    }
    if (!(leave >= enter && leave > start) || inHole(enter, p2, h, slope) && inHole(leave, p2, h, slope)) {
      return Double.POSITIVE_INFINITY;
    }
    return across(start, enter, leave, px - h * axis.ux, py - h * axis.uy, pz - h * axis.uz,
        dx - slope * axis.ux, dy - slope * axis.uy, dz - slope * axis.uz, h, slope) - start;
  }

  private boolean inHole(final double t, final double p2, final double h, final double slope) {
    final double height = h + t * slope;
    return p2 + t * t - height * height < inner2;
  }

  /**
   * Takes the ray, whose parts across the axis are given, to numbers that do not depend on the frame: its height h over
   * the ring's plane with its slope; and, looking along the axis, how fast it moves and the place along and beside
   * its way, so that ρ² = (place + t speed)² + aside², of which neither cancels.
   */
  private double across(final double start, final double enter, final double leave, final double qx, final double qy,
      final double qz, final double ex, final double ey, final double ez, final double h, final double slope) {
    final double speed = Math.sqrt(ex * ex + ey * ey + ez * ez), scale = speed > 0 ? 1 / speed : 0;
    final double ux = scale * ex, uy = scale * ey, uz = scale * ez, place = qx * ux + qy * uy + qz * uz;
    final double sx = qx - place * ux, sy = qy - place * uy, sz = qz - place * uz;
    final double aside2 = sx * sx + sy * sy + sz * sz;
    return enter > start ? fromOutside(enter, leave, place, speed, aside2, h, slope)
        : fromStart(start, leave, place, speed, aside2, h, slope);
  }

  /** The march of a ray that starts close to the torus, outside or inside; on the surface, what is ahead decides. */
  private double fromStart(final double start, final double leave, final double place, final double speed,
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
   * to the axis, one of greater radius leads farther. The step solves c + 2 b s + q s² = 0, all times ρ₀ to save a
   * division.
   *
   * <p>After a step with ρ₀ = ρ what is left of D² − r² is R (ρ′s)² / ρ₀ up to terms in s³, and its slope is known as
   * well. The last step goes that bit farther, once what it leaves out is negligible.
   */
  private double fromOutside(final double from, final double leave, final double place, final double speed,
      final double aside2, final double h, final double slope) {
    double t = from;
    for (int i = 0; i < STEPS && t <= leave; i++) {
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
      final double root = Math.sqrt(discriminant), s = b < 0 ? c / (root - b) : -(b + root) / q;
      t += s;
      final double close = CLOSE * Math.max(rho, CUSP * outer);
      if (s <= close) {
        return t;
      }
      final double rest = R * s * s, left = rest * outwards * outwards, slid = root * s * rho * rho;
      if (ahead == 0 && rest * s <= close * root * rho && rest * rest * rho <= close * root * root * root
          && left <= 0.5 * slid) {
        return t + 0.5 * left * s / (slid - left);
      }
    }
    return Double.POSITIVE_INFINITY;
  }

  /** Marches inside, as {@link #fromOutside} does. There is always a far wall. */
  private double fromInside(final double from, final double place, final double speed, final double aside2,
      final double h, final double slope) {
    final double q = Math.max(r / outer, 1 - R * speed * speed * aside2 / (outer * outer2));
    double t = from;
    for (int i = 0; i < STEPS; i++) {
      final double x = place + t * speed, height = h + t * slope, rho = Math.sqrt(x * x + aside2);
      final double c = (rho - R - r) * (rho - R + r) + height * height;
      if (c >= 0) {
        break;
      }
      final double b = t - (rho > 0 ? R * speed * x / rho : 0);
      final double root = Math.sqrt(b * b - q * c), s = b > 0 ? -c / (b + root) : (root - b) / q;
      t += s;
      final double close = CLOSE * Math.max(rho, CUSP * outer);
      if (s <= close || R * s * s <= 2 * close * rho * root) {
        break;
      }
    }
    return t;
  }

  @Override
  Hit hitAt(final Ray ray, final double t, final int part) {
    final double px = ray.startX() + t * ray.directionX() - axis.x, py = ray.startY() + t * ray.directionY() - axis.y,
        pz = ray.startZ() + t * ray.directionZ() - axis.z;
    final double h = axis.along(px, py, pz);
    final double qx = px - h * axis.ux, qy = py - h * axis.uy, qz = pz - h * axis.uz;
    final double rho = Math.sqrt(qx * qx + qy * qy + qz * qz), k = rho > 0 ? R / rho : 0;
    final double nx = px - k * qx, ny = py - k * qy, nz = pz - k * qz, s = r / Math.sqrt(nx * nx + ny * ny + nz * nz);
    return Hit.of(t, axis.x + k * qx + s * nx, axis.y + k * qy + s * ny, axis.z + k * qz + s * nz, nx, ny, nz, this);
  }

  @Override
  protected float SDF(final Point3D P) {
    final double distance = signedDistance(notNull("P", P).x, P.y, P.z);
    final double sure = Math.abs(distance) - SDF_NOISE * (distance + outer + outer);
    return Math.copySign(roundedDown(Math.max(0, sure)), (float) distance);
  }

  @Override
  double signedDistance(final double x, final double y, final double z) {
    final double px = x - axis.x, py = y - axis.y, pz = z - axis.z, h = axis.along(px, py, pz);
    final double a = fromAxis(px, py, pz, h) - R;
    return Math.sqrt(a * a + h * h) - r;
  }

  @Override
  protected float distanceUpperBound(final Point3D P) {
    final double px = notNull("P", P).x - axis.x, py = P.y - axis.y, pz = P.z - axis.z, h = axis.along(px, py, pz);
    final double a = fromAxis(px, py, pz, h) + R;
    return roundedUp((Math.sqrt(a * a + h * h) + r) * (1 + SDF_NOISE));
  }

  /** Distance from the axis of a point less the centre, at height h. */
  private double fromAxis(final double px, final double py, final double pz, final double h) {
    final double qx = px - h * axis.ux, qy = py - h * axis.uy, qz = pz - h * axis.uz;
    return Math.sqrt(qx * qx + qy * qy + qz * qz);
  }

  @Override
  public BoundingBox getBoundingBox() {
    return BoundingBox.around(axis.x, axis.y, axis.z, R * Math.hypot(axis.uy, axis.uz) + r,
        R * Math.hypot(axis.uz, axis.ux) + r, R * Math.hypot(axis.ux, axis.uy) + r);
  }

  @Override
  public String toString() {
    return "Torus(C=(" + (float) axis.x + ", " + (float) axis.y + ", " + (float) axis.z + "), axis=("
        + (float) axis.ux + ", " + (float) axis.uy + ", " + (float) axis.uz + "), R=" + (float) R + ", r=" + (float) r + ")";
  }
}
