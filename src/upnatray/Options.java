package upnatray;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.StringJoiner;

import diagnostics.LocaleCharset;
import rendering.RenderPass;
import rendering.Supersampling;

/**
 * The options and files of a command line. (Of the libraries for this, picocli adds 30 % to the CPU time of a small picture;
 * commons-cli would save 30 lines, and its messages are in English only.)
 */
final class Options {

  private final List<Path> scenes = new ArrayList<>();
  private String output;
  private int width;
  private int height;
  private int threads;
  private int samples = 1;
  private int[] rows;
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
        options.scenes.add(path(arg));
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
    final String value = equals < 0 ? next : arg.substring(equals + 1);
    switch (name) {
      case "-o", "--output" -> output = value(name, value);
      case "--width" -> width = count(name, value);
      case "--height" -> height = count(name, value);
      case "--view" -> view = view(value(name, value));
      case "--samples" -> samples = samples(name, value);
      case "--rows" -> rows = range(name, value);
      case "--threads" -> threads = count(name, value);
      default -> throw new UsageException("unknownOption", arg);
    }
    return equals < 0 ? 2 : 1;
  }

  private boolean readFlag(final String name) {
    switch (name) {
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

  private static RenderPass view(final String name) throws UsageException {
    final StringJoiner names = new StringJoiner(", ");
    for (final RenderPass view : RenderPass.values()) {
      names.add(view.option());
    }
    return RenderPass.named(name).orElseThrow(() -> new UsageException("unknownView", name, names));
  }

  private static String value(final String name, final String value) throws UsageException {
    if (value == null || value.isEmpty()) {
      throw new UsageException("valueMissing", name);
    }
    return value;
  }

  private static int count(final String name, final String value) throws UsageException {
    final String text = value(name, value);
    try {
      final int count = Integer.parseInt(text);
      if (count >= 1) {
        return count;
      }
    } catch (final NumberFormatException noNumber) {
      throw new UsageException("notCount", name, text);
    }
    throw new UsageException("notCount", name, text);
  }

  private static int samples(final String name, final String value) throws UsageException {
    final int samples = count(name, value);
    if (samples > Supersampling.MOST) {
      throw new UsageException("tooManySamples", name, Supersampling.MOST, value);
    }
    return samples;
  }

  /** Two numbers A-B, from 1, the first at most the second. */
  private static int[] range(final String name, final String value) throws UsageException {
    final String text = value(name, value);
    final int dash = text.indexOf('-');
    if (dash <= 0) {
      throw new UsageException("notRange", name, text);
    }
    final int first = count(name, text.substring(0, dash)), last = count(name, text.substring(dash + 1));
    if (first > last) {
      throw new UsageException("notRange", name, text);
    }
    return new int[] {first, last};
  }

  private static Path path(final String text) throws UsageException {
    try {
      return Path.of(text);
    } catch (final InvalidPathException noPath) {
      throw LocaleCharset.canExpress(text) ? new UsageException("noPath", text)
          : new UsageException("noPathInLocale", text, LocaleCharset.name());
    }
  }

  private void checkTogether() throws UsageException {
    if (output != null && scenes.size() > 1 && !Files.isDirectory(path(output))
        && (Files.exists(path(output)) || output.toLowerCase(Locale.ROOT).endsWith(".png"))) {
      throw new UsageException("outputNoFolder", output);
    }
    if (output != null && scenes.isEmpty() && isScene(output)) {
      throw new UsageException("outputIsScene", output);
    }
    if (check && scenes.isEmpty() && !help && !version) {
      throw new UsageException("nothingToCheck");
    }
    if (window && (noWindow || check || output != null || scenes.size() > 1)) {
      throw new UsageException("windowAlone");
    }
    if (window && isForFiles()) {
      throw new UsageException("samplesNoWindow");
    }
    if (samples > 1 && (view == RenderPass.DEPTH || view == RenderPass.COST)) {
      throw new UsageException("samplesNoNumbers", view.option());
    }
    if (!check && !window) {
      checkTargets();
    }
  }

  /** Two scenes of one name in different folders would be written to the same file. */
  private void checkTargets() throws UsageException {
    final Map<Object, Path> sceneOf = new HashMap<>();
    for (final Path scene : new LinkedHashSet<>(scenes)) {
      final Path target = target(scene);
      final Path other = sceneOf.putIfAbsent(identity(target), scene);
      if (other != null && !identity(other).equals(identity(scene))) {
        throw new UsageException("sameTarget", other, scene, target);
      }
    }
  }

  private static Object identity(final Path file) {
    try {
      return FileIdentity.of(file);
    } catch (final IOException nowhere) {
      return file;
    }
  }

  /** The file to which the picture of a scene goes. A root folder has no name; that it is not a scene is reported later. */
  Path target(final Path scene) throws UsageException {
    final String file = Objects.toString(scene.getFileName(), "");
    final String name = (isScene(file) ? file.substring(0, file.length() - 4) : file) + ".png";
    if (output == null) {
      return Path.of("images", name);
    }
    final boolean folder = scenes.size() > 1 || output.endsWith("/") || output.endsWith(File.separator)
        || Files.isDirectory(path(output));
    return folder ? path(output).resolve(name) : path(output);
  }

  private static boolean isScene(final String name) {
    return name.toLowerCase(Locale.ROOT).endsWith(".xml");
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
    return rows == null ? new Resolution(size[0], size[1], samples, 0, size[1])
        : new Resolution(size[0], size[1], samples, rows[0] - 1, rows[1] - rows[0] + 1);
  }

  /** Whether the options are for files only. */
  private boolean isForFiles() {
    return samples > 1 || rows != null;
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
