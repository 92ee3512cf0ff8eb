package upnatray;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.jar.Attributes;
import java.util.jar.JarFile;
import java.util.jar.Manifest;

/** The jars that the manifest of the program's own jar names, by paths relative to it. */
final class Libraries {

  private Libraries() {
  }

  /** The first of them that does not exist; empty too if the program does not run from a jar. */
  static Optional<Path> missing() {
    try {
      return missing(Path.of(Main.class.getProtectionDomain().getCodeSource().getLocation().toURI()));
    } catch (final URISyntaxException noFile) {
      return Optional.empty();
    }
  }

  static Optional<Path> missing(final Path jar) {
    if (!Files.isRegularFile(jar)) {
      return Optional.empty();
    }
    try (JarFile open = new JarFile(jar.toFile())) {
      final Manifest manifest = open.getManifest();
      final String classPath = manifest == null ? null : manifest.getMainAttributes().getValue(Attributes.Name.CLASS_PATH);
      for (final String entry : classPath == null ? new String[0] : classPath.trim().split(" +")) {
        final Path file = Path.of(jar.toUri().resolve(entry));
        if (!Files.exists(file)) {
          return Optional.of(file);
        }
      }
    } catch (final IOException unreadable) {
      return Optional.empty();
    }
    return Optional.empty();
  }
}
