package models;

import static arguments.Arguments.finite;
import static arguments.Arguments.wrong;

import java.awt.Color;
import java.util.List;

import materials.Material;
import primitives.BoundingBox;
import primitives.Point3D;
import tracer.Hit;
import tracer.Ray;

/**
 * A triangle, which rays hit from both sides. Its normal is (B − A) × (C − A): it points to the side from which the
 * vertices A, B, C appear counter-clockwise.
 *
 * <p><img src="doc-files/Triangle.png" width="320" height="240" alt="A triangle, and its normal">
 *
 * <p>With the vertices relative to the start of the ray, there is a hit if no two of v·(B × C), v·(C × A) and v·(A × B)
 * differ in sign, at t = A·n / (v·n), where n = (B − A) × (C − A). {@code WatertightTest} computes the signs so that no
 * ray passes between triangles that share an edge or a vertex. Sources: Segura and Feito, "Algorithms to test
 * ray-triangle intersection", WSCG 2001; Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013.
 */
public class Triangle extends Object3D {

  /** Height of a triangle, relative to its greatest coordinate, that can be due to rounding coordinates to floats alone. */
  private static final double ROUNDING = 0x1p-24;

  private final float ax;
  private final float ay;
  private final float az;
  private final float bx;
  private final float by;
  private final float bz;
  private final float cx;
  private final float cy;
  private final float cz;

  /**
   * A triangle.
   *
   * @param A first vertex
   * @param B second vertex, counter-clockwise
   * @param C third vertex
   * @param color colour
   * @throws IllegalArgumentException if an argument is null or not finite, or if the vertices lie on one line, up to
   *     the rounding of their coordinates
   */
  public Triangle(final Point3D A, final Point3D B, final Point3D C, final Color color) {
    this(A, B, C, Appearance.of(color));
  }

  /**
   * A triangle of a material.
   *
   * @param A first vertex
   * @param B second vertex, counter-clockwise
   * @param C third vertex
   * @param material material
   * @throws IllegalArgumentException if an argument is null or not finite, or if the vertices lie on one line, up to
   *     the rounding of their coordinates
   */
  public Triangle(final Point3D A, final Point3D B, final Point3D C, final Material material) {
    this(A, B, C, Appearance.of(material));
  }

  private Triangle(final Point3D A, final Point3D B, final Point3D C, final Appearance appearance) {
    this(new double[] {finite("A", A).x, A.y, A.z, finite("B", B).x, B.y, B.z, finite("C", C).x, C.y, C.z}, 0, 3, 6,
        appearance);
    if (isAligned()) {
      throw wrong("aligned", A, B, C);
    }
  }

  /** A triangle of a mesh of one colour. */
  Triangle(final double[] coordinates, final int a, final int b, final int c, final Color color) {
    this(coordinates, a, b, c, Appearance.of(color));
  }

  /** A triangle of a mesh, whose vertices start at the places a, b and c of its coordinates, which are floats. */
  Triangle(final double[] coordinates, final int a, final int b, final int c, final Appearance appearance) {
    super(appearance);
    ax = (float) coordinates[a];
    ay = (float) coordinates[a + 1];
    az = (float) coordinates[a + 2];
    bx = (float) coordinates[b];
    by = (float) coordinates[b + 1];
    bz = (float) coordinates[b + 2];
    cx = (float) coordinates[c];
    cy = (float) coordinates[c + 1];
    cz = (float) coordinates[c + 2];
  }

  /** A triangle with the vertices of another. */
  Triangle(final Triangle other, final Appearance appearance) {
    super(appearance);
    ax = other.ax;
    ay = other.ay;
    az = other.az;
    bx = other.bx;
    by = other.by;
    bz = other.bz;
    cx = other.cx;
    cy = other.cy;
    cz = other.cz;
  }

  /** The unit normal. */
  final float[] unitNormal() {
    final double x = normalX(), y = normalY(), z = normalZ(), length = Math.sqrt(x * x + y * y + z * z);
    return new float[] {(float) (x / length), (float) (y / length), (float) (z / length)};
  }

  private boolean isAligned() {
    final double px = (double) bx - ax, py = (double) by - ay, pz = (double) bz - az;
    final double qx = (double) cx - ax, qy = (double) cy - ay, qz = (double) cz - az;
    final double longest = Math.max(Math.hypot(Math.hypot(px, py), pz),
        Math.max(Math.hypot(Math.hypot(qx, qy), qz), Math.hypot(Math.hypot(qx - px, qy - py), qz - pz)));
    float greatest = 0;
    for (final float coordinate : new float[] {ax, ay, az, bx, by, bz, cx, cy, cz}) {
      greatest = Math.max(greatest, Math.abs(coordinate));
    }
    final double doubleArea = Math.hypot(Math.hypot(normalX(), normalY()), normalZ());
    return !(doubleArea > ROUNDING * greatest * longest);
  }

  final double normalX() {
    return ((double) by - ay) * ((double) cz - az) - ((double) bz - az) * ((double) cy - ay);
  }

  final double normalY() {
    return ((double) bz - az) * ((double) cx - ax) - ((double) bx - ax) * ((double) cz - az);
  }

  final double normalZ() {
    return ((double) bx - ax) * ((double) cy - ay) - ((double) by - ay) * ((double) cx - ax);
  }

  @Override
  public Hit intersectionWith(final Ray ray) {
    return closestHit(ray);
  }

  @Override
  double distance(final double x, final double y, final double z, final double dx, final double dy, final double dz) {
    final double t = WatertightTest.distance(ax - x, ay - y, az - z, bx - x, by - y, bz - z, cx - x, cy - y, cz - z,
        dx, dy, dz, WatertightTest.error(greatest(x, y, z)));
    return t > 0 ? t : Double.POSITIVE_INFINITY;
  }

  /** The greatest coordinate of a vertex, seen from a point: that of the box, which need not be fetched for it. */
  private double greatest(final double x, final double y, final double z) {
    return Math.max(greatestOf(ax - x, bx - x, cx - x), Math.max(greatestOf(ay - y, by - y, cy - y),
        greatestOf(az - z, bz - z, cz - z)));
  }

  private static double greatestOf(final double a, final double b, final double c) {
    return Math.max(Math.abs(a), Math.max(Math.abs(b), Math.abs(c)));
  }

  @Override
  Hit hitAt(final Ray ray, final double t, final int part) {
    final double nx = normalX(), ny = normalY(), nz = normalZ();
    return Hit.of(t, within(ax, bx, cx, ray.startX() + t * ray.directionX()),
        within(ay, by, cy, ray.startY() + t * ray.directionY()), within(az, bz, cz, ray.startZ() + t * ray.directionZ()),
        nx, ny, nz, errorBound(ray, t, Math.sqrt(nx * nx + ny * ny + nz * nz)), this);
  }

  /** The hit at a distance, with a normal that shades and texture coordinates. */
  final Hit hitAt(final Ray ray, final double t, final double sx, final double sy, final double sz,
      final double u, final double v) {
    final double nx = normalX(), ny = normalY(), nz = normalZ();
    return Hit.shaded(t, within(ax, bx, cx, ray.startX() + t * ray.directionX()),
        within(ay, by, cy, ray.startY() + t * ray.directionY()), within(az, bz, cz, ray.startZ() + t * ray.directionZ()),
        nx, ny, nz, errorBound(ray, t, Math.sqrt(nx * nx + ny * ny + nz * nz)), this, sx, sy, sz, u, v);
  }

  /**
   * The barycentric coordinates of the point of a ray at a distance, by the areas of the triangles that it makes with each
   * two vertices, counted from the first vertex: so a start far away costs no precision.
   */
  Weights weights(final Ray ray, final double t) {
    final double x = ray.startX() - ax + t * ray.directionX(), y = ray.startY() - ay + t * ray.directionY(),
        z = ray.startZ() - az + t * ray.directionZ();
    final double px = (double) bx - ax, py = (double) by - ay, pz = (double) bz - az;
    final double qx = (double) cx - ax, qy = (double) cy - ay, qz = (double) cz - az;
    final double nx = normalX(), ny = normalY(), nz = normalZ(), inverse = 1 / (nx * nx + ny * ny + nz * nz);
    final double b = (nx * (y * qz - z * qy) + ny * (z * qx - x * qz) + nz * (x * qy - y * qx)) * inverse;
    final double c = (nx * (py * z - pz * y) + ny * (pz * x - px * z) + nz * (px * y - py * x)) * inverse;
    return Weights.proportionalTo(1 - b - c, b, c);
  }

  /** The normal of a thin triangle is less exact than its edges, by as much as the product of two is longer. */
  private double errorBound(final Ray ray, final double t, final double doubleArea) {
    final double px = (double) bx - ax, py = (double) by - ay, pz = (double) bz - az;
    final double qx = (double) cx - ax, qy = (double) cy - ay, qz = (double) cz - az;
    final double edges = Math.sqrt((px * px + py * py + pz * pz) * (qx * qx + qy * qy + qz * qz));
    return Rounding.bound(ray.startX(), ray.startY(), ray.startZ(), t + Math.sqrt(edges)) * edges / doubleArea;
  }

  /** A coordinate of a hit, clamped to the box of the vertices. */
  private static double within(final float a, final float b, final float c, final double computed) {
    return Math.max(Math.min(a, Math.min(b, c)), Math.min(Math.max(a, Math.max(b, c)), computed));
  }

  @Override
  public BoundingBox getBoundingBox() {
    return new BoundingBox(
        new Point3D(Math.min(ax, Math.min(bx, cx)), Math.min(ay, Math.min(by, cy)), Math.min(az, Math.min(bz, cz))),
        new Point3D(Math.max(ax, Math.max(bx, cx)), Math.max(ay, Math.max(by, cy)), Math.max(az, Math.max(bz, cz))));
  }

  @Override
  public List<Object> constructorArguments() {
    return List.of(new Point3D(ax, ay, az), new Point3D(bx, by, bz), new Point3D(cx, cy, cz), colourOrMaterial());
  }

  @Override
  public String toString() {
    return "Triangle(A=(" + ax + ", " + ay + ", " + az + "), B=(" + bx + ", " + by + ", " + bz
        + "), C=(" + cx + ", " + cy + ", " + cz + "))";
  }
}
