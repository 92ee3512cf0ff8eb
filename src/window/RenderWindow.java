package window;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Frame;
import java.awt.Point;
import java.awt.Toolkit;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;

import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.swing.Timer;

import inspection.Inspection;
import inspection.Inspector;
import models.Group3D;
import scenes.Problem;
import scenes.Reading;
import scenes.Scene;
import upnatray.RenderJob;
import upnatray.View;
import view.Camera;

/**
 * A window that shows a picture while it is rendered, and what its pixels are made of. All its methods but {@link #show} are
 * called by the event thread.
 */
public final class RenderWindow {

  /** Between two looks at what has been rendered: fast enough to look alive, and cheap. */
  private static final int MILLISECONDS_BETWEEN = 80;

  private final Settings settings;
  private final JFrame frame = new JFrame();
  private final PictureView view = new PictureView(new Pointing());
  private final InspectorPanel inspector = new InspectorPanel();
  private final ProblemTable problems = new ProblemTable();
  private final LegendView legend = new LegendView();
  private final Command render = Command.of("render", "F5", this::renderAgain);
  private final Command cancel;
  private final StatusBar status;
  private final Renderer renderer = new Renderer(new Following());
  private final SceneWatch watch = new SceneWatch(() -> SwingUtilities.invokeLater(this::renderAgain));
  private final Timer clock = new Timer(MILLISECONDS_BETWEEN, event -> showProgress());
  private final Dialogs dialogs;
  private final ToolBar toolBar;
  private final MenuBar menus;
  private Path file;
  private Scene scene;
  private View what;
  private PictureSize size = PictureSize.OWN;
  private final int threads;
  private RenderJob job;
  private Canvas canvas;
  private boolean running;

  RenderWindow(final Settings settings, final View what, final int threads) {
    this.settings = settings;
    this.what = what;
    this.threads = threads > 0 ? threads : Runtime.getRuntime().availableProcessors();
    this.cancel = Command.of("cancel", "ESCAPE", renderer::cancel);
    this.status = new StatusBar(cancel);
    this.dialogs = new Dialogs(this);
    this.toolBar = new ToolBar(this);
    this.menus = new MenuBar(this);
    cancel.setEnabled(false);
    render.setEnabled(false);
    layOut();
    view.addPropertyChangeListener("zoom", event -> status.showZoom(view.magnification()));
    frame.addWindowListener(new WindowAdapter() {
      @Override
      public void windowClosing(final WindowEvent event) {
        close();
      }

      @Override
      public void windowOpened(final WindowEvent event) {
        view.requestFocusInWindow();
      }
    });
  }

  /**
   * Opens a window for a scene of a program of one's own, such as one that tries out a new shape.
   *
   * @param title title of the window
   * @param objects what there is to see
   * @param camera the camera, with its projection
   * @param W width of the picture in pixels, at least 1
   * @param H height of the picture in pixels, at least 1
   * @param background colour of pixels that show nothing
   */
  public static void show(final String title, final Group3D objects, final Camera camera, final int W, final int H,
      final Color background) {
    SwingUtilities.invokeLater(() -> {
      final Settings settings = Settings.ofUser();
      Theme.install(settings.isDark());
      final RenderWindow window = new RenderWindow(settings, View.COLOUR, 0);
      window.open(new Scene(title, W, H, background, true, camera, objects, Map.of(), Set.of()));
      window.frame.setVisible(true);
    });
  }

  private void layOut() {
    frame.setJMenuBar(menus);
    frame.add(toolBar, BorderLayout.NORTH);
    frame.add(Arrangement.of(view, legend, problems, inspector), BorderLayout.CENTER);
    frame.add(status, BorderLayout.SOUTH);
    frame.getRootPane().setTransferHandler(new FileDrop(this::open));
    frame.setDefaultCloseOperation(JFrame.DO_NOTHING_ON_CLOSE);
    frame.setTitle("UPNaTRay");
    frame.setName("upnatray");
    Arrangement.place(frame, settings.bounds());
  }

  /** Opens a scene file, and watches it from now on. */
  void open(final Path path) {
    file = path;
    scene = null;
    job = null;
    canvas = null;
    view.unpin();
    inspector.clear();
    settings.addRecent(path);
    settings.setFolder(path.toAbsolutePath().getParent());
    menus.fillRecent();
    watch.watch(List.of(path));
    frame.setTitle(path.getFileName() + " \u2014 UPNaTRay");
    renderAgain();
  }

  void open(final Scene known) {
    file = null;
    scene = known;
    frame.setTitle(known.name() + " \u2014 UPNaTRay");
    renderAgain();
  }

  void renderAgain() {
    if (file != null || scene != null) {
      render.setEnabled(true);
      renderer.render(new Renderer.Wish(file, file == null ? scene : null, what, size, threads));
    }
  }

  void setWhat(final View next) {
    what = next;
    menus.select(next);
    toolBar.select(next);
    renderAgain();
  }

  /** The size of the first picture. */
  void startWithSize(final PictureSize first) {
    size = first;
    toolBar.select(first);
  }

  void setPictureSize(final PictureSize next) {
    if (!next.equals(size)) {
      size = next;
      renderAgain();
    }
  }

  /** Shows the pixels that are new. */
  private void showProgress() {
    if (canvas != null) {
      view.repaintPixels(canvas.takeChanged());
      status.showProgress(job);
      legend.setScale(job.scale().orElse(null));
    }
  }

  private void inspect(final Point pixel) {
    if (job != null && pixel.x < job.image().getWidth() && pixel.y < job.image().getHeight()) {
      final int W = job.image().getWidth(), H = job.image().getHeight();
      final Inspection inspection = new Inspector(job.scene(), W, H).inspect(pixel.x, H - 1 - pixel.y);
      inspector.show(inspection);
      dialogs.showRay(job.scene(), W, H, inspection);
    }
  }

  void unpin() {
    view.unpin();
    inspector.clear();
  }

  void copyPicture() {
    if (view.hasPicture()) {
      Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new PictureClip(view.picture()), null);
      status.showText(Messages.text("status.copied"));
    }
  }

  void chooseScene() {
    dialogs.chooseScene();
  }

  void choosePicture() {
    dialogs.choosePicture();
  }

  void chooseReference() {
    dialogs.chooseReference();
  }

  void showOutside() {
    if (job != null) {
      dialogs.showOutside(job.scene(), job.image().getWidth(), job.image().getHeight());
      if (view.pinned() != null) {
        inspect(view.pinned());
      }
    }
  }

  void switchTheme() {
    settings.setDark(!settings.isDark());
    Theme.install(settings.isDark());
    Theme.update();
  }

  /** Ends it all; with the last window the program ends too. */
  void close() {
    if ((frame.getExtendedState() & Frame.MAXIMIZED_BOTH) == 0) {
      settings.setBounds(frame.getBounds());
    }
    settings.save();
    renderer.stop();
    watch.stop();
    clock.stop();
    dialogs.close();
    frame.dispose();
  }

  /** What becomes of a rendering. */
  private final class Following implements Renderer.Listener {

    @Override
    public void read(final Reading reading) {
      problems.show(reading.problems());
      if (reading.scene().isPresent()) {
        scene = reading.scene().get();
        final List<Path> files = new ArrayList<>(scene.meshes());
        files.add(file);
        watch.watch(files);
      } else {
        status.showText(Messages.text("status.errors"));
      }
    }

    @Override
    public void started(final RenderJob next, final Canvas itsCanvas) {
      job = next;
      canvas = itsCanvas;
      running = true;
      view.setPicture(itsCanvas.picture());
      status.showZoom(view.magnification());
      status.setRunning(true);
      cancel.setEnabled(true);
      clock.start();
      if (file == null) {
        problems.show(List.of());
      }
      if (view.pinned() == null) {
        inspector.clear();
      }
    }

    @Override
    public void finished(final RenderJob ended, final boolean completed) {
      clock.stop();
      showProgress();
      running = false;
      cancel.setEnabled(false);
      status.setRunning(false);
      status.showFinished(ended, completed);
      if (view.pinned() != null) {
        view.pin(view.pinned());
      }
      dialogs.renderingFinished();
    }

    @Override
    public void failed(final Throwable failure) {
      clock.stop();
      running = false;
      cancel.setEnabled(false);
      status.setRunning(false);
      status.showText(Messages.text("status.failed"));
      problems.show(List.of(Failure.problem(failure)));
    }
  }

  /** What the user points at. */
  private final class Pointing implements PictureView.PixelListener {

    @Override
    public void hovered(final Point pixel) {
      status.showPixel(pixel, view.picture().getHeight(), pixel == null ? 0 : view.picture().getRGB(pixel.x, pixel.y));
    }

    @Override
    public void pinned(final Point pixel) {
      hovered(pixel);
      inspect(pixel);
    }
  }

  Settings settings() {
    return settings;
  }

  JFrame frame() {
    return frame;
  }

  PictureView view() {
    return view;
  }

  InspectorPanel inspector() {
    return inspector;
  }

  ProblemTable problems() {
    return problems;
  }

  StatusBar status() {
    return status;
  }

  Dialogs dialogs() {
    return dialogs;
  }

  Command renderCommand() {
    return render;
  }

  Command cancelCommand() {
    return cancel;
  }

  View what() {
    return what;
  }

  Path file() {
    return file;
  }

  boolean isRunning() {
    return running;
  }

  RenderJob job() {
    return job;
  }
}
