package rendering;

import tracer.Hit;
import tracer.Ray;

/**
 * Receives the hit of each pixel of a picture, and makes a colour of it, or a number of some pass. Called by several
 * threads concurrently, once for each pixel.
 */
public interface PixelWriter {

  /**
   * Called for a pixel whose ray hits something.
   *
   * @param pixel number of the pixel, row by row from the top
   * @param ray its ray
   * @param hit the closest hit
   */
  void hit(int pixel, Ray ray, Hit hit);

  /**
   * Called for a pixel whose ray hits nothing.
   *
   * @param pixel number of the pixel, row by row from the top
   * @param ray its ray; {@link Ray#NORAY} if the projection sends none through the pixel
   */
  void miss(int pixel, Ray ray);
}
