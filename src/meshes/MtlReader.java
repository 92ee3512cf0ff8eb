package meshes;

import java.awt.Color;
import java.io.BufferedInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;

import arguments.Messages;
import diagnostics.Problem;
import materials.Texture;

/**
 * Reads a Wavefront material file as far as it says what colour a surface has: {@code Kd}, {@code d} or {@code Tr}, and
 * {@code map_Kd}. Everything else is skipped; invalid numbers leave the default.
 */
final class MtlReader {

  /** A file longer than this, in bytes, is not a material file. */
  private static final long LARGEST = 1L << 28;

  private final Path file;
  private final Consumer<Problem> problems;
  private final Collection<Path> files;
  private final Map<String, MtlMaterial> materials;
  private final Map<Path, Texture> textures = new HashMap<>();
  private final DecimalParser decimals = new DecimalParser();
  private ObjText text;
  private String name;
  private double[] diffuse;
  private double opacity;
  private boolean hasOpacity;
  private Texture map;

  /**
   * A reader of a file.
   *
   * @param file the file
   * @param problems receives the problems, which are warnings
   * @param files receives the files of textures
   * @param materials receives the materials by their names, unless it has one of that name
   */
  MtlReader(final Path file, final Consumer<Problem> problems, final Collection<Path> files,
      final Map<String, MtlMaterial> materials) {
    this.file = file;
    this.problems = problems;
    this.files = files;
    this.materials = materials;
  }

  void read() {
    try (BufferedInputStream in = new BufferedInputStream(Files.newInputStream(file))) {
      text = new ObjText(new ByteReader(TextEncoding.decoded(in), LARGEST));
      text.bytes.reserve();
      while (!text.isAtEnd()) {
        statement();
      }
    } catch (final IOException failure) {
      warn(1, "unreadable", failure.getClass().getSimpleName() + ": " + failure.getMessage());
    }
    finish();
  }

  private void statement() throws IOException {
    if (!text.toWord()) {
      text.endLine();
      return;
    }
    final byte first = text.bytes.window[text.bytes.at];
    if (text.takeWord("newmtl")) {
      finish();
      begin(text.name());
    } else if (name != null) {
      property();
    }
    text.skipLine(first != '#');
  }

  private void begin(final String newName) {
    name = newName;
    diffuse = null;
    opacity = 1;
    hasOpacity = false;
    map = null;
  }

  private void finish() {
    if (name != null) {
      final int alpha = component(opacity) == 0 ? 255 : component(opacity);
      final Color standard = MtlMaterial.DEFAULT.color();
      final Color color = diffuse == null ? new Color(standard.getRed(), standard.getGreen(), standard.getBlue(), alpha)
          : new Color(component(diffuse[0]), component(diffuse[1]), component(diffuse[2]), alpha);
      materials.putIfAbsent(name, new MtlMaterial(color, map == null || alpha == 255 ? map : map.withOpacity(opacity)));
    }
    name = null;
  }

  private static int component(final double value) {
    return (int) Math.floor(255 * Math.max(0, Math.min(1, value)) + 0.5);
  }

  private void property() throws IOException {
    if (text.takeWord("Kd")) {
      colour();
    } else if (text.takeWord("d")) {
      final double last = lastNumber();
      opacity = Double.isNaN(last) ? opacity : Math.max(0, Math.min(1, last));
      hasOpacity |= !Double.isNaN(last);
    } else if (text.takeWord("Tr")) {
      final double last = lastNumber();
      opacity = hasOpacity || Double.isNaN(last) ? opacity : Math.max(0, Math.min(1, 1 - last));
    } else if (text.takeWord("map_Kd")) {
      final int line = text.line();
      map(text.name(), line);
    }
  }

  /** Three numbers, or one for all; anything else leaves the default. */
  private void colour() throws IOException {
    final double r = number();
    final double g = Double.isNaN(r) ? r : number();
    final double b = Double.isNaN(g) ? g : number();
    if (!Double.isNaN(b)) {
      diffuse = new double[] {r, g, b};
    } else if (!Double.isNaN(r) && Double.isNaN(g) && !text.toWord()) {
      diffuse = new double[] {r, r, r};
    }
  }

  /** The next number; NaN if none. */
  private double number() throws IOException {
    if (!text.toWord()) {
      return Double.NaN;
    }
    final double number = decimals.parse(text.bytes.window, text.bytes.at);
    final int end = decimals.end();
    if (end == text.bytes.at || !text.endsWord(end)) {
      return Double.NaN;
    }
    text.bytes.at = end;
    return number;
  }

  /** The last number of a line, which may begin with options such as {@code -halo}; NaN if none. */
  private double lastNumber() throws IOException {
    double last = Double.NaN;
    while (text.toWord()) {
      final double number = number();
      last = Double.isNaN(number) ? last : number;
      text.skipWord();
    }
    return last;
  }

  private void map(final String statement, final int line) {
    final TextureMap found = TextureMap.of(statement);
    if (found.isMoved()) {
      warn(line, "mapMoved", Messages.quote(found.file()));
    }
    if (found.file().isEmpty()) {
      warn(line, "mapNameless");
      return;
    }
    final Path image = MaterialFiles.find(file, found.file());
    if (image == null) {
      warn(line, "mapMissing", Messages.quote(found.file()));
      return;
    }
    files.add(image);
    try {
      map = textures.containsKey(image) ? textures.get(image) : TextureFile.read(image);
      textures.put(image, map);
    } catch (final TextureFile.UnusableException unusable) {
      warn(line, "mapUnusable", Messages.quote(found.file()), unusable.getMessage());
    }
  }

  private void warn(final int line, final String key, final Object... parts) {
    problems.accept(new Problem(file.toString(), line, 1, Problem.Severity.WARNING, Messages.text("meshes." + key, parts)));
  }
}
