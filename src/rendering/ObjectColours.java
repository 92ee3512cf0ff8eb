package rendering;

import static arguments.Arguments.notNull;

import java.awt.Color;
import java.util.IdentityHashMap;
import java.util.Map;

import models.Group3D;
import models.Object3D;
import tracer.Hit;
import tracer.Ray;

/** A colour for each object of a scene, whatever its material. Objects within groups have colours of their own. */
public final class ObjectColours implements Shading {

  /** Fraction of the colour circle between one object and the next: neighbours differ, and colours repeat late. */
  private static final float GOLDEN_RATIO = 0.618034f;

  private final Group3D scene;
  private final Map<Object3D, Integer> colours = new IdentityHashMap<>();

  /**
   * The colours of the objects that a scene has now.
   *
   * @param scene the scene
   * @throws IllegalArgumentException if the scene is null
   */
  public ObjectColours(final Group3D scene) {
    this.scene = notNull("scene", scene);
    for (final Object3D object : scene.getMembers()) {
      colours.put(object, color(colours.size()).getRGB());
    }
  }

  static Color color(final int number) {
    return Color.getHSBColor(number * GOLDEN_RATIO, 0.45f + 0.1f * (number % 5), 0.95f - 0.12f * (number % 4));
  }

  @Override
  public int argb(final Ray ray, final Hit hit) {
    return colours.get(scene.objectHitBy(ray));
  }
}
