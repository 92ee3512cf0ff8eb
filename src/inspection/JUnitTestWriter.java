package inspection;

import static arguments.Arguments.notNull;

import java.awt.Color;
import java.lang.reflect.Modifier;
import java.util.List;
import java.util.Map;
import java.util.StringJoiner;
import java.util.TreeSet;

import javax.vecmath.TexCoord2f;
import javax.vecmath.Tuple3f;

import materials.Material;
import materials.Texture;
import models.FacetArguments;
import models.Group3D;
import models.Object3D;
import models.Triangle;
import models.TriangularMesh;
import tracer.Hit;
import tracer.Ray;

/**
 * Writes a JUnit 5 test method that recreates the ray and the object of a pixel and asserts the hit. All names are fully
 * qualified, so it compiles wherever it is pasted.
 *
 * <p>The object is recreated from {@link Object3D#constructorArguments}; of a mesh, only the triangle that was hit, with the
 * normals and texture coordinates of its corners. Textures are replaced by one of a single texel. If an object does not
 * provide its arguments, the test fails with a message that asks for it.
 */
public final class JUnitTestWriter {

  private static final String NEW_LINE = "\n";

  /** Relative tolerance for t and the coordinates: the object's numbers were rounded to floats. */
  private static final float TOLERANCE = 1e-4f;

  private final Inspection inspection;
  private final Intersection intersection;

  private JUnitTestWriter(final Inspection inspection, final Intersection intersection) {
    this.inspection = inspection;
    this.intersection = intersection;
  }

  /**
   * Writes the test of an intersection.
   *
   * @param inspection the inspection of the pixel
   * @param intersection one of its intersections
   * @return the source of the method, indented by two blanks, with a final line end
   * @throws IllegalArgumentException if an argument is null
   */
  public static String of(final Inspection inspection, final Intersection intersection) {
    return new JUnitTestWriter(notNull("inspection", inspection), notNull("intersection", intersection)).text();
  }

  private String text() {
    final PixelRay pixel = inspection.pixel();
    final Ray ray = pixel.ray();
    final StringJoiner text = new StringJoiner(NEW_LINE, "", NEW_LINE);
    text.add("  /** Pixel (" + pixel.m() + ", " + pixel.n() + ") of " + pixel.W() + " x " + pixel.H() + ". */");
    text.add("  @org.junit.jupiter.api.Test");
    text.add("  void pixel" + pixel.m() + "And" + pixel.n() + "Hits"
        + intersection.object().getClass().getSimpleName() + "() {");
    text.add("    final models.Object3D object = " + object(intersection.sceneObject()) + ";");
    text.add("    final tracer.Ray ray = new tracer.Ray(" + tuple("primitives.Point3D", ray.getStartingPoint()) + ",");
    text.add("        " + tuple("primitives.Vector3D", ray.getDirection()) + ");");
    text.add("    final tracer.Hit hit = object.intersectionWith(ray);");
    addAssertions(text, intersection.hit());
    text.add("  }");
    return text.toString();
  }

  private void addAssertions(final StringJoiner text, final Hit hit) {
    final String assertions = "    org.junit.jupiter.api.Assertions.";
    if (!hit.hits()) {
      text.add(assertions + "assertSame(tracer.Hit.NOHIT, hit);");
      return;
    }
    final Tuple3f P = hit.getPoint();
    final float size = hit.getT() + Math.abs(P.x) + Math.abs(P.y) + Math.abs(P.z);
    text.add(assertions + "assertTrue(hit.hits());");
    text.add(assertions + "assertEquals(" + number(hit.getT()) + ", hit.getT(), " + number(TOLERANCE * size) + ");");
    text.add(assertions + "assertEquals(0, hit.getPoint().distance(" + tuple("primitives.Point3D", P) + "), "
        + number(TOLERANCE * size) + ");");
    text.add(assertions + "assertEquals(0, hit.getNormal().angle(" + tuple("primitives.Vector3D", hit.getNormal())
        + "), 1e-3f);");
    if (!Double.isNaN(hit.textureU())) {
      text.add(assertions + "assertEquals(" + hit.textureU() + ", hit.textureU(), 1e-3);");
      text.add(assertions + "assertEquals(" + hit.textureV() + ", hit.textureV(), 1e-3);");
    }
  }

  /** The expression that recreates an object; for a group, the contained object that was hit. */
  private String object(final Object3D object) {
    if (object instanceof TriangularMesh mesh && intersection.hit().getObject() instanceof Triangle triangle) {
      final List<Object> shaded = FacetArguments.of(mesh, triangle);
      return shaded.isEmpty() ? object(triangle) : expression(TriangularMesh.class.getName(), shaded);
    }
    final List<Object> arguments = object.constructorArguments();
    if (arguments.isEmpty() && !object.parts().isEmpty()) {
      return object(intersection.object());
    }
    final String name = object.getClass().getCanonicalName();
    if (arguments.isEmpty() || name == null || !Modifier.isPublic(object.getClass().getModifiers())) {
      final String simple = object.getClass().getSimpleName();
      return "org.junit.jupiter.api.Assertions.fail(\"make the " + simple + " here, or write "
          + simple + ".constructorArguments\")";
    }
    return expression(name, arguments);
  }

  private String expression(final String name, final List<Object> arguments) {
    final StringJoiner list = new StringJoiner("," + NEW_LINE + "        ", "new " + name + "(", ")");
    for (final Object argument : arguments) {
      list.add(argument(argument));
    }
    return list.toString();
  }

  private String map(final Map<?, ?> map) {
    final StringJoiner entries = new StringJoiner(", ", "java.util.Map.of(", ")");
    for (final Object key : new TreeSet<Object>(map.keySet())) {
      entries.add(key + ", " + argument(map.get(key)));
    }
    return entries.toString();
  }

  private static String list(final List<?> texts) {
    final StringJoiner elements = new StringJoiner(", ", "java.util.List.of(", ")");
    for (final Object text : texts) {
      elements.add("\"" + text + "\"");
    }
    return elements.toString();
  }

  private String argument(final Object argument) {
    if (argument instanceof Object3D object) {
      return object(object);
    }
    if (argument instanceof Tuple3f tuple) {
      return tuple(argument.getClass().getCanonicalName(), tuple);
    }
    if (argument instanceof Float number) {
      return number(number);
    }
    if (argument instanceof Color color) {
      return "new java.awt.Color(" + color.getRed() + ", " + color.getGreen() + ", " + color.getBlue() + ", "
          + color.getAlpha() + ")";
    }
    if (argument instanceof Material material) {
      return argument(material.getColor());
    }
    if (argument instanceof Texture) {
      return "new materials.Texture(new java.awt.image.BufferedImage(1, 1, 2))";
    }
    if (argument instanceof TexCoord2f uv) {
      return "new javax.vecmath.TexCoord2f(" + number(uv.x) + ", " + number(uv.y) + ")";
    }
    if (argument instanceof Map<?, ?> map) {
      return map(map);
    }
    if (argument instanceof List<?> list) {
      return list(list);
    }
    return String.valueOf(argument);
  }

  private static String tuple(final String type, final Tuple3f tuple) {
    return "new " + type + "(" + number(tuple.x) + ", " + number(tuple.y) + ", " + number(tuple.z) + ")";
  }

  private static String number(final float number) {
    return number + "f";
  }
}
