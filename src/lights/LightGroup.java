package lights;

import static arguments.Arguments.notNull;

import java.util.ArrayList;
import java.util.List;

/**
 * The lights of a scene, in the order in which they were added. Mutable: add all lights before rendering, from one
 * thread.
 */
public final class LightGroup {

  private final List<Light> members = new ArrayList<>();

  /**
   * A group of the given lights.
   *
   * @param lights the lights; more can be added later
   * @throws IllegalArgumentException if the array or a light is null
   */
  public LightGroup(final Light... lights) {
    for (final Light light : notNull("lights", lights)) {
      addLight(light);
    }
  }

  /**
   * Adds a light.
   *
   * @param light the light
   * @throws IllegalArgumentException if it is null
   */
  public void addLight(final Light light) {
    members.add(notNull("light", light));
  }

  /**
   * The lights.
   *
   * @return an immutable copy of the list
   */
  public List<Light> getLights() {
    return List.copyOf(members);
  }

  @Override
  public String toString() {
    return "LightGroup" + members;
  }
}
