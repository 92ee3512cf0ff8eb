package scenes;

import static arguments.Arguments.notNull;
import static arguments.Arguments.positive;

import java.awt.Color;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;

import lights.LightGroup;
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
 * @param lighting how surfaces get their shade
 * @param camera the camera, with its projection
 * @param objects the objects
 * @param names the id of the model that each of the objects shows; objects are compared by identity
 * @param meshes the files that it is made of: meshes, their materials, and textures
 */
public record SceneFile(String name, int width, int height, Color background, Lighting lighting, Camera camera,
    Group3D objects, Map<Object3D, String> names, Set<Path> meshes) {

  /**
   * Checks the arguments.
   *
   * @param name its free title
   * @param width width of its image
   * @param height height of its image
   * @param background colour of pixels that show nothing
   * @param lighting how surfaces get their shade
   * @param camera the camera
   * @param objects the objects
   * @param names the ids of the models
   * @param meshes the files that it is made of: meshes, their materials, and textures
   * @throws IllegalArgumentException if an argument is null, or if there is no pixel
   */
  public SceneFile {
    notNull("name", name);
    positive("width", width);
    positive("height", height);
    notNull("background", background);
    notNull("lighting", lighting);
    notNull("camera", camera);
    notNull("objects", objects);
    notNull("names", names);
    notNull("meshes", meshes);
  }

  /**
   * A scene without illumination.
   *
   * @param name its free title
   * @param width width of its image
   * @param height height of its image
   * @param background colour of pixels that show nothing
   * @param facing whether surfaces are shaded by their angle to the ray; if not, they show their plain colour
   * @param camera the camera
   * @param objects the objects
   * @param names the ids of the models
   * @param meshes the files that it is made of: meshes, their materials, and textures
   * @throws IllegalArgumentException if an argument is null, or if there is no pixel
   */
  public SceneFile(final String name, final int width, final int height, final Color background, final boolean facing,
      final Camera camera, final Group3D objects, final Map<Object3D, String> names, final Set<Path> meshes) {
    this(name, width, height, background, facing ? Lighting.FACING : Lighting.PLAIN, camera, objects, names, meshes);
  }

  /**
   * The same scene seen by another camera.
   *
   * @param other the camera, with its projection
   * @return the new scene, of the same objects
   * @throws IllegalArgumentException if the camera is null
   */
  public SceneFile withCamera(final Camera other) {
    return new SceneFile(name, width, height, background, lighting, other, objects, names, meshes);
  }

  /**
   * Whether lights and materials act.
   *
   * @return true for a scene with illumination
   */
  public boolean isLit() {
    return lighting.on();
  }

  /**
   * Whether surfaces are shaded by their angle to the ray where there is no illumination.
   *
   * @return false if they show their plain colour
   */
  public boolean facing() {
    return lighting.facing();
  }

  /**
   * The lights.
   *
   * @return a copy; empty without illumination
   */
  public LightGroup lights() {
    return lighting.lights();
  }

  /**
   * Depth of the deepest ray that reflection and refraction make; the rays of the camera have depth 0.
   *
   * @return at least 0
   */
  public int recursionDepth() {
    return lighting.recursionDepth();
  }

  /**
   * Stops by which the picture is brighter than standard.
   *
   * @return from −20 to 20
   */
  public double exposure() {
    return lighting.exposure();
  }
}
