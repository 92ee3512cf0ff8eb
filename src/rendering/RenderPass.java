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
   * The object: a colour for each of the scene.
   *
   * <p><img src="doc-files/object.png" width="320" height="213" alt="A colour for each object">
   */
  OBJECT,
  /**
   * What it costs to find the hit, or that there is none: see {@link models.Cost} and {@link ColourScale#ofCost}.
   *
   * <p><img src="doc-files/cost.png" width="320" height="213" alt="The cost of each ray, dark to bright">
   */
  COST,
  /**
   * The light: a colour for each light of the scene, mixed by what it brings; see {@link LightColours}.
   *
   * <p><img src="doc-files/light.png" width="320" height="213" alt="A colour for each light">
   */
  LIGHT;

  /**
   * The name of the view on the command line.
   *
   * @return its name in small letters
   */
  public String option() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * The view of a name of the command line.
   *
   * @param name the name, in small or capital letters
   * @return the view; empty if there is none of this name
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
