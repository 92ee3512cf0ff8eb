package models;

import static arguments.Arguments.direction;
import static arguments.Arguments.finite;

import java.awt.Color;
import java.util.List;

import materials.Material;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/**
 * An infinite plane: (P − Q)·n = 0, with the given normal n. Rays hit it from both sides; a ray within the plane does
 * not.
 *
 * <p><img src="doc-files/Plane.png" width="320" height="240" alt="A plane, and its normal">
 *
 * <p>t = (Q − R)·n / (v·n), which is infinite or NaN, and so a miss, for a ray parallel to the plane. Source: Haines,
 * "Essential Ray Tracing Algorithms", in Glassner (ed.), "An Introduction to Ray Tracing", 1989, chapter 2.
 */
public class Plane extends Object3D {

  private final double x;
  private final double y;
  private final double z;
  private final double nx;
  private final double ny;
  private final double nz;

  /**
   * A plane.
   *
   * @param P a point of it
   * @param n its normal, of any length but 0
   * @param color colour
   * @throws IllegalArgumentException if an argument is null or not finite, or if n is zero
   */
  public Plane(final Point3D P, final Vector3D n, final Color color) {
    this(P, n, Appearance.of(color));
  }

  /**
   * A plane of a material.
   *
   * @param P a point of it
   * @param n its normal, of any length but 0
   * @param material material
   * @throws IllegalArgumentException if an argument is null or not finite, or if n is zero
   */
  public Plane(final Point3D P, final Vector3D n, final Material material) {
    this(P, n, Appearance.of(material));
  }

  private Plane(final Point3D P, final Vector3D n, final Appearance appearance) {
    super(appearance);
    this.x = finite("P", P).x;
    this.y = P.y;
    this.z = P.z;
    final double length = Axis.length(direction("n", n));
    this.nx = n.x / length;
    this.ny = n.y / length;
    this.nz = n.z / length;
  }

  @Override
  public Hit intersectionWith(final Ray ray) {
    return closestHit(ray);
  }

  @Override
  double distance(final double sx, final double sy, final double sz, final double dx, final double dy, final double dz) {
    final double t = ((x - sx) * nx + (y - sy) * ny + (z - sz) * nz) / (dx * nx + dy * ny + dz * nz);
    return t > 0 ? t : Double.POSITIVE_INFINITY;
  }

  @Override
  Hit hitAt(final Ray ray, final double t, final int part) {
    final double sx = ray.startX(), sy = ray.startY(), sz = ray.startZ();
    final double error = Rounding.bound(sx, sy, sz, t + Math.abs(x) + Math.abs(y) + Math.abs(z));
    return Hit.of(t, sx + t * ray.directionX(), sy + t * ray.directionY(), sz + t * ray.directionZ(),
        nx, ny, nz, error, this);
  }

  @Override
  public List<Object> constructorArguments() {
    return List.of(new Point3D((float) x, (float) y, (float) z), new Vector3D((float) nx, (float) ny, (float) nz),
        colourOrMaterial());
  }

  @Override
  public String toString() {
    return "Plane(P=(" + (float) x + ", " + (float) y + ", " + (float) z + "), n=("
        + (float) nx + ", " + (float) ny + ", " + (float) nz + "))";
  }
}
