package window;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

import javax.swing.SwingUtilities;

import scenes.SceneFile;
import rendering.RenderPass;

/** What is open in a window, and how it is to be rendered. It is rendered anew when the scene or a mesh of it is saved. */
final class Session {

  private final BackgroundRenderer renderer;
  private final SceneWatch watch = new SceneWatch(() -> SwingUtilities.invokeLater(this::render));
  private final int threads;
  private Path file;
  private SceneFile scene;
  private RenderPass view;
  private PictureSize size = PictureSize.OWN;

  /** With nothing open yet, for a number of threads; 0 for one for each core. */
  Session(final BackgroundRenderer.Listener listener, final RenderPass view, final int threads) {
    this.renderer = new BackgroundRenderer(listener);
    this.view = view;
    this.threads = threads > 0 ? threads : Runtime.getRuntime().availableProcessors();
  }

  /** Opens a scene file, and watches it from now on. */
  void open(final Path path) {
    file = path;
    scene = null;
    watch.watch(List.of(path));
    render();
  }

  /** Opens a scene of a program of one's own. */
  void open(final SceneFile known) {
    file = null;
    scene = known;
    watch.watch(List.of());
    render();
  }

  /** Reads the file, if it is one, and renders. */
  void render() {
    if (isOpen()) {
      renderer.render(new BackgroundRenderer.RenderRequest(file, scene, view, size, threads));
    }
  }

  boolean isOpen() {
    return file != null || scene != null;
  }

  /** Watches the meshes of the scene too. */
  void watchMeshes(final SceneFile read) {
    final List<Path> files = new ArrayList<>(read.meshes());
    files.add(file);
    watch.watch(files);
  }

  /** The file that is open; null if there is none. */
  Path file() {
    return file;
  }

  RenderPass view() {
    return view;
  }

  void setView(final RenderPass next) {
    view = next;
    render();
  }

  /** The size of the first picture. */
  void startWithSize(final PictureSize first) {
    size = first;
  }

  PictureSize size() {
    return size;
  }

  void setSize(final PictureSize next) {
    if (!next.equals(size)) {
      size = next;
      render();
    }
  }

  void cancel() {
    renderer.cancel();
  }

  void stop() {
    renderer.stop();
    watch.stop();
  }
}
