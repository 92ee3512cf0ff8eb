package upnatray;

import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

import arguments.Messages;

/**
 * The command line: renders scene files to PNG files. {@code --help} explains the options.
 *
 * <p>Exit status: 0, 1 if a scene or a file is at fault, 2 if the command line is, 130 if interrupted.
 */
public final class Main {

  /** The scene that is rendered by default. */
  private static final Path DEFAULT_SCENE = Path.of("scenes", "shapes.xml");

  private static final int INCOMPLETE = 1;
  private static final int WRONG_USAGE = 2;

  private Main() {
  }

  /**
   * Executes a command line, and exits with a status if something is wrong.
   *
   * @param args the arguments
   */
  public static void main(final String[] args) {
    final int status = run(args);
    if (status != 0) {
      System.exit(status);
    }
  }

  /** Executes a command line and returns the exit status. */
  static int run(final String... args) {
    try {
      final Options options = Options.of(args);
      if (printInformation(options)) {
        return 0;
      }
      final List<Path> scenes = options.scenes().isEmpty() ? List.of(defaultScene()) : options.scenes();
      if (options.windowIfPossible() && isShown(options, scenes.get(0))) {
        return 0;
      }
      System.setProperty("java.awt.headless", "true");
      return new Batch(options, System.out, System.err).run(scenes);
    } catch (final UsageException wrong) {
      System.err.println("UPNaTRay: " + wrong.getMessage());
      return WRONG_USAGE;
    } catch (final NoClassDefFoundError missing) {
      final Path jar = Libraries.missing().orElseThrow(() -> missing);
      System.err.println("UPNaTRay: " + Messages.text("upnatray.noLibrary", jar));
      return INCOMPLETE;
    }
  }

  /** Prints the help or the version if that is what was asked for; false if it is neither. */
  private static boolean printInformation(final Options options) {
    if (options.help()) {
      System.out.println(Messages.text("upnatray.usage"));
    } else if (options.version()) {
      System.out.println("UPNaTRay " + version());
    }
    return options.help() || options.version();
  }

  /**
   * Opens a window if there is a display. Its libraries are checked before, as otherwise its threads would be the first
   * to miss them.
   */
  private static boolean isShown(final Options options, final Path scene) throws UsageException {
    final Optional<Path> missing = Libraries.missing();
    if (missing.isPresent()) {
      throw new NoClassDefFoundError(missing.get().toString());
    }
    final Optional<Viewer> viewer = Viewer.available();
    viewer.ifPresent(present -> present.show(options.request(scene)));
    if (viewer.isEmpty() && options.window()) {
      throw new UsageException("noDisplay");
    }
    return viewer.isPresent();
  }

  /** The version of the program. */
  static String version() {
    final String version = Main.class.getPackage().getImplementationVersion();
    return version == null ? Messages.text("upnatray.noVersion") : version;
  }

  /** The default scene under the working directory, or else under the folder in which the program was built. */
  private static Path defaultScene() {
    Path folder = Path.of("");
    try {
      if (!Files.exists(DEFAULT_SCENE)) {
        folder = Path.of(Main.class.getProtectionDomain().getCodeSource().getLocation().toURI());
      }
    } catch (final URISyntaxException noFolder) {
      return DEFAULT_SCENE;
    }
    while (folder != null && !Files.exists(folder.resolve(DEFAULT_SCENE))) {
      folder = folder.getParent();
    }
    return folder == null ? DEFAULT_SCENE : folder.resolve(DEFAULT_SCENE);
  }
}
