package upnatray;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/** The files to which the pictures of some scenes go. */
final class PictureFiles {

  private final List<Path> scenes;
  private final String output;
  private final Optional<Turntable> turntable;

  /**
   * The files for some scenes.
   *
   * @param scenes the scenes
   * @param output the file or folder for the pictures; null for the folder images
   * @param turntable the animation that is asked for, if any
   */
  PictureFiles(final List<Path> scenes, final String output, final Optional<Turntable> turntable) {
    this.scenes = scenes;
    this.output = output;
    this.turntable = turntable;
  }

  /** Several scenes need a folder; and two of one name in different folders would be written to the same file. */
  void check() throws UsageException {
    if (output != null && scenes.size() > 1 && !Files.isDirectory(OptionValue.path(output))
        && (Files.exists(OptionValue.path(output)) || output.toLowerCase(Locale.ROOT).endsWith(".png"))) {
      throw new UsageException("outputNoFolder", output);
    }
    if (output != null && scenes.isEmpty() && isScene(output)) {
      throw new UsageException("outputIsScene", output);
    }
  }

  /** No two scenes may have a file in common. */
  void checkDistinct() throws UsageException {
    final Map<Object, Path> sceneOf = new HashMap<>();
    for (final Path scene : new LinkedHashSet<>(scenes)) {
      for (final Path file : scenes.size() > 1 ? all(scene) : List.of(of(scene))) {
        final Path other = sceneOf.putIfAbsent(identity(file), scene);
        if (other != null && !identity(other).equals(identity(scene))) {
          throw new UsageException("sameTarget", other, scene, file);
        }
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

  /** The file for the picture of a scene. A root has no name; that it is not a scene is reported later. */
  Path of(final Path scene) throws UsageException {
    final String file = Objects.toString(scene.getFileName(), "");
    final String name = (isScene(file) ? file.substring(0, file.length() - 4) : file) + ".png";
    if (output == null) {
      return Path.of("images", name);
    }
    final Path path = OptionValue.path(output);
    final boolean folder = scenes.size() > 1 || output.endsWith("/") || output.endsWith(File.separator)
        || Files.isDirectory(path);
    return folder ? path.resolve(name) : path;
  }

  /** All files for a scene: of an animation those of the pictures, and last, if it is rendered whole, the animated one. */
  List<Path> all(final Path scene) throws UsageException {
    final Path file = of(scene);
    if (turntable.isEmpty()) {
      return List.of(file);
    }
    final List<Path> all = new ArrayList<>();
    for (int k = turntable.get().first(); k <= turntable.get().last(); k++) {
      all.add(turntable.get().file(file, k));
    }
    if (turntable.get().isWhole()) {
      all.add(file);
    }
    return all;
  }

  private static boolean isScene(final String name) {
    return name.toLowerCase(Locale.ROOT).endsWith(".xml");
  }
}
