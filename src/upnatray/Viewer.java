package upnatray;

import java.nio.file.Path;
import java.util.Optional;
import java.util.ServiceLoader;

import rendering.RenderPass;

/**
 * Shows pictures of scenes. Found as a service, so that the command line does not depend on the window, and loads it only
 * where it is wanted.
 */
public interface Viewer {

  /**
   * What to show.
   *
   * @param scene the scene file
   * @param view what to show of it
   * @param width width in pixels; 0 for the scene's own, or to preserve the aspect ratio if the height is given
   * @param height height in pixels; 0 as for the width
   * @param threads number of threads; 0 for one for each core
   */
  record Request(Path scene, RenderPass view, int width, int height, int threads) {
  }

  /**
   * Whether there is a display on which it can show anything.
   *
   * @return true if there is
   */
  boolean isAvailable();

  /**
   * Shows a scene and returns at once; the program goes on until the user ends it.
   *
   * @param request what to show
   */
  void show(Request request);

  /**
   * The viewer of this program.
   *
   * @return the viewer; empty if none, or no display for it
   */
  static Optional<Viewer> available() {
    return ServiceLoader.load(Viewer.class).findFirst().filter(Viewer::isAvailable);
  }
}
