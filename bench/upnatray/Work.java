package upnatray;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.ThreadFactory;

import diagnostics.Problem;
import models.Group3D;
import rendering.RenderSettings;
import scenes.ReadResult;
import scenes.SceneFile;
import scenes.SceneReader;
import view.Camera;

/** What {@link RenderWork} measures: a {@code .work} file, or a scene file with whatever lights it has. */
interface Work {

  int width();

  int height();

  Color background();

  /** Builds what remains to be built, so that this can be timed apart from reading. */
  void build();

  /** Renders the picture; helper threads are made by the factory. */
  void render(Image image, RenderSettings settings, ThreadFactory factory);

  /** Reads a work of either kind. */
  static Work read(final Path file) throws IOException {
    return file.toString().endsWith(".xml") ? new OfSceneFile(scene(file)) : new OfWorkFile(WorkFile.read(file));
  }

  private static SceneFile scene(final Path file) throws IOException {
    final ReadResult result = SceneReader.read(file);
    return result.scene().orElseThrow(() -> new IOException(result.problems().stream()
        .filter(problem -> problem.severity() == Problem.Severity.ERROR).findFirst().orElseThrow().toString()));
  }

  /** Flat colours. */
  final class OfWorkFile implements Work {

    private final WorkFile work;
    private final Camera camera;
    private Group3D scene;

    OfWorkFile(final WorkFile work) {
      this.work = work;
      this.camera = work.camera();
    }

    @Override
    public int width() {
      return work.width();
    }

    @Override
    public int height() {
      return work.height();
    }

    @Override
    public Color background() {
      return work.background();
    }

    @Override
    public void build() {
      scene = work.scene();
    }

    @Override
    public void render(final Image image, final RenderSettings settings, final ThreadFactory factory) {
      image.synthesis(scene, camera, settings, factory);
    }
  }

  /** A scene file, whose meshes are built while it is read. */
  record OfSceneFile(SceneFile scene) implements Work {

    @Override
    public int width() {
      return scene.width();
    }

    @Override
    public int height() {
      return scene.height();
    }

    @Override
    public Color background() {
      return scene.background();
    }

    @Override
    public void build() {
      scene.objects().getBoundingBox();
    }

    @Override
    public void render(final Image image, final RenderSettings settings, final ThreadFactory factory) {
      image.synthesis(scene.objects(), scene.camera(), settings.withShading(RenderJob.shading(scene)), factory);
    }
  }
}
