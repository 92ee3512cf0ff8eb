package inspection;

import java.util.List;

import tracer.Ray;

/**
 * The ray of a pixel, and how the projection made it.
 *
 * @param m column from the left, from 0
 * @param n row from the bottom, from 0
 * @param W width of the image in pixels
 * @param H height of the image in pixels
 * @param projection simple name of the projection's class
 * @param formulas how the ray comes about, in the order of computing; of a projection that is not of the assignment only
 *     what all have in common
 * @param ray the ray, perhaps {@link Ray#NORAY}
 */
public record PixelRay(int m, int n, int W, int H, String projection, List<Formula> formulas, Ray ray) {

  /**
   * Copies the list.
   *
   * @param m column from the left, from 0
   * @param n row from the bottom, from 0
   * @param W width of the image in pixels
   * @param H height of the image in pixels
   * @param projection simple name of the projection's class
   * @param formulas how the ray comes about, in the order of computing; of a projection that is not of the
   *     assignment only what all have in common
   * @param ray the ray, perhaps {@link Ray#NORAY}
   */
  public PixelRay {
    formulas = List.copyOf(formulas);
  }
}
