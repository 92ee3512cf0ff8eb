package window;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

import javax.swing.SwingUtilities;

import scenes.SceneFile;
import rendering.RenderPass;
import view.Camera;

/** The open scene and how to render it. It is rendered again whenever the scene file or one of its meshes changes. */
final class Session {

  private final BackgroundRenderer renderer;
  private final SceneWatch watch = new SceneWatch(() -> SwingUtilities.invokeLater(this::render));
  private Path file;
  private List<Path> inputs = List.of();
  private SceneFile scene;
  private SceneFile lastRead;
  private CameraChange camera;
  private PictureOptions options;

  /** A session without a scene. A thread count of 0 means one thread per core. */
  Session(final BackgroundRenderer.Listener listener, final RenderPass pass, final int threads) {
    this.renderer = new BackgroundRenderer(listener);
    this.options = new PictureOptions(pass, PictureSize.OWN, Samples.ONE,
        threads > 0 ? threads : Runtime.getRuntime().availableProcessors());
  }

  /** Opens a scene file and watches it. */
  void open(final Path path) {
    file = path;
    scene = null;
    lastRead = null;
    camera = null;
    inputs = List.of(path);
    watch.watch(inputs);
    render();
  }

  /** Opens a scene built by a program. */
  void open(final SceneFile given) {
    file = null;
    scene = given;
    camera = null;
    inputs = List.of();
    watch.watch(inputs);
    render();
  }

  /** Renders the scene, after reading its file again if it has one. */
  void render() {
    if (isOpen()) {
      renderer.render(new BackgroundRenderer.RenderRequest(file, scene, options, camera, null));
    }
  }

  /**
   * Renders with another camera in place of that of the scene, which is not read again.
   *
   * @param next the camera; null for that of the scene
   * @param preview a coarse picture of it, or null
   */
  void setCamera(final Camera next, final BufferedImage preview) {
    final SceneFile known = scene == null ? lastRead : scene;
    if (known != null) {
      camera = next == null ? null : new CameraChange(known.camera(), next);
      renderer.render(new BackgroundRenderer.RenderRequest(file, known, options, camera, preview));
    }
  }

  /** Takes note of a scene that was read. A camera that was moved is dropped if the file has another one now. */
  boolean hasRead(final SceneFile read) {
    lastRead = read;
    final boolean isDropped = camera != null && !camera.appliesTo(read);
    if (isDropped) {
      camera = null;
    }
    return isDropped;
  }

  boolean isOpen() {
    return file != null || scene != null;
  }

  /** Watches the mesh files of the scene too. */
  void watchMeshes(final SceneFile read) {
    inputs = new ArrayList<>(read.meshes());
    inputs.add(file);
    watch.watch(inputs);
  }

  /** The files of the scene, which must not be overwritten. */
  List<Path> inputs() {
    return List.copyOf(inputs);
  }

  /** The file of the scene; null if it has none. */
  Path file() {
    return file;
  }

  RenderPass pass() {
    return options.pass();
  }

  void setPass(final RenderPass next) {
    set(options.with(next));
  }

  /** Sets the size of the first picture. */
  void startWithSize(final PictureSize first) {
    options = options.with(first);
  }

  PictureSize size() {
    return options.size();
  }

  void setSize(final PictureSize next) {
    set(options.with(next));
  }

  Samples samples() {
    return options.samples();
  }

  void setSamples(final Samples next) {
    set(options.with(next));
  }

  private void set(final PictureOptions next) {
    if (!next.equals(options)) {
      options = next;
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
