package scenes;

import static arguments.Arguments.notNegative;
import static arguments.Arguments.notNull;
import static arguments.Arguments.within;

import lights.Light;
import lights.LightGroup;

/**
 * How the surfaces of a scene are shaded: the element {@code engine} of its file, and its lights.
 *
 * @param on whether lights and materials act
 * @param facing without illumination: whether surfaces are shaded by their angle to the ray; if not, they show their plain
 *     colour
 * @param lights the lights; none without illumination
 * @param recursionDepth depth of the deepest ray that reflection and refraction make, at least 0
 * @param exposure stops by which the picture is brighter than standard, from −20 to 20
 */
public record Lighting(boolean on, boolean facing, LightGroup lights, int recursionDepth, double exposure) {

  /** No illumination: surfaces are shaded by their angle to the ray. */
  public static final Lighting FACING = new Lighting(false, true, new LightGroup(), 0, 0);

  /** No illumination: surfaces show their plain colour. */
  public static final Lighting PLAIN = new Lighting(false, false, new LightGroup(), 0, 0);

  /**
   * Checks and copies the arguments.
   *
   * @param on whether lights and materials act
   * @param facing whether surfaces are shaded without illumination
   * @param lights the lights
   * @param recursionDepth depth of the deepest ray
   * @param exposure stops of exposure
   * @throws IllegalArgumentException if lights is null, the depth negative, or the exposure outside its range
   */
  public Lighting {
    lights = copy(notNull("lights", lights));
    notNegative("recursionDepth", recursionDepth);
    within("exposure", -20, 20, exposure);
  }

  private static LightGroup copy(final LightGroup lights) {
    return new LightGroup(lights.getLights().toArray(Light[]::new));
  }

  /**
   * The lights.
   *
   * @return a new group of them; empty without illumination
   */
  @Override
  public LightGroup lights() {
    return copy(lights);
  }
}
