package inspection;

import static arguments.Arguments.notNull;

import java.awt.Color;
import java.lang.reflect.Modifier;
import java.util.List;
import java.util.StringJoiner;

import javax.vecmath.Tuple3f;

import models.Group3D;
import models.Object3D;
import models.TriangularMesh;
import tracer.Hit;
import tracer.Ray;

/**
 * Writes the hit of a pixel down as a JUnit 5 method, which makes the ray and the object anew and asserts what was found.
 * All names are complete, so that it compiles wherever it is pasted.
 *
 * <p>The object is made of {@link Object3D#constructorArguments}; of a mesh, the triangle that was met. Of an object that
 * does not tell them the method says so when it is run.
 */
public final class JUnitTestWriter {

  private static final String NEW_LINE = "\n";

  /** Part of t, and of coordinates, that a hit found again may be off: the object's numbers were rounded to floats. */
  private static final float TOLERANCE = 1e-4f;

  private final Inspection inspection;
  private final Intersection meeting;

  private JUnitTestWriter(final Inspection inspection, final Intersection meeting) {
    this.inspection = inspection;
    this.meeting = meeting;
  }

  /**
   * The test of a meeting.
   *
   * @param inspection what is known of the pixel
   * @param meeting one of its meetings
   * @return a method of a class, indented by two blanks, with an end of line
   * @throws IllegalArgumentException if an argument is null
   */
  public static String of(final Inspection inspection, final Intersection meeting) {
    return new JUnitTestWriter(notNull("inspection", inspection), notNull("meeting", meeting)).text();
  }

  private String text() {
    final PixelRay pixel = inspection.pixel();
    final Ray ray = pixel.ray();
    final StringJoiner text = new StringJoiner(NEW_LINE, "", NEW_LINE);
    text.add("  /** Pixel (" + pixel.m() + ", " + pixel.n() + ") of " + pixel.W() + " x " + pixel.H() + ". */");
    text.add("  @org.junit.jupiter.api.Test");
    text.add("  void pixel" + pixel.m() + "And" + pixel.n() + "Meets"
        + meeting.object().getClass().getSimpleName() + "() {");
    text.add("    final models.Object3D object = " + object(meeting.whole()) + ";");
    text.add("    final tracer.Ray ray = new tracer.Ray(" + tuple("primitives.Point3D", ray.getStartingPoint()) + ",");
    text.add("        " + tuple("primitives.Vector3D", ray.getDirection()) + ");");
    text.add("    final tracer.Hit hit = object.intersectionWith(ray);");
    addAssertions(text, meeting.hit());
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
  }

  /** The expression that makes an object; of a group, the object within that was met. */
  private String object(final Object3D object) {
    if (object instanceof Group3D) {
      return object(meeting.object());
    }
    if (object instanceof TriangularMesh && meeting.hit().hits()) {
      return object(meeting.hit().getObject());
    }
    final List<Object> arguments = object.constructorArguments();
    final String name = object.getClass().getCanonicalName();
    if (arguments.isEmpty() || name == null || !Modifier.isPublic(object.getClass().getModifiers())) {
      final String simple = object.getClass().getSimpleName();
      return "org.junit.jupiter.api.Assertions.fail(\"make the " + simple + " here, or write "
          + simple + ".constructorArguments\")";
    }
    final StringJoiner list = new StringJoiner("," + NEW_LINE + "        ", "new " + name + "(", ")");
    for (final Object argument : arguments) {
      list.add(argument(argument));
    }
    return list.toString();
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
    return String.valueOf(argument);
  }

  private static String tuple(final String type, final Tuple3f tuple) {
    return "new " + type + "(" + number(tuple.x) + ", " + number(tuple.y) + ", " + number(tuple.z) + ")";
  }

  private static String number(final float number) {
    return number + "f";
  }
}
