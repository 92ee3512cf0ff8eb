package upnatray;

import static arguments.Arguments.notNull;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;

import arguments.Messages;

/**
 * Saves images as PNG files that appear whole or not at all: an image is written to a hidden temporary file beside its
 * target, which is then moved into place in one step. Whatever happens before leaves the old file, or none.
 */
public final class PngFile {

  private PngFile() {
  }

  /**
   * Saves an image; the folder is made if it is not there.
   *
   * @param image image of any type, such as an {@link Image}
   * @param target where to; a file that is there is replaced
   * @throws SaveException if it cannot be saved; its message says why
   * @throws IllegalArgumentException if an argument is null
   */
  public static void save(final BufferedImage image, final Path target) throws SaveException {
    notNull("image", image);
    check(notNull("target", target));
    final Path folder = folder(target);
    final Path temporary = folder.resolve(".upnatray-" + Long.toString(System.nanoTime(), 36) + ".tmp");
    try {
      Files.createDirectories(folder);
      write(image, temporary);
      Files.move(temporary, target, StandardCopyOption.ATOMIC_MOVE);
    } catch (final IOException failure) {
      remove(temporary, failure);
      throw new SaveException("notSaved", target, reason(failure), failure);
    }
  }

  private static void write(final BufferedImage image, final Path temporary) throws IOException {
    try (OutputStream out = Files.newOutputStream(temporary, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE)) {
      PngWriter.write(argb(image), out);
    }
  }

  private static BufferedImage argb(final BufferedImage image) {
    if (image.getType() == BufferedImage.TYPE_INT_ARGB) {
      return image;
    }
    final BufferedImage copy = new BufferedImage(image.getWidth(), image.getHeight(), BufferedImage.TYPE_INT_ARGB);
    final Graphics2D g = copy.createGraphics();
    g.drawImage(image, 0, 0, null);
    g.dispose();
    return copy;
  }

  private static void remove(final Path temporary, final IOException failure) {
    try {
      Files.deleteIfExists(temporary);
    } catch (final IOException left) {
      failure.addSuppressed(left);
    }
  }

  /**
   * Tells beforehand what would keep an image from being saved, as far as can be seen.
   *
   * @throws SaveException if the target is a folder or the like, or if its folder is none or must not be written to
   */
  static void check(final Path target) throws SaveException {
    if (Files.isDirectory(target)) {
      throw new SaveException("notSaved", target, Messages.text("upnatray.isFolder"), null);
    }
    if (Files.exists(target) && !Files.isRegularFile(target)) {
      throw new SaveException("notSaved", target, Messages.text("upnatray.isNoFile"), null);
    }
    final Path folder = folder(target);
    if (Files.exists(folder) && !Files.isDirectory(folder)) {
      throw new SaveException("notSaved", target, Messages.text("upnatray.noFolder", folder), null);
    }
    if (Files.exists(folder) && !Files.isWritable(folder)) {
      throw new SaveException("notSaved", target, Messages.text("upnatray.denied", folder), null);
    }
  }

  private static Path folder(final Path target) {
    final Path parent = target.getParent();
    return parent == null ? Path.of("") : parent;
  }

  private static String reason(final IOException failure) {
    if (failure instanceof AccessDeniedException denied) {
      return Messages.text("upnatray.denied", denied.getFile());
    }
    if (failure instanceof FileAlreadyExistsException exists) {
      return Messages.text("upnatray.noFolder", exists.getFile());
    }
    if (failure instanceof NoSuchFileException missing) {
      return Messages.text("upnatray.missing", missing.getFile());
    }
    if (failure instanceof FileSystemException other && other.getReason() != null) {
      return other.getReason();
    }
    return failure.getMessage() == null ? failure.getClass().getSimpleName() : failure.getMessage();
  }
}
