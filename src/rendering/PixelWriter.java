package rendering;

import tracer.Hit;
import tracer.Ray;

/**
 * What becomes of each pixel of a picture: a colour, or a number of some pass. Called by several threads at once, for each
 * pixel once.
 */
public interface PixelWriter {

  /**
   * The ray of a pixel hits something.
   *
   * @param pixel number of the pixel, row by row from the top
   * @param ray its ray
   * @param hit the closest hit
   */
  void hit(int pixel, Ray ray, Hit hit);

  /**
   * The ray of a pixel hits nothing.
   *
   * @param pixel number of the pixel, row by row from the top
   * @param ray its ray; {@link Ray#NORAY} if the projection sends none through the pixel
   */
  void miss(int pixel, Ray ray);
}
