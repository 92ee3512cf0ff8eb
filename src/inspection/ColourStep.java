package inspection;

/**
 * A step in computing the colour of a pixel from its hit.
 *
 * @param kind the kind of step
 * @param number the number it computes; 0 if it computes none
 * @param argb the colour after the step, sRGB with alpha
 */
public record ColourStep(Kind kind, double number, int argb) {

  /** The kinds of steps. */
  public enum Kind {
    /** The projection sends no ray through the pixel: the colour of the background. */
    NO_RAY,
    /** The ray hits nothing: the colour of the background. */
    BACKGROUND,
    /** The colour of the closest object. */
    OBJECT,
    /** The radiance of the lit surface is shown: see {@link Inspection#light}. */
    RADIANCE,
    /** Red, green and blue are multiplied by the number, the cosine between the ray and the normal on its side. */
    COSINE
  }
}
