package rendering;

import static arguments.Arguments.notNull;

import java.util.Arrays;
import java.util.function.ToDoubleBiFunction;

import models.Cost;
import models.Object3D;
import tracer.Hit;
import tracer.Ray;

/** A picture of numbers, one for each pixel, which {@link ColourScale} makes visible. Safe for use by several threads. */
public final class NumberPass implements PixelWriter {

  private final double[] numbers;
  private final ToDoubleBiFunction<Ray, Hit> number;

  private NumberPass(final int pixels, final ToDoubleBiFunction<Ray, Hit> number) {
    this.number = number;
    this.numbers = new double[pixels];
    Arrays.fill(numbers, Double.NaN);
  }

  /**
   * The distances of what is hit.
   *
   * @param pixels number of pixels
   * @return the pass, in which no pixel has a number yet
   */
  public static NumberPass ofDepth(final int pixels) {
    return new NumberPass(pixels, (ray, hit) -> hit.hits() ? hit.getT() : Double.NaN);
  }

  /**
   * The cost of each ray: see {@link Cost}. A pixel without a ray costs nothing.
   *
   * @param pixels number of pixels
   * @param scene the scene
   * @return the pass, in which no pixel has a number yet
   * @throws IllegalArgumentException if the scene is null
   */
  public static NumberPass ofCost(final int pixels, final Object3D scene) {
    notNull("scene", scene);
    return new NumberPass(pixels, (ray, hit) -> ray == Ray.NORAY ? Double.NaN : Cost.of(scene, ray));
  }

  @Override
  public void hit(final int pixel, final Ray ray, final Hit hit) {
    numbers[pixel] = number.applyAsDouble(ray, hit);
  }

  @Override
  public void miss(final int pixel, final Ray ray) {
    numbers[pixel] = number.applyAsDouble(ray, Hit.NOHIT);
  }

  /**
   * The number of a pixel.
   *
   * @param pixel its number, row by row from the top
   * @return the number; NaN if it has none, or has not been computed yet
   */
  public double at(final int pixel) {
    return numbers[pixel];
  }
}
