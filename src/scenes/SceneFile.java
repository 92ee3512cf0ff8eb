package scenes;

import static arguments.Arguments.notNull;
import static arguments.Arguments.positive;

import java.awt.Color;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;

import models.Group3D;
import models.Object3D;
import view.Camera;

/**
 * What a scene file describes.
 *
 * @param name its free title, perhaps empty
 * @param width width of its image in pixels, at least 1
 * @param height height of its image in pixels, at least 1
 * @param background colour of pixels that show nothing
 * @param facing whether surfaces are shaded by their angle to the ray; if not, they show their plain colour
 * @param camera the camera, with its projection
 * @param objects what there is to see
 * @param names the id of the model that each of the objects shows; objects are told apart by identity
 * @param meshes the files of its meshes
 */
public record SceneFile(String name, int width, int height, Color background, boolean facing, Camera camera,
    Group3D objects, Map<Object3D, String> names, Set<Path> meshes) {

  /**
   * Checks what is given.
   *
   * @param name its free title
   * @param width width of its image
   * @param height height of its image
   * @param background colour of pixels that show nothing
   * @param facing whether surfaces are shaded
   * @param camera the camera
   * @param objects what there is to see
   * @param names the ids of the models
   * @param meshes the files of its meshes
   * @throws IllegalArgumentException if an argument is null, or if there is no pixel
   */
  public SceneFile {
    notNull("name", name);
    positive("width", width);
    positive("height", height);
    notNull("background", background);
    notNull("camera", camera);
    notNull("objects", objects);
    notNull("names", names);
    notNull("meshes", meshes);
  }
}
