package rendering;

import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/**
 * A surface as seen by the ray that hits it: both normals are turned together to the side of the ray, and the shading
 * normal is bent so that it faces the ray. With s = ±1 the sign of g·wo: g<sub>v</sub> = s g, and n = lift(s n, wo) where
 * the two normals differ. lift(w, a) = unit(w + max(0, ε − w·a) a) is the direction w, bent no more than needed to be on
 * the side of a. So nothing behind the facet lights it (Veach, "Robust Monte Carlo Methods for Light Transport
 * Simulation", 1997, section 5.3). Mutable, one for each thread.
 */
final class ViewedSurface {

  /** ε: least cosine of a lifted direction to the normal. */
  private static final double LIFT = 1e-3;

  private Hit hit = Hit.NOHIT;
  private boolean outside;
  private boolean bent;
  private double dx;
  private double dy;
  private double dz;
  private double gx;
  private double gy;
  private double gz;
  private double nx;
  private double ny;
  private double nz;
  private double distance;
  /** The result of {@link #lift}. */
  private double x;
  private double y;
  private double z;

  void set(final Ray ray, final Hit itsHit) {
    hit = itsHit;
    dx = ray.directionX();
    dy = ray.directionY();
    dz = ray.directionZ();
    final double hx = hit.geometricX(), hy = hit.geometricY(), hz = hit.geometricZ();
    outside = hx * dx + hy * dy + hz * dz <= 0;
    final double s = outside ? 1 : -1;
    gx = s * hx;
    gy = s * hy;
    gz = s * hz;
    nx = s * hit.normalX();
    ny = s * hit.normalY();
    nz = s * hit.normalZ();
    bent = nx != gx || ny != gy || nz != gz;
    if (bent) {
      lift(nx, ny, nz, -dx, -dy, -dz);
      nx = x;
      ny = y;
      nz = z;
    }
  }

  private void lift(final double wx, final double wy, final double wz, final double ax, final double ay, final double az) {
    final double k = bent ? Math.max(0, LIFT - (wx * ax + wy * ay + wz * az)) : 0;
    final double lx = wx + k * ax, ly = wy + k * ay, lz = wz + k * az, length = Math.sqrt(lx * lx + ly * ly + lz * lz);
    x = lx / length;
    y = ly / length;
    z = lz / length;
  }

  /** The mirrored ray, d + 2 (n·wo) n, lifted to the viewer's side of the facet. */
  Ray reflected() {
    final double k = -2 * (dx * nx + dy * ny + dz * nz);
    lift(dx + k * nx, dy + k * ny, dz + k * nz, gx, gy, gz);
    return hit.leave(outside, x, y, z);
  }

  /** The refracted ray, r d + (r co − cos θt) n, lifted to the other side of the facet. */
  Ray refracted(final double ratio, final double refractedCosine) {
    final double k = -ratio * (dx * nx + dy * ny + dz * nz) - refractedCosine;
    lift(ratio * dx + k * nx, ratio * dy + k * ny, ratio * dz + k * nz, -gx, -gy, -gz);
    return hit.leave(!outside, x, y, z);
  }

  /** The ray from where rays leave the surface on one side to the end of a unit vector w times a length from the hit. */
  Ray towards(final boolean onViewersSide, final double wx, final double wy, final double wz, final double length) {
    final double k = onViewersSide ? hit.offset() : -hit.offset();
    final double vx = length * wx - k * gx, vy = length * wy - k * gy, vz = length * wz - k * gz;
    distance = Math.sqrt(vx * vx + vy * vy + vz * vz);
    return hit.leave(onViewersSide == outside, vx / distance, vy / distance, vz / distance);
  }

  /** Length of the last ray that {@link #towards} made. */
  double distance() {
    return distance;
  }

  /** g<sub>v</sub>·w, positive before the facet. */
  double facing(final double wx, final double wy, final double wz) {
    return gx * wx + gy * wy + gz * wz;
  }

  /** Whether the viewer is on the side of the surface's own normal. */
  boolean isSeenFromOutside() {
    return outside;
  }

  /** The shading normal on the viewer's side. */
  Vector3D normal() {
    return new Vector3D((float) nx, (float) ny, (float) nz);
  }

  double normalX() {
    return nx;
  }

  double normalY() {
    return ny;
  }

  double normalZ() {
    return nz;
  }

  /** g<sub>v</sub>, the geometric normal on the viewer's side. */
  double geometricX() {
    return gx;
  }

  double geometricY() {
    return gy;
  }

  double geometricZ() {
    return gz;
  }
}
