package rendering;

import java.awt.Color;

import tracer.Hit;
import tracer.Ray;

/** How a hit becomes a colour. Called by several threads concurrently. */
@FunctionalInterface
public interface Shading {

  /** The plain colour of the object at the hit, as the assignment asks. */
  Shading PLAIN = (ray, hit) -> hit.getObject().getColorAt(hit).getRGB();

  /**
   * The colour of the object at the hit, as bright as the surface faces the ray: its sRGB values times the cosine between
   * the ray and the normal that shades, on the side of the geometric normal from which the ray comes; 0 where that normal
   * is turned away. Alpha stays.
   */
  Shading FACING = (ray, hit) -> {
    final double dx = ray.directionX(), dy = ray.directionY(), dz = ray.directionZ();
    final double cosine = hit.normalX() * dx + hit.normalY() * dy + hit.normalZ() * dz;
    final boolean outside = hit.geometricX() * dx + hit.geometricY() * dy + hit.geometricZ() * dz <= 0;
    final double k = Math.max(0, Math.min(1, outside ? -cosine : cosine));
    final Color color = hit.getObject().getColorAt(hit);
    return color.getAlpha() << 24 | (int) (k * color.getRed() + 0.5) << 16 | (int) (k * color.getGreen() + 0.5) << 8
        | (int) (k * color.getBlue() + 0.5);
  };

  /**
   * The colour of a pixel.
   *
   * @param ray the pixel's ray
   * @param hit its hit, not {@link Hit#NOHIT}
   * @return sRGB with alpha in the highest byte
   */
  int argb(Ray ray, Hit hit);
}
