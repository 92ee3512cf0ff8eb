package rendering;

import java.awt.Color;

import tracer.Hit;
import tracer.Ray;

/** How a hit becomes a colour. Asked by several threads at once. */
@FunctionalInterface
public interface Shading {

  /** The plain colour of the object, as the assignment asks. */
  Shading PLAIN = (ray, hit) -> hit.getObject().getColor().getRGB();

  /**
   * The colour of the object by how directly the surface faces the ray: its sRGB values times the cosine between the ray
   * and the normal on the ray's side. Alpha stays.
   */
  Shading FACING = (ray, hit) -> {
    final double cosine = Math.abs(hit.normalX() * ray.directionX() + hit.normalY() * ray.directionY()
        + hit.normalZ() * ray.directionZ());
    final double k = Math.min(1, cosine);
    final Color color = hit.getObject().getColor();
    return color.getAlpha() << 24 | (int) (k * color.getRed() + 0.5) << 16 | (int) (k * color.getGreen() + 0.5) << 8
        | (int) (k * color.getBlue() + 0.5);
  };

  /**
   * The colour of a pixel.
   *
   * @param ray the pixel's ray
   * @param hit what it meets, a hit
   * @return sRGB with alpha in the highest byte
   */
  int argb(Ray ray, Hit hit);
}
