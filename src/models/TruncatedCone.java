package models;

import static arguments.Arguments.notNegative;
import static arguments.Arguments.positive;
import static arguments.Arguments.wrong;

import java.awt.Color;
import java.util.List;

import materials.Material;
import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/**
 * A solid truncated cone, closed by two flat discs: the points X with |s| ≤ l/2, s = (X − P)·û, at most rA + (rB − rA) (s
 * + l/2) / l away from the axis. One of the radii may be 0; that end is a tip, and the solid a cone.
 *
 * <p><img src="doc-files/TruncatedCone.png" width="320" height="240" alt="A truncated cone, and its axis">
 *
 * <p>The ray is intersected with the infinite cone and with the slab between the discs; the hit is where the two
 * intervals first overlap, and it lies on the side or on a disc according to which of them ends the overlap there. The
 * first interval is that of a quadratic, a t² + 2 b t + c = 0, whose discriminant is 0 for all rays through the tip. It
 * is computed from the tip, if there is one, in a form that keeps its sign ({@code InfiniteCone}); a ray that misses the
 * tip by rounding only hits it. Source: Shene, "Computing the Intersection of a Line and a Cone", Graphics Gems V, 1995.
 */
public class TruncatedCone extends Object3D {

  /** Rounding of a ray through the tip, relative to the coordinates involved: 32 rounding errors of 2⁻⁵³. */
  private static final double ROUNDING = 0x1p-48;

  /** Rounding of the tip to floats, relative to its coordinates. */
  private static final double FLOAT = 0x1p-24;

  /** How close to the tip, relative to the length and the radius, such a ray has to pass. */
  private static final double CLOSE = 0x1p-17;

  private final Axis axis;
  private final double rA;
  private final double rB;
  private final double half;
  private final double slope;
  /** Place along the axis, counted from P, of the tip, or of P itself if there is no tip; the rays are moved there. */
  private final double origin;
  private final double x;
  private final double y;
  private final double z;
  /** Radius there. */
  private final double r;

  /**
   * A truncated cone.
   *
   * @param P middle of the axis segment, which runs from A = P − (l/2) û to B = P + (l/2) û
   * @param u direction of the axis, of any length but 0
   * @param rA radius at A, ≥ 0
   * @param rB radius at B, ≥ 0, not 0 if rA is
   * @param l length along the axis, &gt; 0
   * @param color colour
   * @throws IllegalArgumentException if an argument is null or not finite, if u is zero, if a radius is negative or both
   *     are 0, or if l is not positive
   */
  public TruncatedCone(final Point3D P, final Vector3D u, final float rA, final float rB, final float l, final Color color) {
    this(P, u, rA, rB, l, Appearance.of(color));
  }

  /**
   * A truncated cone of a material.
   *
   * @param P middle of the axis segment, which runs from A = P − (l/2) û to B = P + (l/2) û
   * @param u direction of the axis, of any length but 0
   * @param rA radius at A, ≥ 0
   * @param rB radius at B, ≥ 0, not 0 if rA is
   * @param l length along the axis, &gt; 0
   * @param material material
   * @throws IllegalArgumentException if an argument is null or not finite, if u is zero, if a radius is negative or both
   *     are 0, or if l is not positive
   */
  public TruncatedCone(final Point3D P, final Vector3D u, final float rA, final float rB, final float l,
      final Material material) {
    this(P, u, rA, rB, l, Appearance.of(material));
  }

  private TruncatedCone(final Point3D P, final Vector3D u, final float rA, final float rB, final float l,
      final Appearance appearance) {
    super(appearance);
    this.axis = new Axis("P", P, "u", u);
    this.rA = notNegative("rA", rA);
    this.rB = notNegative("rB", rB);
    if (rA == 0 && rB == 0) {
      throw wrong("bothZero", "rA", "rB", rA, rB);
    }
    this.half = positive("l", l) * 0.5;
    this.slope = (this.rB - this.rA) / l;
    this.origin = rA == 0 ? -half : rB == 0 ? half : 0;
    this.x = axis.x + origin * axis.ux;
    this.y = axis.y + origin * axis.uy;
    this.z = axis.z + origin * axis.uz;
    this.r = origin == 0 ? 0.5 * (this.rA + this.rB) : 0;
  }

  @Override
  public Hit intersectionWith(final Ray ray) {
    return closestHit(ray);
  }

  @Override
  double distance(final double sx, final double sy, final double sz, final double dx, final double dy, final double dz) {
    final Chord chord = new Chord(sx - x, sy - y, sz - z, dx, dy, dz);
    if (chord.enter <= chord.leave) {
      return Quadratic.firstPositive(chord.enter - chord.start, chord.leave - chord.start);
    }
    return isAimedAtTip(sx, sy, sz, dx, dy, dz) ? (x - sx) * dx + (y - sy) * dy + (z - sz) * dz : Double.POSITIVE_INFINITY;
  }

  /**
   * The interval of a line within the cone. Its parameter counts from a point p of the line near the origin: from the one
   * in the plane perpendicular to the axis there, where nothing cancels even if the cone is flat; or from the closest
   * one, if the line is almost parallel to that plane.
   */
  private final class Chord {

    final double start;
    final double px;
    final double py;
    final double pz;
    final double along;
    final InfiniteCone side;
    final double slabEnter;
    final double slabLeave;
    final double enter;
    final double leave;

    /** Clips the line, whose start is given relative to the origin. */
    Chord(final double lx, final double ly, final double lz, final double dx, final double dy, final double dz) {
      final Axis u = axis;
      final double closest = lx * dx + ly * dy + lz * dz;
      final double cx = lx - closest * dx, cy = ly - closest * dy, cz = lz - closest * dz, height = u.along(cx, cy, cz);
      along = u.along(dx, dy, dz);
      final boolean crosses = Math.abs(height) <= Math.max(rA, rB) * Math.abs(along) && along != 0;
      final double shift = crosses ? height / along : 0, s = crosses ? 0 : height;
      start = closest + shift;
      px = cx - shift * dx;
      py = cy - shift * dy;
      pz = cz - shift * dz;
      final double on = u.along(px, py, pz);
      side = new InfiniteCone(px - on * u.ux, py - on * u.uy, pz - on * u.uz,
          dx - along * u.ux, dy - along * u.uy, dz - along * u.uz, r + slope * s, slope * along);
      slabEnter = Slab.enter(origin + s, along, half);
      slabLeave = Slab.leave(origin + s, along, half);
      enter = Math.max(side.enter, slabEnter);
      leave = Math.min(side.leave, slabLeave);
    }
  }

  /** Whether a point, relative to the origin, is the tip up to the rounding of a ray that comes from some distance. */
  private boolean isTip(final double px, final double py, final double pz, final double away) {
    final double rounding = ROUNDING * (Math.abs(away) + half + Math.abs(x) + Math.abs(y) + Math.abs(z));
    return r == 0 && px * px + py * py + pz * pz <= rounding * rounding;
  }

  /**
   * Whether a ray that passes beside the tip may be a rounded ray through it: by rounding in double or, close by, by that
   * of its direction and of the tip to floats, which changes each component relative to itself, and of which the part
   * across the ray counts.
   */
  private boolean isAimedAtTip(final double sx, final double sy, final double sz,
      final double dx, final double dy, final double dz) {
    final double wx = x - sx, wy = y - sy, wz = z - sz, away = wx * dx + wy * dy + wz * dz;
    if (!(r == 0 && away > 0)) {
      return false;
    }
    final double px = wx - away * dx, py = wy - away * dy, pz = wz - away * dz;
    final double close = CLOSE * Math.min(half, Math.max(rA, rB));
    final double tip = Math.abs(x * dx) + Math.abs(y * dy) + Math.abs(z * dz);
    return isTip(px, py, pz, away) || px * px + py * py + pz * pz <= close * close
        && isRounded(px, x, 2 * wx, tip * dx) && isRounded(py, y, 2 * wy, tip * dy) && isRounded(pz, z, 2 * wz, tip * dz)
        && !isOnSide(-wx, -wy, -wz);
  }

  /** Whether a point, relative to the origin, is on the side up to rounding; from there a ray may follow it to the tip. */
  private boolean isOnSide(final double px, final double py, final double pz) {
    final double s = axis.along(px, py, pz);
    final double off = Math.sqrt(Math.max(0, px * px + py * py + pz * pz - s * s)) - slope * s;
    return Math.abs(off) <= 4 * errorBound() * Math.sqrt(1 + slope * slope);
  }

  /** Whether a distance from the ray is no more than what rounding makes of some numbers. */
  private static boolean isRounded(final double off, final double a, final double b, final double c) {
    return Math.abs(off) <= FLOAT * (Math.abs(a) + Math.abs(b) + Math.abs(c));
  }

  private double errorBound() {
    return Rounding.bound(axis.x, axis.y, axis.z, 2 * (half + Math.max(rA, rB)));
  }

  @Override
  Hit hitAt(final Ray ray, final double t, final int part) {
    final double dx = ray.directionX(), dy = ray.directionY(), dz = ray.directionZ();
    final Chord chord = new Chord(ray.startX() - x, ray.startY() - y, ray.startZ() - z, dx, dy, dz);
    final double at = chord.start + t;
    final double qx = chord.px + at * dx, qy = chord.py + at * dy, qz = chord.pz + at * dz;
    if (!(chord.enter <= chord.leave) || isTip(qx, qy, qz, t)) {
      return onDisc(t, -Math.copySign(1, slope), 0, 0, 0);
    }
    final boolean entering = Math.abs(t - (chord.enter - chord.start)) <= Math.abs(t - (chord.leave - chord.start));
    if (entering ? chord.slabEnter >= chord.side.enter : chord.slabLeave <= chord.side.leave) {
      return onDisc(t, Math.copySign(1, entering ? -chord.along : chord.along), qx, qy, qz);
    }
    return onSide(t, qx, qy, qz);
  }

  /** A hit of the disc at A (−1) or B (1), or of the tip there, its point moved onto it. */
  private Hit onDisc(final double t, final double end, final double qx, final double qy, final double qz) {
    final Axis u = axis;
    final double s = u.along(qx, qy, qz), radius = end < 0 ? rA : rB;
    final double nx = qx - s * u.ux, ny = qy - s * u.uy, nz = qz - s * u.uz, off = Math.sqrt(nx * nx + ny * ny + nz * nz);
    return at(t, end * half, nx, ny, nz, off > radius ? radius / off : 1, end * u.ux, end * u.uy, end * u.uz);
  }

  /** A hit of the side, its point moved to the closest one of the side. */
  private Hit onSide(final double t, final double qx, final double qy, final double qz) {
    final Axis u = axis;
    final double along = u.along(qx, qy, qz);
    final double nx = qx - along * u.ux, ny = qy - along * u.uy, nz = qz - along * u.uz;
    final double off = Math.sqrt(nx * nx + ny * ny + nz * nz);
    if (!(off > 0)) {
      return onDisc(t, -Math.copySign(1, slope), 0, 0, 0);
    }
    final double s = Slab.within(origin + along + slope * ((off - r - slope * along) / (1 + slope * slope)), half);
    final double up = -slope * off;
    return at(t, s, nx, ny, nz, (r + slope * (s - origin)) / off, nx + up * u.ux, ny + up * u.uy, nz + up * u.uz);
  }

  /** A hit at s along the axis from P and k (x, y, z) from it. */
  private Hit at(final double t, final double s, final double kx, final double ky, final double kz, final double k,
      final double nx, final double ny, final double nz) {
    final Axis u = axis;
    return Hit.of(t, u.x + (s * u.ux + k * kx), u.y + (s * u.uy + k * ky), u.z + (s * u.uz + k * kz), nx, ny, nz,
        errorBound(), this);
  }

  @Override
  public BoundingBox getBoundingBox() {
    return axis.boxOfDisc(-half, rA).union(axis.boxOfDisc(half, rB));
  }

  @Override
  public List<Object> constructorArguments() {
    return List.of(axis.point(), axis.unit(), (float) rA, (float) rB, (float) (2 * half), colourOrMaterial());
  }

  @Override
  public String toString() {
    return "TruncatedCone(" + axis + ", rA=" + (float) rA + ", rB=" + (float) rB + ", l=" + (float) (2 * half) + ")";
  }
}
