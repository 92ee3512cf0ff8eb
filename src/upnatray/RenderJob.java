package upnatray;

import static arguments.Arguments.notNull;
import static arguments.Arguments.positive;
import static arguments.Arguments.wrongState;

import java.awt.Color;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;

import rendering.ColourScale;
import rendering.Illumination;
import rendering.LightColours;
import rendering.NumberPass;
import rendering.ObjectColours;
import rendering.Progress;
import rendering.RenderPass;
import rendering.RenderSettings;
import rendering.Shading;
import rendering.Supersampling;
import scenes.SceneFile;

/**
 * The rendering of one picture of a scene, which can be watched and cancelled from any thread. It is run once, by the thread
 * that calls {@link #run}; the command line and the window both render by it.
 */
public final class RenderJob {

  private static final Color NOTHING = new Color(0, 0, 0, 0);

  private final SceneFile scene;
  private final RenderPass view;
  private final Resolution resolution;
  private final int threads;
  /** What the picture shows of each hit. */
  private final Shading shading;
  private final Image image;
  /** The numbers of a pass of numbers; null for other passes. */
  private final NumberPass numbers;
  private final AtomicLong done = new AtomicLong();
  private volatile boolean cancelled;
  private volatile long begin;
  private volatile long end;
  private double least = Double.POSITIVE_INFINITY;
  private double greatest;

  /**
   * A picture to be rendered.
   *
   * @param scene the scene, which must not change meanwhile
   * @param view what the picture is to show
   * @param W its width in pixels, at least 1
   * @param H its height in pixels, at least 1
   * @param threads number of threads, at least 1
   * @throws IllegalArgumentException if an argument is null or less than 1, or if the picture is too large
   */
  public RenderJob(final SceneFile scene, final RenderPass view, final int W, final int H, final int threads) {
    this(notNull("scene", scene), notNull("view", view), shading(scene, view), Resolution.of(W, H), threads);
  }

  private RenderJob(final SceneFile scene, final RenderPass view, final Shading shading, final Resolution resolution,
      final int threads) {
    this.scene = scene;
    this.view = view;
    this.shading = shading;
    this.threads = positive("threads", threads);
    this.resolution = resolution;
    final int W = resolution.W(), rows = resolution.rows();
    this.image = new Image(W, rows, view == RenderPass.COLOUR ? scene.background() : NOTHING);
    this.numbers = view == RenderPass.DEPTH ? NumberPass.ofDepth(W * rows)
        : view == RenderPass.COST ? NumberPass.ofCost(W * rows, scene.objects()) : null;
  }

  /**
   * Renders the picture.
   *
   * @param watcher is called for each tile once it can be seen, and may end the rendering
   * @return whether all of it was rendered; false if it was cancelled
   * @throws IllegalArgumentException if the watcher is null
   */
  public boolean run(final Progress watcher) {
    notNull("watcher", watcher);
    begin = System.nanoTime();
    final Progress progress = (x, y, width, height) -> {
      if (numbers != null) {
        paint(x, y, width, height);
      }
      done.addAndGet((long) width * height);
      return watcher.tileDone(x, y, width, height) && !cancelled;
    };
    try {
      final RenderSettings settings = new RenderSettings(threads, shading, progress);
      final boolean completed = numbers == null ? image.synthesis(scene.objects(), scene.camera(), resolution, settings)
          : settings.render(scene.objects(), resolution.rays(scene.camera()), numbers, Thread::new);
      scale().ifPresent(this::recolour);
      return completed;
    } finally {
      end = System.nanoTime();
    }
  }

  private static Shading shading(final SceneFile scene, final RenderPass view) {
    return switch (view) {
      case COLOUR -> shading(scene);
      case NORMALS -> (ray, hit) -> 0xff << 24 | channel(hit.normalX()) << 16 | channel(hit.normalY()) << 8
          | channel(hit.normalZ());
      case OBJECT -> new ObjectColours(scene.objects());
      case DEPTH, COST -> Shading.PLAIN;
      case LIGHT -> scene.isLit() ? new LightColours(illumination(scene)) : (ray, hit) -> Color.BLACK.getRGB();
    };
  }

  /**
   * The picture of one light of a lit scene: what it contributes to each pixel. In linear light these pictures add up to
   * that of the scene, except for the background and its reflections.
   *
   * @param scene the scene, which must not change meanwhile
   * @param light number of the light, from 0
   * @param W width in pixels, at least 1
   * @param H height in pixels, at least 1
   * @param threads number of threads, at least 1
   * @return the job
   * @throws IllegalArgumentException if the scene is null, if it has no such light, if a number is less than 1, or if the
   *     picture is too large
   */
  public static RenderJob ofLight(final SceneFile scene, final int light, final int W, final int H, final int threads) {
    return ofLight(scene, light, Resolution.of(W, H), threads);
  }

  static RenderJob ofLight(final SceneFile scene, final int light, final Resolution resolution, final int threads) {
    return new RenderJob(notNull("scene", scene), RenderPass.LIGHT, illumination(scene).ofLight(light), resolution, threads);
  }

  /**
   * The same picture with several rays for each pixel, in a regular grid: a pixel is their mean in linear light.
   *
   * @param samples K, 1 … {@value Supersampling#MOST}, for K × K rays
   * @param atEdges whether only pixels that an edge may cross get them, and the others one: see
   *     {@link rendering.AdaptiveSampling}
   * @return a job of its own
   * @throws IllegalArgumentException if K is out of range, or if the picture is too large
   * @throws IllegalStateException if the view shows numbers, which have no mean
   */
  public RenderJob refined(final int samples, final boolean atEdges) {
    if (numbers != null) {
      throw wrongState("noMean", view.option());
    }
    return of(scene, view, new Resolution(resolution.W(), resolution.H(), samples, atEdges, resolution.top(),
        resolution.rows()), threads);
  }

  /** A picture with several rays for each pixel, or a band of one. */
  static RenderJob of(final SceneFile scene, final RenderPass view, final Resolution resolution, final int threads) {
    return new RenderJob(scene, view, shading(scene, view), resolution, threads);
  }

  private static Illumination illumination(final SceneFile scene) {
    return new Illumination(scene.objects(), scene.lights(), scene.recursionDepth(), scene.background())
        .withExposure(scene.exposure());
  }

  /**
   * The shading of a scene's colours.
   *
   * @param scene the scene
   * @return its shading
   * @throws IllegalArgumentException if the scene is null
   */
  public static Shading shading(final SceneFile scene) {
    if (notNull("scene", scene).isLit()) {
      return illumination(scene);
    }
    return scene.facing() ? Shading.FACING : Shading.PLAIN;
  }

  private static int channel(final double component) {
    return (int) (127.5 * (1 + component) + 0.5);
  }

  /** Converts the numbers of a part of the picture to colours, on the scale of those known so far. */
  private void paint(final int x, final int y, final int width, final int height) {
    final ColourScale scale = widened(x, y, width, height);
    for (int row = y; row < y + height; row++) {
      for (int column = x; column < x + width; column++) {
        final double number = numbers.at(row * image.getWidth() + column);
        image.setRGB(column, row, Double.isNaN(number) ? 0 : scale.argb(number));
      }
    }
  }

  /**
   * Converts all numbers on the final scale; pixels without a number, such as those that were not rendered, stay as they
   * are.
   */
  private void recolour(final ColourScale scale) {
    final int W = image.getWidth();
    for (int i = 0; i < W * image.getHeight(); i++) {
      final double number = numbers.at(i);
      if (!Double.isNaN(number)) {
        image.setRGB(i % W, i / W, scale.argb(number));
      }
    }
  }

  private synchronized ColourScale widened(final int x, final int y, final int width, final int height) {
    for (int row = y; row < y + height; row++) {
      for (int column = x; column < x + width; column++) {
        final double number = numbers.at(row * image.getWidth() + column);
        if (!Double.isNaN(number)) {
          least = Math.min(least, number);
          greatest = Math.max(greatest, number);
        }
      }
    }
    return currentScale();
  }

  private synchronized ColourScale currentScale() {
    return view == RenderPass.COST ? ColourScale.ofCost(greatest) : ColourScale.ofDepth(least, greatest);
  }

  /** Ends the rendering after the tiles that are being computed. May be called at any time, before the run too. */
  public void cancel() {
    cancelled = true;
  }

  /**
   * The picture, which fills while the job runs.
   *
   * @return the image, always the same
   */
  public Image image() {
    return image;
  }

  /**
   * What the picture shows.
   *
   * @return the view
   */
  public RenderPass view() {
    return view;
  }

  /**
   * How many rays make a pixel.
   *
   * @return K, for K × K rays
   */
  public int samples() {
    return resolution.samples();
  }

  /**
   * Whether only pixels that an edge may cross get several rays.
   *
   * @return false if all get the same number
   */
  public boolean isAtEdges() {
    return resolution.adaptive();
  }

  /**
   * The scene.
   *
   * @return the scene
   */
  public SceneFile scene() {
    return scene;
  }

  /**
   * The scale of a view of numbers, as far as it is known.
   *
   * @return the scale; empty for the other views, and if there is no number
   */
  public synchronized Optional<ColourScale> scale() {
    if (numbers == null || least > greatest) {
      return Optional.empty();
    }
    return Optional.of(currentScale());
  }

  /**
   * The completed fraction.
   *
   * @return 0 … 1
   */
  public double share() {
    return done.get() / ((double) image.getWidth() * image.getHeight());
  }

  /**
   * Time since the start of the run, or its total time once it has ended.
   *
   * @return seconds; 0 before it begins
   */
  public double seconds() {
    final long until = end == 0 ? System.nanoTime() : end;
    return begin == 0 ? 0 : (until - begin) * 1e-9;
  }

  /**
   * Speed so far, in rays of the camera.
   *
   * @return rays per second; 0 before the run begins
   */
  public double raysPerSecond() {
    final double seconds = seconds();
    return seconds > 0 ? done.get() * resolution.samples() * resolution.samples() / seconds : 0;
  }

  /**
   * Estimated remaining time, at the speed so far.
   *
   * @return seconds; infinity before anything is done
   */
  public double secondsLeft() {
    final double share = share();
    return share > 0 ? seconds() * (1 - share) / share : Double.POSITIVE_INFINITY;
  }
}
