package inspection;

import static arguments.Arguments.notNull;

import java.nio.file.Path;
import java.util.StringJoiner;

import javax.vecmath.Tuple3f;

import radiometry.RadianceRGB;
import tracer.Ray;

/**
 * Writes a JUnit 5 test method for the light of a pixel. It reads the scene file, with its objects, lights and materials,
 * traces the ray of the pixel and asserts its radiance. All names are fully qualified, so it compiles wherever it is pasted.
 */
public final class LitPixelTestWriter {

  private static final String NEW_LINE = "\n";

  /** Relative tolerance for the radiance: the ray in the text is rounded to floats. */
  private static final double TOLERANCE = 1e-3;

  private LitPixelTestWriter() {
  }

  /**
   * Writes the test of a pixel.
   *
   * @param inspection the inspection of a pixel of a lit scene
   * @param file the scene file
   * @return the source of the method, indented by two blanks, with a final line end
   * @throws IllegalArgumentException if an argument is null, or if the pixel has no light
   */
  public static String of(final Inspection inspection, final Path file) {
    final PixelLight light = notNull("inspection", inspection).light()
        .orElseThrow(() -> new IllegalArgumentException("light"));
    final PixelRay pixel = inspection.pixel();
    final Ray ray = pixel.ray();
    final StringJoiner text = new StringJoiner(NEW_LINE, "", NEW_LINE);
    text.add("  /** Light of pixel (" + pixel.m() + ", " + pixel.n() + ") of " + pixel.W() + " x " + pixel.H() + ". */");
    text.add("  @org.junit.jupiter.api.Test");
    text.add("  void light" + pixel.m() + "And" + pixel.n() + "() {");
    text.add("    final scenes.SceneFile scene = scenes.SceneReader.read(java.nio.file.Path.of("
        + quote(notNull("file", file)) + ")).scene().orElseThrow();");
    text.add("    final rendering.Illumination light = new rendering.Illumination(scene.objects(), scene.lights(), "
        + light.recursionDepth() + ",");
    text.add("        scene.background());");
    text.add("    final tracer.Ray ray = new tracer.Ray(new primitives.Point3D" + tuple(ray.getStartingPoint()) + ",");
    text.add("        new primitives.Vector3D" + tuple(ray.getDirection()) + ");");
    text.add("    final radiometry.RadianceRGB L = light.radiance(ray, scene.objects().intersectionWith(ray),");
    text.add("        rendering.LightObserver.NONE);");
    final RadianceRGB L = light.radiance();
    text.add(assertion(L.getR(), "R"));
    text.add(assertion(L.getG(), "G"));
    text.add(assertion(L.getB(), "B"));
    text.add("  }");
    return text.toString();
  }

  private static String assertion(final double expected, final String channel) {
    return "    org.junit.jupiter.api.Assertions.assertEquals(" + expected + ", L.get" + channel + "(), "
        + (TOLERANCE * expected + 1e-9) + ");";
  }

  private static String tuple(final Tuple3f tuple) {
    return "(" + tuple.x + "f, " + tuple.y + "f, " + tuple.z + "f)";
  }

  /** A string literal of Java; all but ASCII as escapes, so that it does not depend on the encoding of the source. */
  private static String quote(final Path file) {
    final StringBuilder literal = new StringBuilder("\"");
    for (final char c : file.toString().toCharArray()) {
      if (c == '\\' || c == '"') {
        literal.append('\\').append(c);
      } else if (c < ' ' || c > '~') {
        literal.append(String.format("\\u%04x", (int) c));
      } else {
        literal.append(c);
      }
    }
    return literal.append('"').toString();
  }
}
