package inspection;

/**
 * A step of the way from a hit to the colour of its pixel.
 *
 * @param kind what happens
 * @param number the number that it gives, if it gives one; else 0
 * @param argb the colour after it, sRGB with alpha
 */
public record ColourStep(Kind kind, double number, int argb) {

  /** What happens in a step. */
  public enum Kind {
    /** The projection sends no ray through the pixel: the colour of the background. */
    NO_RAY,
    /** The ray meets nothing: the colour of the background. */
    BACKGROUND,
    /** The colour of the object that is met. */
    OBJECT,
    /** The cosine between the ray and the normal on its side, the number, times red, green and blue. */
    COSINE
  }
}
