package rendering;

import static arguments.Arguments.notNull;

import java.util.Locale;
import java.util.Optional;

/** What a picture shows of the hit of each pixel. */
public enum RenderPass {

  /**
   * The colour: the picture itself.
   *
   * <p><img src="doc-files/colour.png" width="320" height="213" alt="A still life by lamplight">
   */
  COLOUR,
  /**
   * The normal to the surface: red, green and blue are its x, y and z, from −1 to 1.
   *
   * <p><img src="doc-files/normals.png" width="320" height="213" alt="Its normals as colours">
   */
  NORMALS,
  /**
   * The distance t from the start of the ray, near ones bright: see {@link ColourScale#ofDepth}.
   *
   * <p><img src="doc-files/depth.png" width="320" height="213" alt="Its distances in grey">
   */
  DEPTH,
  /**
   * The object: a distinct colour for each.
   *
   * <p><img src="doc-files/object.png" width="320" height="213" alt="A colour for each object">
   */
  OBJECT,
  /**
   * The cost of the ray: see {@link models.Cost} and {@link ColourScale#ofCost}.
   *
   * <p><img src="doc-files/cost.png" width="320" height="213" alt="The cost of each ray, dark to bright">
   */
  COST,
  /**
   * The light: a colour for each light of the scene, scaled by its contribution; see {@link LightColours}.
   *
   * <p><img src="doc-files/light.png" width="320" height="213" alt="A colour for each light">
   */
  LIGHT;

  /**
   * The name of the pass on the command line.
   *
   * @return its name in lower case
   */
  public String option() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * Whether the pass shows numbers on a scale, which have no mean, instead of colours.
   *
   * @return true for {@link #DEPTH} and {@link #COST}
   */
  public boolean showsNumbers() {
    return this == DEPTH || this == COST;
  }

  /**
   * The pass of a name of the command line.
   *
   * @param name the name, in any case
   * @return the pass; empty if none of this name
   * @throws IllegalArgumentException if the name is null
   */
  public static Optional<RenderPass> named(final String name) {
    notNull("name", name);
    for (final RenderPass view : values()) {
      if (view.option().equals(name.toLowerCase(Locale.ROOT))) {
        return Optional.of(view);
      }
    }
    return Optional.empty();
  }
}
