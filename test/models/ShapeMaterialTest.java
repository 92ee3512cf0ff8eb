package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.awt.Color;
import java.lang.reflect.Constructor;
import java.util.List;
import java.util.stream.Stream;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import materials.Lambertian;
import materials.Material;
import primitives.Point3D;
import primitives.Vector3D;
import radiometry.ReflectanceRGB;
import tracer.Hit;
import tracer.Ray;

/** Every shape can be made of a material in place of a colour, and is the same shape then. */
class ShapeMaterialTest {

  private static final Material CLAY = new Lambertian(new ReflectanceRGB(0.8f, 0.4f, 0.2f));
  private static final Point3D O = new Point3D(0, 0, 0);
  private static final Vector3D V = new Vector3D(0, 0, 1);
  private static final Vector3D X = new Vector3D(1, 0, 0);
  private static final Point3D A = new Point3D(-2, -1, 0);
  private static final Point3D B = new Point3D(2, -1, 0);
  private static final Point3D C = new Point3D(0, 2, 0);

  static Stream<Object3D[]> shapes() {
    return Stream.of(
        new Object3D[] {new Sphere(O, 1, CLAY), new Sphere(O, 1, Color.RED)},
        new Object3D[] {new Plane(O, V, CLAY), new Plane(O, V, Color.RED)},
        new Object3D[] {new Triangle(A, B, C, CLAY), new Triangle(A, B, C, Color.RED)},
        new Object3D[] {new Cylinder(O, V, 1.5f, 3, CLAY), new Cylinder(O, V, 1.5f, 3, Color.RED)},
        new Object3D[] {new Capsule(O, V, 1.5f, 3, CLAY), new Capsule(O, V, 1.5f, 3, Color.RED)},
        new Object3D[] {new Box(O, X, V, 1.5f, 3, 5, CLAY), new Box(O, X, V, 1.5f, 3, 5, Color.RED)},
        new Object3D[] {new Torus(O, V, 1, 2, CLAY), new Torus(O, V, 1, 2, Color.RED)},
        new Object3D[] {new Ellipsoid(O, X, V, 1, 2, 3, CLAY), new Ellipsoid(O, X, V, 1, 2, 3, Color.RED)},
        new Object3D[] {new Egg(O, V, 1, 3, 2, CLAY), new Egg(O, V, 1, 3, 2, Color.RED)},
        new Object3D[] {new TruncatedCone(O, V, 1, 2, 3, CLAY), new TruncatedCone(O, V, 1, 2, 3, Color.RED)});
  }

  @ParameterizedTest
  @MethodSource("shapes")
  void theMaterialIsThere(final Object3D ofClay, final Object3D red) throws ReflectiveOperationException {
    assertSame(CLAY, ofClay.getMaterial());
    assertEquals(CLAY.getColor(), ofClay.getColor());
    assertNull(red.getMaterial());
    assertEquals(red.toString(), ofClay.toString());
    final Ray ray = new Ray(new Point3D(0.1f, 0.2f, 9), new Vector3D(0, 0, -1));
    final Hit hit = ofClay.intersectionWith(ray), expected = red.intersectionWith(ray);
    assertEquals(expected.getT(), hit.getT());
    assertEquals(expected.getNormal(), hit.getNormal());
    assertSame(ofClay, hit.getObject());
    assertEquals(CLAY.getColor(), ofClay.getColorAt(hit));
  }

  /** The arguments that a shape returns construct the same shape of the same material, or colour. */
  @ParameterizedTest
  @MethodSource("shapes")
  void theArgumentsMakeTheSameShapeAgain(final Object3D ofClay, final Object3D red) throws ReflectiveOperationException {
    for (final Object3D shape : new Object3D[] {ofClay, red}) {
      final List<Object> arguments = shape.constructorArguments();
      final Class<?> last = shape == ofClay ? Material.class : Color.class;
      assertSame(shape == ofClay ? CLAY : Color.RED, arguments.get(arguments.size() - 1));
      int made = 0;
      for (final Constructor<?> constructor : shape.getClass().getConstructors()) {
        if (constructor.getParameterTypes()[constructor.getParameterCount() - 1] == last) {
          final Object3D again = (Object3D) constructor.newInstance(arguments.toArray());
          assertSame(shape.getMaterial(), again.getMaterial());
          assertEquals(shape.getBoundingBox().toString(), again.getBoundingBox().toString());
          assertEquals(shape.toString(), again.toString());
          made++;
        }
      }
      assertEquals(1, made);
    }
  }
}
