package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;

import javax.vecmath.TexCoord2f;
import javax.vecmath.Vector3f;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import materials.Lambertian;
import materials.Material;
import materials.Texture;
import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import radiometry.ReflectanceRGB;
import tracer.Hit;
import tracer.Ray;
import tracer.RayGenerator;
import trials.Trials;
import upnatray.Image;
import view.Angular;
import view.Camera;
import view.Orthographic;
import view.Perspective;
import view.Projection;

/**
 * Whatever numbers the public constructors and methods of the library are called with, from 1e-30 to 1e30, infinite or
 * NaN, they return or throw an IllegalArgumentException (or IllegalStateException, of an object that is not ready); no
 * call hangs, and no hit holds NaN.
 */
class ExtremeNumbersTest {

  private static final float[] NUMBERS = {0, -0f, 1, -1, 2.5f, 179, 1e-30f, -1e-30f, 1e30f, -1e30f, 1e-10f, 1e10f, 3e-45f,
    Float.MIN_NORMAL, Float.MAX_VALUE, -Float.MAX_VALUE, Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY};
  private static final int[] INTEGERS = {Integer.MIN_VALUE, -1, 0, 1, 2, 3, Integer.MAX_VALUE};
  private static final Duration LIMIT = Duration.ofSeconds(60);

  /** Calls that returned: a test in which all of them threw would show nothing. */
  private int results;

  @ParameterizedTest
  @ValueSource(classes = {Point3D.class, Vector3D.class, BoundingBox.class, Ray.class, Hit.class, Sphere.class, Plane.class,
    Triangle.class, TriangularMesh.class, Box.class, Cylinder.class, Capsule.class, Torus.class, Ellipsoid.class,
    Egg.class, TruncatedCone.class,
    AffineTransformation.class, Group3D.class, Camera.class, Perspective.class, Orthographic.class, Angular.class,
    Image.class})
  void everyCallIsAnsweredOrRefused(final Class<?> type) {
    assertTimeoutPreemptively(LIMIT, () -> Trials.of(400, random -> tryOut(type, random)));
    assertTrue(results > 250, () -> results + " results");
  }

  private void tryOut(final Class<?> type, final Random random) throws ReflectiveOperationException {
    final List<Executable> makers = new ArrayList<>(List.of(type.getConstructors()));
    for (final Method method : type.getMethods()) {
      if (Modifier.isStatic(method.getModifiers()) && method.getReturnType() == type && method.getDeclaringClass() == type) {
        makers.add(method);
      }
    }
    final Executable maker = makers.get(random.nextInt(makers.size()));
    final Object made = call(maker, null, random, random.nextInt(3));
    if (made == null) {
      return;
    }
    for (final Method method : type.getMethods()) {
      if (!Modifier.isStatic(method.getModifiers())
          && method.getDeclaringClass().getPackageName().equals(type.getPackageName())) {
        call(method, made, random, random.nextInt(3));
      }
    }
    if (made instanceof Object3D) {
      for (int i = 0; i < 10; i++) {
        check(((Object3D) made).intersectionWith(ray(random, random.nextInt(3))));
      }
    }
  }

  private Object call(final Executable called, final Object on, final Random random, final int wildness)
      throws ReflectiveOperationException {
    final Object[] values = new Object[called.getParameterCount()];
    for (int i = 0; i < values.length; i++) {
      final Class<?> type = called.getParameterTypes()[i];
      if (!canMake(type)) {
        return null;
      }
      final String generic = called.getGenericParameterTypes()[i].getTypeName();
      values[i] = type == Map.class ? map(generic, random, wildness) : value(type, random, wildness);
    }
    try {
      final Object result = called instanceof Method ? ((Method) called).invoke(on, values)
          : ((Constructor<?>) called).newInstance(values);
      results++;
      if (result instanceof Hit) {
        check((Hit) result);
      } else if (result instanceof RayGenerator) {
        check(((RayGenerator) result).getRay(0, 0));
      }
      return result;
    } catch (final InvocationTargetException thrown) {
      final Throwable cause = thrown.getCause();
      if (cause instanceof IllegalArgumentException || cause instanceof IllegalStateException) {
        return null;
      }
      throw new AssertionError(called + Arrays.deepToString(values) + " of " + on, cause);
    }
  }

  private static void check(final Hit hit) {
    if (hit.hits()) {
      assertTrue(hit.getT() > 0 && hit.getT() < Float.POSITIVE_INFINITY, () -> "t " + hit.getT());
      final Point3D P = hit.getPoint();
      final Vector3D n = hit.getNormal();
      assertEquals(1, n.length(), 1e-5, hit::toString);
      assertFalse(Float.isNaN(P.x) || Float.isNaN(P.y) || Float.isNaN(P.z), hit::toString);
    }
  }

  private static void check(final Ray ray) {
    if (ray != Ray.NORAY) {
      assertEquals(1, ray.getDirection().length(), 1e-5);
      assertFalse(Double.isNaN(ray.startX() + ray.startY() + ray.startZ()), ray::toString);
    }
  }

  private static boolean canMake(final Class<?> type) {
    return type.isPrimitive() || List.of(Point3D.class, Vector3D.class, Vector3f.class, Ray.class, Hit.class, Color.class,
        Material.class, Texture.class,
        Object3D.class, Map.class, List.class, float[].class, int[].class, BoundingBox.class, Camera.class, Projection.class,
        Group3D.class).contains(type);
  }

  private Object value(final Class<?> type, final Random random, final int wildness) {
    if (type == int.class) {
      return wildness == 2 ? INTEGERS[random.nextInt(INTEGERS.length)] : 1 + random.nextInt(4);
    }
    if (type == float.class) {
      return number(random, wildness);
    }
    if (type == boolean.class) {
      return random.nextBoolean();
    }
    if (type == double.class) {
      return (double) number(random, wildness);
    }
    if (wildness == 2 && random.nextInt(20) == 0) {
      return null;
    }
    if (type == Point3D.class) {
      return new Point3D(number(random, wildness), number(random, wildness), number(random, wildness));
    }
    if (type == Vector3D.class) {
      return new Vector3D(number(random, wildness), number(random, wildness), number(random, wildness));
    }
    if (type == Vector3f.class) {
      return new Vector3f(number(random, wildness), number(random, wildness), number(random, wildness));
    }
    return other(type, random, wildness);
  }

  /** A map of four points, vectors or texture coordinates, as its generic type says. */
  private Map<Integer, Object> map(final String generic, final Random random, final int wildness) {
    final Map<Integer, Object> map = new HashMap<>();
    for (int i = 1; i < 5; i++) {
      map.put(i, generic.contains("TexCoord2f") ? new TexCoord2f(number(random, wildness), number(random, wildness))
          : value(generic.contains("Vector3D") ? Vector3D.class : Point3D.class, random, wildness));
    }
    return map;
  }

  private Object other(final Class<?> type, final Random random, final int wildness) {
    if (type == Ray.class) {
      return ray(random, wildness);
    }
    if (type == Color.class) {
      return Color.RED;
    }
    if (type == Material.class) {
      return new Lambertian(new ReflectanceRGB(1, 0.5f, 0));
    }
    if (type == Texture.class) {
      return new Texture(new BufferedImage(3, 2, BufferedImage.TYPE_INT_ARGB));
    }
    if (type == List.class) {
      return List.of("1 2 3", "1 3 4");
    }
    if (type == float[].class) {
      final float[] coordinates = new float[12];
      for (int i = 0; i < coordinates.length; i++) {
        coordinates[i] = number(random, wildness);
      }
      return coordinates;
    }
    if (type == int[].class) {
      return new int[] {0, 1, 2, 0, 2, 3};
    }
    final Sphere ball = new Sphere(new Point3D(), 1, Color.RED);
    if (type == Hit.class) {
      return ball.intersectionWith(ray(random, 1));
    }
    if (type == BoundingBox.class) {
      return ball.getBoundingBox();
    }
    if (type == Projection.class) {
      return new Perspective(60, 1);
    }
    if (type == Camera.class) {
      final Camera camera = new Camera(new Point3D(0, 0, 5), new Point3D(), new Vector3D(0, 1, 0));
      camera.setProjection(new Perspective(60, 1));
      return camera;
    }
    final Group3D group = new Group3D();
    group.addObject(ball);
    return type == Group3D.class || random.nextBoolean() ? group : ball;
  }

  private static float number(final Random random, final int wildness) {
    return wildness == 2 ? NUMBERS[random.nextInt(NUMBERS.length)]
        : wildness == 1 ? (float) ((random.nextBoolean() ? 1 : -1) * Math.pow(10, 60 * random.nextDouble() - 30))
        : (float) (1 + 3 * random.nextDouble());
  }

  private static Ray ray(final Random random, final int wildness) {
    while (true) {
      try {
        final Point3D R = new Point3D(number(random, wildness), number(random, wildness), number(random, wildness));
        return random.nextBoolean() ? new Ray(R, new Point3D(number(random, 0), number(random, wildness), number(random, 1)))
            : new Ray(R, new Vector3D(number(random, 0) - 2, number(random, wildness), number(random, 1)));
      } catch (final IllegalArgumentException refused) {
        continue;
      }
    }
  }
}
