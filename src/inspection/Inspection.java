package inspection;

import java.util.List;
import java.util.Optional;

/**
 * Everything known about a pixel.
 *
 * @param pixel the pixel and its ray
 * @param intersections the objects hit by the ray in order of t, followed by missed objects that have violations or a
 *     sphere trace
 * @param colour the steps that compute the colour; the last one has the colour of the pixel
 * @param tests cost of finding the closest hit, see {@link models.Cost}
 * @param light the tree of the light; empty if the scene is not lit or the ray hits nothing
 */
public record Inspection(PixelRay pixel, List<Intersection> intersections, List<ColourStep> colour, int tests,
    Optional<PixelLight> light) {

  /**
   * Copies the lists.
   *
   * @param pixel the pixel and its ray
   * @param intersections the objects hit by the ray in order of t, followed by missed objects that have violations or a
   *     sphere trace
   * @param colour the steps that compute the colour; the last one has the colour of the pixel
   * @param tests cost of finding the closest hit, see {@link models.Cost}
   * @param light the tree of the light; empty if the scene is not lit or the ray hits nothing
   */
  public Inspection {
    intersections = List.copyOf(intersections);
    colour = List.copyOf(colour);
  }

  /**
   * The intersection that is shown.
   *
   * @return the closest intersection; empty if the ray hits nothing
   */
  public Optional<Intersection> winner() {
    return intersections.stream().filter(Intersection::winner).findFirst();
  }

  /**
   * The colour of the pixel.
   *
   * @return sRGB with alpha
   */
  public int argb() {
    return colour.get(colour.size() - 1).argb();
  }
}
