package rendering;

import static arguments.Arguments.notNull;

import java.awt.Color;

import lights.LightGroup;
import models.Group3D;
import view.Camera;

/**
 * The contents of a picture.
 *
 * @param objects the objects
 * @param camera the camera, which has a projection
 * @param lights the lights; without any, objects have plain colours
 * @param background colour of the pixels whose ray hits nothing
 */
public record Scene(Group3D objects, Camera camera, LightGroup lights, Color background) {

  /**
   * Checks the parts.
   *
   * @param objects the objects
   * @param camera the camera, which has a projection
   * @param lights the lights; without any, objects have plain colours
   * @param background colour of the pixels whose ray hits nothing
   * @throws IllegalArgumentException if a part is null
   */
  public Scene {
    notNull("objects", objects);
    notNull("camera", camera);
    notNull("lights", lights);
    notNull("background", background);
  }

  /**
   * The illumination of this scene.
   *
   * @param recursionDepth greatest depth of a ray, at least 0
   * @return the illumination, at exposure 0
   * @throws IllegalArgumentException if the depth is negative
   */
  public Illumination illumination(final int recursionDepth) {
    return new Illumination(objects, lights, recursionDepth, background);
  }
}
