package window;

import static arguments.Arguments.notNull;
import static arguments.Arguments.positive;
import static arguments.Arguments.wrongState;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Frame;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;

import javax.swing.JFrame;
import javax.swing.SwingUtilities;

import arguments.Messages;
import models.Group3D;
import rendering.RenderPass;
import scenes.SceneFile;
import upnatray.RenderJob;
import view.Camera;

/**
 * A window that shows a picture while it is rendered and explains its pixels. All methods but {@link #show} must be called
 * on the event dispatch thread.
 */
public final class RenderWindow {

  private final Settings settings;
  private final JFrame frame = new JFrame();
  private final PictureView view = new PictureView(new PixelPointer(this));
  private final ClipboardCopy copying = new ClipboardCopy(text -> status().showText(text));
  private final InspectorPanel inspector = new InspectorPanel(copying);
  private final ProblemTable problems = new ProblemTable();
  private final LegendView legend = new LegendView();
  private final RenderPresenter presenter = new RenderPresenter(this);
  private final PixelInspections inspections = new PixelInspections(this);
  private final Command render = Command.of("render", "F5", this::renderAgain);
  private final Command cancel = Command.of("cancel", "ESCAPE", presenter::cancel);
  private final StatusBar status = new StatusBar(cancel);
  private final CameraControl camera = new CameraControl(this);
  private final Dialogs dialogs = new Dialogs(this);
  private final Session session;
  private final ToolBar toolBar;
  private final MenuBar menus;

  RenderWindow(final Settings settings, final RenderPass pass, final int threads) {
    this.settings = settings;
    this.session = new Session(presenter, pass, threads);
    this.toolBar = new ToolBar(this);
    this.menus = new MenuBar(this);
    view.setCamera(camera);
    inspector.setRayListener(new SelectedRays(this)::show);
    cancel.setEnabled(false);
    render.setEnabled(false);
    layOut();
    view.addPropertyChangeListener("zoom", event -> status.showZoom(view.hasPicture() ? view.magnification() : 0));
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
   * Opens a window for a scene built by a program, such as one that tries out a new shape.
   *
   * @param title title of the window
   * @param objects the objects of the scene
   * @param camera the camera, with its projection
   * @param W width of the picture in pixels, at least 1
   * @param H height of the picture in pixels, at least 1
   * @param background colour of pixels without a hit
   * @throws IllegalArgumentException if an argument is null, or if W or H is not positive
   * @throws IllegalStateException if the camera has no projection, or if no display is available
   */
  public static void show(final String title, final Group3D objects, final Camera camera, final int W, final int H,
      final Color background) {
    final SceneFile scene = new SceneFile(notNull("title", title), positive("W", W), positive("H", H),
        notNull("background", background), true, notNull("camera", camera), notNull("objects", objects), Map.of(), Set.of());
    if (camera.getProjection() == null) {
      throw wrongState("noProjection");
    }
    if (!new WindowViewer().isAvailable()) {
      throw new IllegalStateException(Messages.text("window.show.noDisplay"));
    }
    SwingUtilities.invokeLater(() -> {
      final Settings settings = Settings.ofUser();
      Theme.install(settings.isDark());
      final RenderWindow window = new RenderWindow(settings, RenderPass.COLOUR, 0);
      window.open(scene);
      window.frame.setVisible(true);
    });
  }

  private void layOut() {
    frame.setJMenuBar(menus);
    frame.add(toolBar, BorderLayout.NORTH);
    frame.add(WindowLayout.of(view, legend, problems, inspector), BorderLayout.CENTER);
    frame.add(status, BorderLayout.SOUTH);
    frame.getRootPane().setTransferHandler(new FileDrop(this::open));
    frame.setDefaultCloseOperation(JFrame.DO_NOTHING_ON_CLOSE);
    frame.setTitle("UPNaTRay");
    frame.setName("upnatray");
    frame.setBounds(WindowPlacement.place(settings.bounds(), settings.hasBounds(), WindowPlacement.usableAreas()));
    frame.setExtendedState(settings.isMaximized() ? Frame.MAXIMIZED_BOTH : Frame.NORMAL);
  }

  /** Opens a scene file and watches it. A path that is not a scene file, such as a root folder, is listed as a problem. */
  void open(final Path path) {
    final Path folder = path.toAbsolutePath().getParent(), name = path.getFileName();
    settings.addRecent(path);
    settings.setFolder(folder == null ? path : folder);
    menus.fillRecent();
    prepare((name == null ? path : name).toString());
    session.open(path);
  }

  void open(final SceneFile scene) {
    prepare(scene.name());
    session.open(scene);
  }

  private void prepare(final String name) {
    frame.setTitle(name + " \u2014 UPNaTRay");
    render.setEnabled(true);
    presenter.reset();
    camera.reset();
    unpin();
    status.showPixel(null, 0, 0);
    status.showText(Messages.text("window.status.reading", name));
  }

  void renderAgain() {
    session.render();
  }

  void setPass(final RenderPass next) {
    menus.select(next);
    toolBar.select(next);
    session.setPass(next);
  }

  /** Sets the size of the first picture. */
  void startWithSize(final PictureSize first) {
    session.startWithSize(first);
    toolBar.select(first);
  }

  void setPictureSize(final PictureSize next) {
    session.setSize(next);
  }

  void setSamples(final Samples next) {
    menus.select(next);
    toolBar.select(next);
    session.setSamples(next);
  }

  void unpin() {
    inspections.discard();
    view.unpin();
    inspector.clear();
  }

  void copyPicture() {
    if (view.hasPicture()) {
      final BufferedImage picture = view.picture();
      copying.copy(() -> new PictureClip(picture), Messages.text("window.status.copied"));
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

  void showWireframe() {
    if (job() != null) {
      dialogs.wireframeDialog().show(job());
      if (view.pinned() != null) {
        inspections.inspect(job(), view.pinned());
      }
    }
  }

  void showLights() {
    if (job() != null) {
      dialogs.showLights(job());
    }
  }

  void switchTheme() {
    settings.setDark(!settings.isDark());
    Theme.install(settings.isDark());
    Theme.update();
  }

  /** Closes the window. The program ends with its last window. */
  void close() {
    settings.setMaximized((frame.getExtendedState() & Frame.MAXIMIZED_BOTH) == Frame.MAXIMIZED_BOTH);
    if (!settings.isMaximized()) {
      settings.setBounds(frame.getBounds());
    }
    new Thread(settings::save, "settings").start();
    session.stop();
    presenter.stop();
    camera.stop();
    dialogs.close();
    frame.dispose();
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

  CameraControl camera() {
    return camera;
  }

  LegendView legend() {
    return legend;
  }

  PixelInspections inspections() {
    return inspections;
  }

  Session session() {
    return session;
  }

  boolean isRunning() {
    return presenter.isRunning();
  }

  /** Whether the picture of a job is shown, perhaps refined. */
  boolean shows(final RenderJob other) {
    return presenter.shows(other);
  }

  /** The rendering that is shown; null if none. */
  RenderJob job() {
    return presenter.job();
  }
}
