package inspection;

import java.util.List;

import tracer.Ray;

/**
 * The ray of a pixel, and how the projection computes it.
 *
 * @param m column from the left, from 0
 * @param n row from the bottom, from 0
 * @param W width of the image in pixels
 * @param H height of the image in pixels
 * @param projection simple name of the projection's class
 * @param formulas the formulas of the ray in order of evaluation; for a user-written projection only those that all
 *     projections share
 * @param ray the ray, possibly {@link Ray#NORAY}
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
   * @param formulas the formulas of the ray in order of evaluation; for a user-written projection only those that all
   *     projections share
   * @param ray the ray, possibly {@link Ray#NORAY}
   */
  public PixelRay {
    formulas = List.copyOf(formulas);
  }
}
