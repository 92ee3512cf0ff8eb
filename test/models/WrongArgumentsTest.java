package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Stream;

import javax.vecmath.Vector3f;

import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import materials.IdealDielectric;
import materials.Material;
import materials.Texture;
import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import radiometry.ReflectanceRGB;
import tracer.Hit;
import tracer.Ray;

/**
 * What a caller can get wrong causes an exception that names the argument and its value, in English and Spanish.
 */
class WrongArgumentsTest {

  private static final Point3D O = new Point3D(1, 2, 3);
  private static final Vector3D V = new Vector3D(0, 0, 1);
  private static final Vector3D X = new Vector3D(1, 0, 0);
  private static final Vector3f S = new Vector3f(1, 1, 1);
  private static final Color RED = Color.RED;
  private static final Sphere BALL = new Sphere(O, 1, RED);
  private static final Material GLASS = new IdealDielectric(new ReflectanceRGB(1, 1, 1), 1.5f, 1);
  private static final Texture TEXTURE = new Texture(new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB));
  private static final List<Float> NO_SIZES = List.of(0f, -0f, -1.5f, Float.NaN, Float.POSITIVE_INFINITY,
      Float.NEGATIVE_INFINITY);
  private static final List<Float> NO_NUMBERS = List.of(Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY);

  private final List<Arguments> cases = new ArrayList<>();

  static Stream<Arguments> cases() {
    final WrongArgumentsTest test = new WrongArgumentsTest();
    test.shapes();
    test.roundShapes();
    test.egg();
    test.truncatedCone();
    test.framedShapes();
    test.transformations();
    test.meshes();
    test.raysAndHits();
    test.others();
    return test.cases.stream();
  }

  private void wrong(final String name, final Object value, final Executable call) {
    cases.add(arguments(name, String.valueOf(value), call));
  }

  private void point(final String name, final Consumer<Point3D> call) {
    wrong(name, "null", () -> call.accept(null));
    for (final float no : NO_NUMBERS) {
      for (final Point3D P : new Point3D[] {new Point3D(no, 0, 0), new Point3D(0, no, 0), new Point3D(0, 0, no)}) {
        wrong(name, P, () -> call.accept(P));
      }
    }
  }

  private <T extends Vector3f> void vector(final String name, final Function<float[], T> make, final Consumer<T> call) {
    wrong(name, "null", () -> call.accept(null));
    for (final float no : NO_NUMBERS) {
      for (final float[] v : new float[][] {{no, 1, 1}, {1, no, 1}, {1, 1, no}}) {
        final T vector = make.apply(v);
        wrong(name, vector, () -> call.accept(vector));
      }
    }
  }

  private void direction(final String name, final Consumer<Vector3D> call) {
    vector(name, v -> new Vector3D(v[0], v[1], v[2]), call);
    wrong(name, "(0.0, 0.0, 0.0)", () -> call.accept(new Vector3D()));
    wrong(name, "(-0.0, 0.0, -0.0)", () -> call.accept(new Vector3D(-0f, 0, -0f)));
  }

  private void size(final String name, final Consumer<Float> call) {
    NO_SIZES.forEach(size -> wrong(name, size, () -> call.accept(size)));
  }

  private void shapes() {
    point("C", C -> new Sphere(C, 1, RED));
    size("r", r -> new Sphere(O, r, RED));
    wrong("color", "null", () -> new Sphere(O, 1, (Color) null));
    wrong("material", "null", () -> new Sphere(O, 1, (Material) null));
    point("C", C -> new Sphere(C, 1, GLASS));
    size("r", r -> new Sphere(O, r, GLASS));
    point("C", C -> new Sphere(C, 1, TEXTURE));
    size("r", r -> new Sphere(O, r, TEXTURE));
    wrong("texture", "null", () -> new Sphere(O, 1, (Texture) null));
    wrong("hit", "null", () -> new Sphere(O, 1, TEXTURE).getColorAt(null));
    wrong("hit", "null", () -> BALL.getColorAt(null));
    point("P", P -> new Plane(P, V, RED));
    direction("n", n -> new Plane(O, n, RED));
    wrong("color", "null", () -> new Plane(O, V, (Color) null));
    wrong("material", "null", () -> new Plane(O, V, (Material) null));
    final Point3D a = new Point3D(), b = new Point3D(1, 0, 0), c = new Point3D(0, 1, 0);
    point("A", A -> new Triangle(A, b, c, RED));
    point("B", B -> new Triangle(a, B, c, RED));
    point("C", C -> new Triangle(a, b, C, RED));
    wrong("color", "null", () -> new Triangle(a, b, c, (Color) null));
    wrong("material", "null", () -> new Triangle(a, b, c, (Material) null));
    wrong("A, B", "(3.0, 3.0, 3.0)", () -> new Triangle(O, new Point3D(3, 3, 3), new Point3D(5, 4, 3), RED));
    wrong("A, B", O, () -> new Triangle(O, new Point3D(O), c, RED));
    wrong("A, B", "(0.0, 0.0, 0.0)", () -> new Triangle(a, a, a, RED));
    wrong("A, B", "(0.3, 0.6, 0.9)", () -> new Triangle(new Point3D(0.1f, 0.2f, 0.3f), new Point3D(0.3f, 0.6f, 0.9f),
        new Point3D(0.7f, 1.4f, 2.1f), RED));
  }

  private void roundShapes() {
    point("P", P -> new Cylinder(P, V, 1, 1, RED));
    direction("u", u -> new Cylinder(O, u, 1, 1, RED));
    size("r", r -> new Cylinder(O, V, r, 1, RED));
    size("l", l -> new Cylinder(O, V, 1, l, RED));
    wrong("color", "null", () -> new Cylinder(O, V, 1, 1, (Color) null));
    wrong("material", "null", () -> new Cylinder(O, V, 1, 1, (Material) null));
    point("P", P -> new Capsule(P, V, 1, 1, RED));
    direction("u", u -> new Capsule(O, u, 1, 1, RED));
    size("r", r -> new Capsule(O, V, r, 1, RED));
    size("l", l -> new Capsule(O, V, 1, l, RED));
    wrong("color", "null", () -> new Capsule(O, V, 1, 1, (Color) null));
    wrong("material", "null", () -> new Capsule(O, V, 1, 1, (Material) null));
    point("C", C -> new Torus(C, V, 2, 1, RED));
    direction("axis", axis -> new Torus(O, axis, 2, 1, RED));
    size("R", R -> new Torus(O, V, R, 1, RED));
    size("r", r -> new Torus(O, V, 2, r, RED));
    wrong("color", "null", () -> new Torus(O, V, 2, 1, (Color) null));
    wrong("material", "null", () -> new Torus(O, V, 2, 1, (Material) null));
  }

  private void egg() {
    point("C", C -> new Egg(C, V, 1, 2, 1, RED));
    direction("axis", axis -> new Egg(O, axis, 1, 2, 1, RED));
    size("a", a -> new Egg(O, V, a, 2, 1, RED));
    size("b", b -> new Egg(O, V, 1, b, 1, RED));
    size("w", w -> new Egg(O, V, 1, 2, w, RED));
    wrong("b", "1.0", () -> new Egg(O, V, 1, 1, 1, RED));
    wrong("w = 1.5", "1.25", () -> new Egg(O, V, 1, 1.25f, 1.5f, RED));
    wrong("color", "null", () -> new Egg(O, V, 1, 2, 1, (Color) null));
    wrong("material", "null", () -> new Egg(O, V, 1, 2, 1, (Material) null));
  }

  private void truncatedCone() {
    point("P", P -> new TruncatedCone(P, V, 1, 2, 1, RED));
    direction("u", u -> new TruncatedCone(O, u, 1, 2, 1, RED));
    for (final float no : new float[] {-1.5f, -Float.MIN_VALUE, Float.NaN, Float.POSITIVE_INFINITY}) {
      wrong("rA", no, () -> new TruncatedCone(O, V, no, 2, 1, RED));
      wrong("rB", no, () -> new TruncatedCone(O, V, 1, no, 1, RED));
    }
    wrong("rA", "0.0", () -> new TruncatedCone(O, V, 0, 0, 1, RED));
    wrong("rB", "-0.0", () -> new TruncatedCone(O, V, 0, -0f, 1, RED));
    size("l", l -> new TruncatedCone(O, V, 1, 2, l, RED));
    wrong("color", "null", () -> new TruncatedCone(O, V, 1, 2, 1, (Color) null));
    wrong("material", "null", () -> new TruncatedCone(O, V, 1, 2, 1, (Material) null));
  }

  private void framedShapes() {
    point("C", C -> new Box(C, X, V, 1, 1, 1, RED));
    direction("i", i -> new Box(O, i, V, 1, 1, 1, RED));
    direction("aux", aux -> new Box(O, X, aux, 1, 1, 1, RED));
    size("w", w -> new Box(O, X, V, w, 1, 1, RED));
    size("h", h -> new Box(O, X, V, 1, h, 1, RED));
    size("d", d -> new Box(O, X, V, 1, 1, d, RED));
    wrong("color", "null", () -> new Box(O, X, V, 1, 1, 1, (Color) null));
    wrong("material", "null", () -> new Box(O, X, V, 1, 1, 1, (Material) null));
    point("C", C -> new Ellipsoid(C, X, V, 1, 1, 1, RED));
    direction("i", i -> new Ellipsoid(O, i, V, 1, 1, 1, RED));
    direction("aux", aux -> new Ellipsoid(O, X, aux, 1, 1, 1, RED));
    size("Rx", r -> new Ellipsoid(O, X, V, r, 1, 1, RED));
    size("Ry", r -> new Ellipsoid(O, X, V, 1, r, 1, RED));
    size("Rz", r -> new Ellipsoid(O, X, V, 1, 1, r, RED));
    wrong("color", "null", () -> new Ellipsoid(O, X, V, 1, 1, 1, (Color) null));
    wrong("material", "null", () -> new Ellipsoid(O, X, V, 1, 1, 1, (Material) null));
    for (final float k : new float[] {1, -3, 1e-10f, 0.7f}) {
      final Vector3D i = new Vector3D(0.1f, 0.7f, -0.3f), aux = new Vector3D(k * i.x, k * i.y, k * i.z);
      wrong("aux", aux, () -> new Box(O, i, aux, 1, 1, 1, RED));
      wrong("aux", aux, () -> new Ellipsoid(O, i, aux, 1, 1, 1, RED));
    }
  }

  private void factors(final Consumer<Vector3f> call) {
    vector("s", Vector3f::new, call);
    for (final Vector3f s : new Vector3f[] {new Vector3f(0, 1, 1), new Vector3f(1, -0f, 1), new Vector3f(1, 1, 0),
        new Vector3f()}) {
      wrong("s", s, () -> call.accept(s));
    }
  }

  private void axis(final Consumer<Vector3f> call) {
    vector("axis", Vector3f::new, call);
    wrong("axis", new Vector3f(), () -> call.accept(new Vector3f()));
  }

  private void transformations() {
    factors(s -> new AffineTransformation(s, V, 1, S, BALL));
    factors(s -> new AffineTransformation(s, V, 1, BALL));
    factors(s -> new AffineTransformation(s, S, BALL));
    factors(s -> new AffineTransformation(s, BALL));
    axis(u -> new AffineTransformation(S, u, 1, S, BALL));
    axis(u -> new AffineTransformation(S, u, 1, BALL));
    axis(u -> new AffineTransformation(u, 1, S, BALL));
    axis(u -> new AffineTransformation(u, 1, BALL));
    vector("d", Vector3f::new, d -> new AffineTransformation(S, V, 1, d, BALL));
    vector("d", Vector3f::new, d -> new AffineTransformation(V, 1, d, BALL));
    vector("d", Vector3f::new, d -> new AffineTransformation(S, d, BALL));
    for (final float theta : NO_NUMBERS) {
      wrong("theta", theta, () -> new AffineTransformation(S, V, theta, S, BALL));
      wrong("theta", theta, () -> new AffineTransformation(S, V, theta, BALL));
      wrong("theta", theta, () -> new AffineTransformation(V, theta, S, BALL));
      wrong("theta", theta, () -> new AffineTransformation(V, theta, BALL));
    }
    wrong("object", "null", () -> new AffineTransformation(S, V, 1, S, null));
    wrong("object", "null", () -> new AffineTransformation(S, V, 1, null));
    wrong("object", "null", () -> new AffineTransformation(V, 1, S, null));
    wrong("object", "null", () -> new AffineTransformation(S, S, null));
    wrong("object", "null", () -> new AffineTransformation(V, 1, null));
    wrong("object", "null", () -> new AffineTransformation(S, null));
    wrong("obj", "null", () -> new Group3D().addObject(null));
  }

  private static Map<Integer, Point3D> vertices() {
    return new HashMap<>(Map.of(1, new Point3D(), 2, new Point3D(1, 0, 0), 3, new Point3D(0, 1, 0), 4,
        new Point3D(2, 0, 0)));
  }

  private void meshes() {
    wrong("vertices", "null", () -> new TriangularMesh(null, List.of("1 2 3")));
    wrong("facetas", "null", () -> new TriangularMesh(vertices(), null));
    wrong("color", "null", () -> new TriangularMesh(vertices(), List.of("1 2 3"), (Color) null));
    wrong("facet 1", "null", () -> new TriangularMesh(vertices(), Arrays.asList("1 2 3", null)));
    for (final String facet : List.of("", "1 2", "1 2 3 4", "a b c", "1 2 3x", "1.5 2 3", "1;2;3", "/1 2 3",
        "99999999999 1 2")) {
      wrong("facet 1", facet, () -> new TriangularMesh(vertices(), List.of("1 2 3", facet), RED));
    }
    wrong("facet 0", "7", () -> new TriangularMesh(vertices(), List.of("1 7/2 3")));
    wrong("facet 0", "-1", () -> new TriangularMesh(vertices(), List.of("1 -1 3")));
    wrong("facetas", "1", () -> new TriangularMesh(vertices(), List.of("1 2 4")));
    wrong("facetas", "0", () -> new TriangularMesh(vertices(), List.of()));
    wrong("facetas", "0", () -> new TriangularMesh(Map.of(), List.of()));
    wrong("corners", "0", () -> TriangularMesh.of(new float[0], new int[0], RED));
    for (final Point3D P : new Point3D[] {null, new Point3D(0, Float.NaN, 0), new Point3D(Float.NEGATIVE_INFINITY, 0, 0)}) {
      final Map<Integer, Point3D> vertices = vertices();
      vertices.put(9, P);
      wrong("vertex 9", P, () -> new TriangularMesh(vertices, List.of("1 2 3")));
    }
    final Map<Integer, Point3D> nameless = vertices();
    nameless.put(null, O);
    wrong("vertex index", "null", () -> new TriangularMesh(nameless, List.of("1 2 3")));
    final float[] three = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    wrong("coordinates", "null", () -> TriangularMesh.of(null, new int[] {0, 1, 2}, RED));
    wrong("corners", "null", () -> TriangularMesh.of(three, null, RED));
    wrong("coordinates", "8", () -> TriangularMesh.of(Arrays.copyOf(three, 8), new int[] {0, 1, 2}, RED));
    wrong("corners", "4", () -> TriangularMesh.of(three, new int[] {0, 1, 2, 0}, RED));
    wrong("corners[1]", "3", () -> TriangularMesh.of(three, new int[] {0, 3, 2}, RED));
    wrong("corners[2]", "-1", () -> TriangularMesh.of(three, new int[] {0, 1, -1}, RED));
    wrong("coordinates[4]", "NaN", () -> TriangularMesh.of(new float[] {0, 0, 0, 1, Float.NaN, 0, 0, 1, 0},
        new int[] {0, 1, 2}, RED));
  }

  private void raysAndHits() {
    point("R", R -> new Ray(R, V));
    direction("v", v -> new Ray(O, v));
    point("R", R -> new Ray(R, O));
    point("Q", Q -> new Ray(O, Q));
    wrong("Q", O, () -> new Ray(O, new Point3D(O)));
    wrong("Q", "(0.0, -0.0, 0.0)", () -> new Ray(new Point3D(), new Point3D(0, -0f, 0)));
    NO_NUMBERS.forEach(t -> wrong("t", t, () -> new Ray(O, V).pointAtParameter(t)));
    NO_NUMBERS.forEach(t -> wrong("t", t, () -> Ray.NORAY.pointAtParameter(t)));
    size("t", t -> new Hit(t, O, V, BALL));
    point("P", P -> new Hit(1, P, V, BALL));
    direction("n", n -> new Hit(1, O, n, BALL));
    wrong("object", "null", () -> new Hit(1, O, V, null));
    wrong("hit", "null", () -> Hit.NOHIT.isCloser(null));
  }

  private void others() {
    wrong("P", "null", () -> new Point3D((Point3D) null));
    wrong("v", "null", () -> new Vector3D((Vector3D) null));
    wrong("min", "null", () -> new BoundingBox(null, O));
    wrong("max", "null", () -> new BoundingBox(O, null));
    wrong("min", "(1.0, 2.0, 3.0)", () -> new BoundingBox(O, new Point3D(1, 2, 2)));
    wrong("max", "(1.0, NaN, 9.0)", () -> new BoundingBox(O, new Point3D(1, Float.NaN, 9)));
    wrong("min", "(NaN, 0.0, 0.0)", () -> new BoundingBox(new Point3D(Float.NaN, 0, 0), O));
    wrong("box", "null", () -> BoundingBox.EMPTY.union(null));
    wrong("P", "null", () -> BoundingBox.EMPTY.contains(null));
  }

  @ParameterizedTest(name = "{0} = {1}")
  @MethodSource("cases")
  void isNamedInEnglishAndInSpanish(final String name, final String value, final Executable call) {
    final Locale before = Locale.getDefault();
    try {
      Locale.setDefault(Locale.US);
      final String english = messageOf(call, name, value);
      assertTrue(english.contains(" must ") || english.contains(" names "), english);
      Locale.setDefault(new Locale("es", "ES"));
      final String spanish = messageOf(call, name, value);
      assertTrue(spanish.contains(" debe") || spanish.contains("faceta"), spanish);
      Locale.setDefault(Locale.JAPAN);
      assertEquals(english, messageOf(call, name, value));
    } finally {
      Locale.setDefault(before);
    }
  }

  private static String messageOf(final Executable call, final String name, final String value) {
    final String message = assertThrows(IllegalArgumentException.class, call).getMessage();
    final String first = message.replace("la faceta", "facet").replace("A, B y C", "A, B and C");
    assertTrue(first.contains(name), () -> name + " is not named: " + message);
    assertTrue(message.contains(value), () -> value + " is missing: " + message);
    return message;
  }
}
