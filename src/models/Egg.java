package models;

import static arguments.Arguments.greater;
import static arguments.Arguments.positive;

import java.awt.Color;
import java.util.List;

import materials.Material;
import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/**
 * An egg: in the frame with origin C and the y axis along the egg's axis,
 * (x² + z²) (b² + 2 w y + w²) + a² y² = a² b² with |y| ≤ b.
 *
 * <p><img src="doc-files/Egg.png" width="320" height="240" alt="An egg, and its axis">
 *
 * <p>It is a convex surface of revolution with its poles at y = ±b, the pointed one at y = b, and with the largest
 * radius, which is a, at y = −w. For w → 0 it becomes the ellipsoid of radii a, b, a. The equation has a second,
 * unbounded sheet below y = −(b² + w²) / 2w, which is not part of the egg.
 *
 * <p>Along a ray the equation is a cubic in t. Its roots are not taken from Cardano's formula, which cancels, but
 * approached by Newton's method from both ends of a stretch that is known to contain them ({@code EggChord}); t counts
 * from the point of the ray closest to C, so that no digits are lost when the ray comes from far away. The point of a hit
 * is moved onto the surface by one more Newton step along the normal (x q, w (x² + z²) + a² y, z q), q = b² + 2 w y + w².
 * Source of the curve: Petrović and Malešević, "Hügelschäffer egg curve and surface", Applicable Analysis and Discrete
 * Mathematics, 2022.
 */
public class Egg extends Object3D {

  private final Axis axis;
  private final EggProfile profile;
  private final BoundingBox box;

  /**
   * An egg.
   *
   * @param C centre of the frame, halfway between the poles
   * @param axis direction of the axis, towards the pointed pole, of any length but 0
   * @param a largest radius, &gt; 0
   * @param b distance of both poles from C, &gt; w
   * @param w distance below C at which the radius is largest, &gt; 0
   * @param color colour
   * @throws IllegalArgumentException if an argument is null or not finite, if the axis is zero, if a or w is not positive,
   *     or if b is not greater than w
   */
  public Egg(final Point3D C, final Vector3D axis, final float a, final float b, final float w, final Color color) {
    this(C, axis, a, b, w, Appearance.of(color));
  }

  /**
   * An egg of a material.
   *
   * @param C centre of the frame, halfway between the poles
   * @param axis direction of the axis, towards the pointed pole, of any length but 0
   * @param a largest radius, &gt; 0
   * @param b distance of both poles from C, &gt; w
   * @param w distance below C at which the radius is largest, &gt; 0
   * @param material material
   * @throws IllegalArgumentException if an argument is null or not finite, if the axis is zero, if a or w is not positive,
   *     or if b is not greater than w
   */
  public Egg(final Point3D C, final Vector3D axis, final float a, final float b, final float w, final Material material) {
    this(C, axis, a, b, w, Appearance.of(material));
  }

  private Egg(final Point3D C, final Vector3D axis, final float a, final float b, final float w,
      final Appearance appearance) {
    super(appearance);
    this.axis = new Axis("C", C, "axis", axis);
    this.profile = new EggProfile(positive("a", a), greater("b", positive("b", b), "w", positive("w", w)), w);
    this.box = box();
  }

  private BoundingBox box() {
    final Axis u = axis;
    final EggProfile p = profile;
    final double maxX = p.support(u.ux, u.acrossX()), minX = -p.support(-u.ux, u.acrossX());
    final double maxY = p.support(u.uy, u.acrossY()), minY = -p.support(-u.uy, u.acrossY());
    final double maxZ = p.support(u.uz, u.acrossZ()), minZ = -p.support(-u.uz, u.acrossZ());
    return BoundingBox.around(u.x + 0.5 * (minX + maxX), u.y + 0.5 * (minY + maxY), u.z + 0.5 * (minZ + maxZ),
        0.5 * (maxX - minX), 0.5 * (maxY - minY), 0.5 * (maxZ - minZ));
  }

  @Override
  public Hit intersectionWith(final Ray ray) {
    return closestHit(ray);
  }

  @Override
  double distance(final double sx, final double sy, final double sz, final double dx, final double dy, final double dz) {
    final Axis u = axis;
    final double lx = sx - u.x, ly = sy - u.y, lz = sz - u.z, start = lx * dx + ly * dy + lz * dz;
    final double px = lx - start * dx, py = ly - start * dy, pz = lz - start * dz;
    final double y = u.along(px, py, pz), d = u.along(dx, dy, dz);
    final EggChord chord = new EggChord(profile, px - y * u.ux, py - y * u.uy, pz - y * u.uz, y,
        dx - d * u.ux, dy - d * u.uy, dz - d * u.uz, d);
    return Quadratic.firstPositive(chord.enter - start, chord.leave - start);
  }

  @Override
  Hit hitAt(final Ray ray, final double t, final int part) {
    final Axis u = axis;
    final double a2 = profile.a * profile.a, b = profile.b, w = profile.w;
    final double px = ray.startX() - u.x + t * ray.directionX(), py = ray.startY() - u.y + t * ray.directionY(),
        pz = ray.startZ() - u.z + t * ray.directionZ();
    final double y = u.along(px, py, pz), q = profile.denominator(b + y);
    final double rx = px - y * u.ux, ry = py - y * u.uy, rz = pz - y * u.uz, r2 = rx * rx + ry * ry + rz * rz;
    final double up = w * r2 + a2 * y, f = r2 * q - a2 * (b + y) * (b - y);
    final double step = f / (2 * (q * q * r2 + up * up));
    final double x1 = px - step * (q * rx + up * u.ux), y1 = py - step * (q * ry + up * u.uy),
        z1 = pz - step * (q * rz + up * u.uz);
    final double k = 1 - step * q, yk = y - step * up, qk = profile.denominator(b + yk), upk = w * k * k * r2 + a2 * yk;
    return Hit.of(t, u.x + x1, u.y + y1, u.z + z1, qk * k * rx + upk * u.ux, qk * k * ry + upk * u.uy,
        qk * k * rz + upk * u.uz, Rounding.bound(u.x, u.y, u.z, 2 * (profile.a + b)), this);
  }

  @Override
  public BoundingBox getBoundingBox() {
    return box;
  }

  @Override
  public List<Object> constructorArguments() {
    return List.of(axis.point(), axis.unit(), (float) profile.a, (float) profile.b, (float) profile.w, colourOrMaterial());
  }

  @Override
  public String toString() {
    return "Egg(" + axis.toString("C", "axis") + ", a=" + (float) profile.a + ", b=" + (float) profile.b
        + ", w=" + (float) profile.w + ")";
  }
}
