package inspection;

import java.util.List;
import java.util.Optional;

/**
 * All that is to be known of a pixel.
 *
 * @param pixel the pixel and its ray
 * @param meetings the objects that the ray meets, in the order of t; at the end those that it does not meet but that have
 *     findings or a march
 * @param colour how the colour comes about, step by step; the last step has the colour of the pixel
 * @param tests what finding the closest hit cost, see {@link models.Cost}
 */
public record Inspection(PixelRay pixel, List<Intersection> meetings, List<ColourStep> colour, int tests) {

  /**
   * Copies the lists.
   *
   * @param pixel the pixel and its ray
   * @param meetings the objects that the ray meets, in the order of t; at the end those that it does not meet but that
   *     have findings or a march
   * @param colour how the colour comes about, step by step; the last step has the colour of the pixel
   * @param tests what finding the closest hit cost, see {@link models.Cost}
   */
  public Inspection {
    meetings = List.copyOf(meetings);
    colour = List.copyOf(colour);
  }

  /**
   * The meeting that is painted.
   *
   * @return the closest; empty if nothing is met
   */
  public Optional<Intersection> winner() {
    return meetings.stream().filter(Intersection::winner).findFirst();
  }

  /**
   * Colour of the pixel.
   *
   * @return sRGB with alpha
   */
  public int argb() {
    return colour.get(colour.size() - 1).argb();
  }
}
