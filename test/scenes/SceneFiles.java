package scenes;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

import diagnostics.Problem;

/** Scene files for tests: a small valid one, and variants with parts replaced. */
public final class SceneFiles {

  /** A sphere of radius 1 at the origin, seen from (0, 0, 5). */
  static final String SOUND = """
      <?xml version="1.0"?>
      <image name="a ball">
        <raster>
          <W>40</W>
          <H>30</H>
          <backgroundColor>0.2 0.4 0.6</backgroundColor>
        </raster>
        <rayTracer>
          <wblock>32</wblock>
          <hblock>32</hblock>
          <showProgress>true</showProgress>
        </rayTracer>
        <engine>
          <illumination>false</illumination>
        </engine>
        <camera>
          <position>0 0 5</position>
          <lookAt>0 0 0</lookAt>
          <up>0 1 0</up>
        </camera>
        <projection type="perspective">
          <fov>60</fov>
          <aspect>1.3333</aspect>
        </projection>
        <models>
          <model id="ball" type="sphere">
            <radius>1</radius>
          </model>
        </models>
        <scene>
          <object>
            <modelId>ball</modelId>
            <color>255 0 0</color>
          </object>
        </scene>
      </image>
      """;

  private final Path folder;

  public SceneFiles(final Path folder) {
    this.folder = folder;
  }

  public Path folder() {
    return folder;
  }

  /** Writes a file. */
  public Path write(final String name, final String text) {
    return write(name, text.getBytes(StandardCharsets.UTF_8));
  }

  public Path write(final String name, final byte[] bytes) {
    try {
      final Path file = folder.resolve(name);
      Files.createDirectories(file.getParent());
      return Files.write(file, bytes);
    } catch (final IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Reads a scene, given its text. */
  ReadResult read(final String text) {
    return SceneReader.read(write("scene.xml", text));
  }

  /** Reads the valid scene with a part of it, which must occur, replaced. */
  ReadResult readWith(final String part, final String other) {
    return read(with(part, other));
  }

  static String with(final String part, final String other) {
    if (!SOUND.contains(part)) {
      throw new IllegalArgumentException(part);
    }
    return SOUND.replace(part, other);
  }

  /** The valid scene with another model of the id "ball". */
  ReadResult readModel(final String type, final String values) {
    return readWith("<model id=\"ball\" type=\"sphere\">\n      <radius>1</radius>",
        "<model id=\"ball\" type=\"" + type + "\">\n      " + values);
  }

  /** The valid scene with more in its object. */
  ReadResult readPlaced(final String values) {
    return readWith("<color>255 0 0</color>", "<color>255 0 0</color>\n" + values);
  }

  /** The problems as lines, without the name of the file: {@code LINE:COLUMN: message}. */
  static List<String> lines(final ReadResult reading) {
    return reading.problems().stream().map(SceneFiles::line).collect(Collectors.toList());
  }

  private static String line(final Problem problem) {
    return problem.toString().substring(problem.file().length() + 1);
  }

  /** Runs an action in another locale. */
  static void in(final Locale locale, final Runnable action) {
    final Locale before = Locale.getDefault();
    Locale.setDefault(locale);
    try {
      action.run();
    } finally {
      Locale.setDefault(before);
    }
  }
}
