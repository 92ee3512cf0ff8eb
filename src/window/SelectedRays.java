package window;

import java.util.List;

import javax.swing.SwingUtilities;

import inspection.Wireframe;
import upnatray.RenderJob;

/** Shows the rays selected in the inspector, in the picture and in the wireframe view. */
final class SelectedRays {

  private final RenderWindow window;
  private final LatestOnlyExecutor projecting = new LatestOnlyExecutor("rays");

  SelectedRays(final RenderWindow window) {
    this.window = window;
  }

  void show(final List<Wireframe.Line> rays) {
    window.dialogs().wireframe().setSelected(rays);
    final RenderJob shown = window.job();
    projecting.execute(() -> {
      final RayOverlay overlay = shown == null || rays.isEmpty() ? RayOverlay.NONE
          : RayOverlay.of(rays, shown.scene(), shown.image().getWidth(), shown.image().getHeight());
      SwingUtilities.invokeLater(() -> window.view().setRays(shown != null && window.shows(shown) ? overlay
          : RayOverlay.NONE));
    });
  }
}
