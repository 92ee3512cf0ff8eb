package window;

import scenes.CameraText;
import scenes.SceneFile;
import view.Camera;

/**
 * A camera that replaces the one of a scene as long as that is still the one it was derived from.
 *
 * @param from the camera of the scene
 * @param to the camera to be used
 */
record CameraChange(Camera from, Camera to) {

  /** Whether the scene still has the camera that this change starts from. */
  boolean appliesTo(final SceneFile scene) {
    return CameraText.of(scene.camera()).equals(CameraText.of(from));
  }

  SceneFile applyTo(final SceneFile scene) {
    return appliesTo(scene) ? scene.withCamera(to) : scene;
  }
}
