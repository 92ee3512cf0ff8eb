package rendering;

import static arguments.Arguments.notNull;

import java.util.Locale;
import java.util.Optional;

/** What a picture shows of the hit of each pixel. */
public enum RenderPass {

  /** The colour: the picture itself. */
  COLOUR,
  /** The normal to the surface: red, green and blue are its x, y and z, from −1 to 1. */
  NORMALS,
  /** The distance t from the start of the ray, near ones bright: see {@link ColourScale#ofDepth}. */
  DEPTH,
  /** The object: a colour for each of the scene. */
  OBJECT,
  /** What it costs to find the hit, or that there is none: see {@link models.Cost} and {@link ColourScale#ofCost}. */
  COST,
  /** The light: a colour for each light of the scene, mixed by what it brings; see {@link LightColours}. */
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
