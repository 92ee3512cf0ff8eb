package upnatray;

import java.io.File;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import diagnostics.Suggestion;
import rendering.RenderPass;
import rendering.Supersampling;

/**
 * The options and files of a command line. (Of the libraries for this, picocli adds 30 % to the CPU time of a small picture;
 * commons-cli would save 30 lines, and its messages are in English only.)
 */
final class Options {

  private static final List<String> NAMES = List.of("-o", "--output", "--width", "--height", "--view", "--samples",
      "--adaptive", "--rows", "--turntable", "--seconds", "--frames", "--again", "--threads", "--check", "--window",
      "--no-window", "-h", "--help", "--version");

  /** K of adaptive sampling by default. */
  private static final int ADAPTIVE_SAMPLES = 4;

  private final List<Path> scenes = new ArrayList<>();
  private String output;
  private int width;
  private int height;
  private int threads;
  private int samples;
  private boolean adaptive;
  private int[] rows;
  private int pictures;
  private double seconds;
  private int[] frames;
  private boolean again;
  private RenderPass view = RenderPass.COLOUR;
  private boolean window;
  private boolean noWindow;
  private boolean check;
  private boolean help;
  private boolean version;

  private Options() {
  }

  /**
   * Reads the arguments of a command line. An option's value may follow it as the next argument or after {@code =}; after
   * {@code --} there are only files.
   *
   * @throws UsageException if they are wrong
   */
  static Options of(final String... args) throws UsageException {
    final Options options = new Options();
    boolean onlyFiles = false;
    int i = 0;
    while (i < args.length) {
      final String arg = args[i];
      if (onlyFiles || !arg.startsWith("-") || arg.equals("-")) {
        options.scenes.add(OptionValue.path(arg));
        i++;
      } else if (arg.equals("--")) {
        onlyFiles = true;
        i++;
      } else {
        i += options.read(arg, i + 1 < args.length ? args[i + 1] : null);
      }
    }
    options.checkTogether();
    return options;
  }

  /** Reads an option and returns how many arguments it took. */
  private int read(final String arg, final String next) throws UsageException {
    final int equals = arg.startsWith("--") ? arg.indexOf('=') : -1;
    final String name = equals < 0 ? arg : arg.substring(0, equals);
    if (readFlag(name)) {
      if (equals >= 0) {
        throw new UsageException("noValue", name);
      }
      return 1;
    }
    final OptionValue value = new OptionValue(name, equals < 0 ? next : arg.substring(equals + 1));
    switch (name) {
      case "-o", "--output" -> output = value.text();
      case "--width" -> width = value.count();
      case "--height" -> height = value.count();
      case "--view" -> view = value.view();
      case "--samples" -> samples = value.within(1, Supersampling.MOST);
      case "--rows" -> rows = value.range(1);
      case "--turntable" -> pictures = value.within(Turntable.FEWEST, Turntable.MOST);
      case "--seconds" -> seconds = value.positive();
      case "--frames" -> frames = value.range(0);
      case "--threads" -> threads = value.count();
      default -> {
        final String question = Suggestion.question(name, NAMES);
        throw new UsageException("unknownOption", arg, question.isEmpty() ? "" : "." + question);
      }
    }
    return equals < 0 ? 2 : 1;
  }

  private boolean readFlag(final String name) {
    switch (name) {
      case "--adaptive" -> adaptive = true;
      case "--again" -> again = true;
      case "--check" -> check = true;
      case "-h", "--help" -> help = true;
      case "--version" -> version = true;
      case "--window" -> window = true;
      case "--no-window" -> noWindow = true;
      default -> {
        return false;
      }
    }
    return true;
  }

  private void checkTogether() throws UsageException {
    files().check();
    if (check && scenes.isEmpty() && !help && !version) {
      throw new UsageException("nothingToCheck");
    }
    if (window && (noWindow || check || output != null || scenes.size() > 1)) {
      throw new UsageException("windowAlone");
    }
    if (window && isForFiles()) {
      throw new UsageException("samplesNoWindow");
    }
    if (view.showsNumbers()) {
      checkNumbers();
    }
    checkTurntable();
    if (!check && !window) {
      files().checkDistinct();
    }
  }

  private void checkNumbers() throws UsageException {
    if (samples > 1 || adaptive) {
      throw new UsageException("samplesNoNumbers", adaptive ? "--adaptive" : "--samples", view.option());
    }
    if (rows != null || pictures > 0) {
      throw new UsageException("noCommonScale", rows != null ? "--rows" : "--turntable", view.option());
    }
  }

  private void checkTurntable() throws UsageException {
    if (adaptive && samples == 1) {
      throw new UsageException("adaptiveOne");
    }
    if (pictures == 0 && (seconds > 0 || frames != null || again)) {
      throw new UsageException("noTurntable", seconds > 0 ? "--seconds" : frames != null ? "--frames" : "--again");
    }
    final double least = Turntable.SHORTEST * pictures, most = Turntable.LONGEST * pictures;
    if (seconds > 0 && (seconds < least || seconds > most)) {
      throw new UsageException("secondsOutside", pictures, least, most, seconds);
    }
    if (frames != null && frames[1] >= pictures) {
      throw new UsageException("framesOutside", frames[0] + "-" + frames[1], pictures - 1);
    }
  }

  /** The files for the pictures. */
  private PictureFiles files() {
    return new PictureFiles(scenes, output, turntable());
  }

  /** The file for the picture of a scene. */
  Path target(final Path scene) throws UsageException {
    return files().of(scene);
  }

  /** All files for the pictures of a scene: of an animation several. */
  List<Path> targets(final Path scene) throws UsageException {
    return files().all(scene);
  }

  List<Path> scenes() {
    return scenes;
  }

  /** Width and height of the picture of a scene of a size: if one is asked for, the other keeps the proportion. */
  int[] size(final int sceneWidth, final int sceneHeight) {
    final int w = width > 0 ? width : height > 0 ? scaled(sceneWidth, height, sceneHeight) : sceneWidth;
    final int h = height > 0 ? height : width > 0 ? scaled(sceneHeight, width, sceneWidth) : sceneHeight;
    return new int[] {w, h};
  }

  /** The resolution of the picture of a scene of a size. */
  Resolution resolution(final int sceneWidth, final int sceneHeight) throws UsageException {
    final int[] size = size(sceneWidth, sceneHeight);
    if (rows != null && rows[1] > size[1]) {
      throw new UsageException("rowsOutside", rows[0] + "-" + rows[1], size[1]);
    }
    final int K = samples > 0 ? samples : adaptive ? ADAPTIVE_SAMPLES : 1;
    return rows == null ? new Resolution(size[0], size[1], K, adaptive, 0, size[1])
        : new Resolution(size[0], size[1], K, adaptive, rows[0] - 1, rows[1] - rows[0] + 1);
  }

  /** The animation that is asked for; empty if a single picture is. */
  Optional<Turntable> turntable() {
    return pictures == 0 ? Optional.empty() : Optional.of(new Turntable(pictures,
        seconds > 0 ? seconds : Turntable.standardSeconds(pictures), frames == null ? 0 : frames[0],
        frames == null ? pictures - 1 : frames[1], again));
  }

  /** Whether the options are for files only. */
  private boolean isForFiles() {
    return samples > 1 || adaptive || rows != null || pictures > 0;
  }

  private static int scaled(final int size, final int wanted, final int other) {
    return (int) Math.max(1, Math.min(Integer.MAX_VALUE, Math.round((double) size * wanted / other)));
  }

  /** The request for a window with a scene. */
  Viewer.Request request(final Path scene) {
    return new Viewer.Request(scene, view, width, height, threads);
  }

  /** Number of threads; 0 if not given. */
  int threads() {
    return threads;
  }

  RenderPass view() {
    return view;
  }

  /** Whether a window is required. */
  boolean window() {
    return window;
  }

  /** Whether a window is wanted if there is a display: for one scene whose picture is not asked for as a file. */
  boolean windowIfPossible() {
    return window || !noWindow && !check && output == null && !isForFiles() && scenes.size() <= 1 && hasDisplay();
  }

  /** A first check that loads no class of the window. It works only on systems with X or Wayland. */
  private static boolean hasDisplay() {
    return !Boolean.getBoolean("java.awt.headless") && (File.separatorChar == '\\'
        || System.getProperty("os.name").startsWith("Mac") || System.getenv("DISPLAY") != null);
  }

  boolean check() {
    return check;
  }

  boolean help() {
    return help;
  }

  boolean version() {
    return version;
  }
}
