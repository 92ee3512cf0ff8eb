package models;

import static arguments.Arguments.finite;
import static arguments.Arguments.notNull;
import static arguments.Arguments.positive;

import java.awt.Color;
import java.util.List;

import materials.Material;
import materials.Texture;
import primitives.BoundingBox;
import primitives.Point3D;
import tracer.Hit;
import tracer.Ray;

/**
 * A sphere: |P − C|² = r².
 *
 * <p><img src="doc-files/Sphere.png" width="320" height="240" alt="A sphere">
 *
 * <p>With l = C − R, t² − 2 (l·v) t + l² − r² = 0. The discriminant is r² less the squared distance of the centre from the
 * ray's line, which does not cancel when the sphere is far away; the roots are computed without cancellation, and the point
 * of a hit is moved onto the sphere, so that point and normal agree. Source: Haines, Günther and Akenine-Möller,
 * "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, 2019, chapter 7.
 */
public class Sphere extends Object3D {

  private final double x;
  private final double y;
  private final double z;
  private final double r;
  private final Texture texture;

  /**
   * A sphere.
   *
   * @param C centre
   * @param r radius, &gt; 0
   * @param color colour
   * @throws IllegalArgumentException if an argument is null or not finite, or if r is not positive
   */
  public Sphere(final Point3D C, final float r, final Color color) {
    this(C, r, Appearance.of(color), null);
  }

  /**
   * A sphere of a material.
   *
   * @param C centre
   * @param r radius, &gt; 0
   * @param material material
   * @throws IllegalArgumentException if an argument is null or not finite, or if r is not positive
   */
  public Sphere(final Point3D C, final float r, final Material material) {
    this(C, r, Appearance.of(material), null);
  }

  /**
   * A sphere with a texture. With p = (P − C) / r, the point P of the sphere has the texture coordinates u = ½ +
   * atan2(p.x, p.z) / 2π and v = ½ + asin(p.y) / π: the middle of the image faces +Z, its top is at +Y, it is not
   * mirrored when seen from outside, and the seam faces −Z. An {@link AffineTransformation} rotates it.
   *
   * @param C centre
   * @param r radius, &gt; 0
   * @param texture texture, whose mean colour is that of the object
   * @throws IllegalArgumentException if an argument is null or not finite, or if r is not positive
   */
  public Sphere(final Point3D C, final float r, final Texture texture) {
    this(C, r, Appearance.of(notNull("texture", texture).getMeanColor()), texture);
  }

  private Sphere(final Point3D C, final float r, final Appearance appearance, final Texture texture) {
    super(appearance);
    this.texture = texture;
    this.x = finite("C", C).x;
    this.y = C.y;
    this.z = C.z;
    this.r = positive("r", r);
  }

  @Override
  public Hit intersectionWith(final Ray ray) {
    return closestHit(ray);
  }

  @Override
  double distance(final double sx, final double sy, final double sz, final double dx, final double dy, final double dz) {
    final double lx = x - sx, ly = y - sy, lz = z - sz;
    final double b = lx * dx + ly * dy + lz * dz;
    final double px = lx - b * dx, py = ly - b * dy, pz = lz - b * dz;
    final double discriminant = r * r - (px * px + py * py + pz * pz);
    if (!(discriminant >= 0)) {
      return Double.POSITIVE_INFINITY;
    }
    final double root = Math.sqrt(discriminant), c = lx * lx + ly * ly + lz * lz - r * r;
    return Quadratic.firstPositive(Quadratic.smaller(1, b, c, root), Quadratic.greater(1, b, c, root));
  }

  @Override
  Hit hitAt(final Ray ray, final double t, final int part) {
    final double nx = ray.startX() + t * ray.directionX() - x, ny = ray.startY() + t * ray.directionY() - y,
        nz = ray.startZ() + t * ray.directionZ() - z;
    final double s = r / Math.sqrt(nx * nx + ny * ny + nz * nz);
    final double error = Rounding.bound(x, y, z, 2 * r);
    return texture == null ? Hit.of(t, x + s * nx, y + s * ny, z + s * nz, nx, ny, nz, error, this)
        : Hit.shaded(t, x + s * nx, y + s * ny, z + s * nz, nx, ny, nz, error, this, nx, ny, nz,
            textureU(nx, nz), textureV(nx, ny, nz));
  }

  /** From left to right around the Y axis; ½ at the poles, where any value is right. */
  private static double textureU(final double px, final double pz) {
    return px == 0 && pz == 0 ? 0.5 : 0.5 + Math.atan2(px, pz) / (2 * Math.PI);
  }

  /** From the lower pole to the upper; near them the arc tangent is more accurate than the arc sine. */
  private static double textureV(final double px, final double py, final double pz) {
    return 0.5 + Math.atan2(py, Math.sqrt(px * px + pz * pz)) / Math.PI;
  }

  @Override
  Texture texture() {
    return texture;
  }

  @Override
  boolean isTextured() {
    return texture != null;
  }

  /**
   * The colour to be painted at a hit: with a texture, its texel there.
   *
   * @param hit the hit, whose object is this one
   * @return the colour
   * @throws IllegalArgumentException if the hit is null
   */
  @Override
  public Color getColorAt(final Hit hit) {
    return texture == null || Double.isNaN(notNull("hit", hit).textureU()) ? super.getColorAt(hit)
        : texture.getColor(hit.textureU(), hit.textureV());
  }

  @Override
  public BoundingBox getBoundingBox() {
    return BoundingBox.around(x, y, z, r, r, r);
  }

  @Override
  public List<Object> constructorArguments() {
    return List.of(new Point3D((float) x, (float) y, (float) z), (float) r, colourOrMaterial());
  }

  @Override
  Object colourOrMaterial() {
    return texture == null ? super.colourOrMaterial() : texture;
  }

  @Override
  public String toString() {
    return "Sphere(C=(" + (float) x + ", " + (float) y + ", " + (float) z + "), r=" + (float) r + ")";
  }
}
