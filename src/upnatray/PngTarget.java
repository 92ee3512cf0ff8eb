package upnatray;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Objects;
import java.util.Set;

import arguments.Messages;

/** The file to which a picture is to be written, and the reasons against that. */
final class PngTarget {

  private static final String ENDING = ".png";

  /** Endings of other image formats, and of input files. (A regular expression takes 20 ms to load.) */
  private static final Set<String> OTHER_FORMATS = Set.of("jpg", "jpeg", "jpe", "jfif", "jp2", "jxl", "gif", "bmp", "dib",
      "tif", "tiff", "webp", "pbm", "pgm", "pnm", "ppm", "pfm", "tga", "ico", "svg", "svgz", "exr", "hdr", "heic", "heif",
      "avif", "psd", "pcx", "xbm", "xpm", "qoi", "eps", "pdf", "xml", "xsd", "obj", "mtl", "zip", "gz", "java");

  /** Names that Windows reserves for devices, in every folder and with any ending. */
  private static final String DEVICES = "(?i)(?:con|prn|aux|nul|conin\\$|conout\\$|(?:com|lpt)[0-9¹²³]) *(?:[.:].*)?";

  private final Path target;

  PngTarget(final Path target) {
    this.target = target;
  }

  /** Checks all that can be checked before the picture is rendered; the inputs are the files that it is made of. */
  void check(final InputFiles inputs) throws SaveException {
    checkName(File.separatorChar == '\\');
    checkPlace();
    if (isIn(inputs)) {
      throw new RefusedTargetException("isInput", target);
    }
    checkContent();
  }

  private boolean isIn(final InputFiles inputs) throws SaveException {
    try {
      return inputs.contains(target);
    } catch (final IOException failure) {
      throw new SaveException("notSaved", target, SaveFailure.reason(failure), failure);
    }
  }

  void checkName(final boolean windows) throws SaveException {
    final String name = name();
    final int dot = name.lastIndexOf('.');
    if (dot >= 0 && OTHER_FORMATS.contains(name.substring(dot + 1).toLowerCase(Locale.ROOT))) {
      final String would = dot == 0 ? name : name.substring(0, dot);
      throw new RefusedTargetException("otherFormat", target, target.resolveSibling(would + ENDING));
    }
    if (windows && name.matches(DEVICES)) {
      throw new RefusedTargetException("isDevice", target, name);
    }
  }

  private String name() {
    return Objects.toString(target.getFileName(), "");
  }

  private void checkPlace() throws SaveException {
    if (Files.isDirectory(target)) {
      throw new SaveException("notSaved", target, Messages.text("upnatray.isFolder"), null);
    }
    if (Files.exists(target) && !Files.isRegularFile(target)) {
      throw new SaveException("notSaved", target, Messages.text("upnatray.isNoFile"), null);
    }
    final Path folder = folder();
    if (Files.exists(folder) && !Files.isDirectory(folder)) {
      throw new SaveException("notSaved", target, Messages.text("upnatray.noFolder", folder), null);
    }
    if (Files.exists(folder) && !Files.isWritable(folder)) {
      throw new SaveException("notSaved", target, Messages.text("upnatray.denied", folder), null);
    }
  }

  /** A file is replaced only if it is a PNG, or empty with such a name, as made by mktemp: then there is nothing to lose. */
  private void checkContent() throws SaveException {
    if (!Files.exists(target)) {
      return;
    }
    try (InputStream in = Files.newInputStream(target)) {
      final byte[] first = in.readNBytes(PngChunks.SIGNATURE.length);
      final boolean replaceable = first.length == 0 ? name().toLowerCase(Locale.ROOT).endsWith(ENDING)
          : Arrays.equals(first, PngChunks.SIGNATURE);
      if (!replaceable) {
        throw new RefusedTargetException("notPng", target);
      }
    } catch (final IOException failure) {
      throw new RefusedTargetException("notKnownAsPng", target, SaveFailure.reason(failure));
    }
  }

  /** Where the file itself is to be written: a symbolic link keeps its place, and what it leads to is replaced. */
  Path place() throws IOException {
    return FileIdentity.place(target);
  }

  private Path folder() throws SaveException {
    try {
      final Path parent = place().getParent();
      return parent == null ? Path.of("") : parent;
    } catch (final IOException failure) {
      throw new SaveException("notSaved", target, SaveFailure.reason(failure), failure);
    }
  }
}
