package upnatray;

import static arguments.Arguments.notNull;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Collection;
import java.util.List;
import java.util.Objects;

import arguments.Messages;

/**
 * Saves images as PNG files that appear whole or not at all: an image is written to a hidden temporary file beside its
 * target, which is then moved into place in one step. Any failure before that leaves the old file, or none.
 *
 * <p>Nothing but a PNG file is ever replaced.
 */
public final class PngFile {

  /** What a file is to hold. */
  @FunctionalInterface
  interface Content {

    /** Writes it to a stream. */
    void writeTo(OutputStream out) throws IOException;
  }

  private PngFile() {
  }

  /**
   * Checks, before a picture is rendered, whether it may be saved in a file. The file has to be missing, or a PNG by its
   * first bytes, or empty with a name in {@code .png}; it must not be an input; its name must not claim another format.
   *
   * @param target where the picture is to go
   * @param inputs the files of which it is made, such as the scene and its meshes: compared as files, not as names
   * @throws SaveException if the picture cannot or must not be saved there; its message says why
   * @throws IllegalArgumentException if an argument is null
   */
  public static void check(final Path target, final Collection<Path> inputs) throws SaveException {
    new PngTarget(notNull("target", target)).check(new InputFiles(notNull("inputs", inputs)));
  }

  /**
   * Saves an image; the folder is made if it is missing. The target of a symbolic link is replaced, not the link.
   *
   * @param image image of any type, such as an {@link Image}; a picture without transparent pixels is written as RGB
   * @param target where to; a PNG file that is there is replaced, any other file is not
   * @throws SaveException if it cannot be saved; its message says why
   * @throws IllegalArgumentException if an argument is null
   */
  public static void save(final BufferedImage image, final Path target) throws SaveException {
    notNull("image", image);
    save(notNull("target", target), out -> PngEncoder.write(image, null, out));
  }

  /** Saves what is written; the same holds as for an image. */
  static void save(final Path target, final Content content) throws SaveException {
    final PngTarget checked = new PngTarget(target);
    checked.check(new InputFiles(List.of()));
    try {
      write(content, checked.place());
    } catch (final IOException failure) {
      throw new SaveException("notSaved", target, SaveFailure.reason(failure), failure);
    }
  }

  private static void write(final Content content, final Path place) throws IOException {
    final Path temporary = place.resolveSibling(".upnatray-" + Long.toString(System.nanoTime(), 36) + ".tmp");
    try {
      if (place.getParent() != null) {
        Files.createDirectories(place.getParent());
      }
      try (OutputStream out = created(temporary, place)) {
        content.writeTo(out);
      }
      Files.move(temporary, place, StandardCopyOption.ATOMIC_MOVE);
    } catch (final IOException failure) {
      remove(temporary, failure);
      throw failure;
    }
  }

  /** Opens a file in a folder that is there; if that is impossible, the reason is the folder's, whose name is known. */
  private static OutputStream created(final Path temporary, final Path place) throws IOException {
    try {
      return Files.newOutputStream(temporary, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
    } catch (final AccessDeniedException | NoSuchFileException failure) {
      final String folder = Objects.toString(place.toAbsolutePath().getParent());
      throw new FileSystemException(folder, null, Messages.text("upnatray.noNewFile", folder));
    }
  }

  private static void remove(final Path temporary, final IOException failure) {
    try {
      Files.deleteIfExists(temporary);
    } catch (final IOException left) {
      failure.addSuppressed(left);
    }
  }
}
