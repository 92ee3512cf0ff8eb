package rendering;

import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;

import javax.vecmath.Vector3f;

import models.AffineTransformation;
import models.Group3D;
import models.Object3D;
import models.Sphere;
import org.junit.jupiter.api.Test;
import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;
import tracer.RayGenerator;
import upnatray.Image;
import view.Camera;
import view.Perspective;
import view.Projection;

/** What the author of an object reads when it fails during a rendering. */
class FailureLocatorTest {

  private static final class Broken extends Object3D {

    private final RuntimeException failure;

    Broken(final RuntimeException failure) {
      super(Color.RED);
      this.failure = failure;
    }

    /** Fails right of the middle and above it. */
    @Override
    public Hit intersectionWith(final Ray ray) {
      if (ray.directionX() > 0 && ray.directionY() > 0) {
        if (failure != null) {
          throw failure;
        }
        return null;
      }
      return Hit.NOHIT;
    }
  }

  private static IllegalStateException messageOf(final Object3D object) {
    final Camera camera = new Camera(new Point3D(0, 0, 5), new Point3D(), new Vector3D(0, 1, 0));
    camera.setProjection(new Perspective(60, 1));
    final Group3D scene = new Group3D(), inner = new Group3D();
    scene.addObject(new Sphere(new Point3D(), 1, Color.BLUE));
    inner.addObject(object);
    scene.addObject(inner);
    return assertThrows(IllegalStateException.class,
        () -> new Image(30, 20, Color.BLACK).synthesis(scene, camera, RenderSettings.STANDARD.withThreads(1)));
  }

  @Test
  void namesClassPixelAndRayOfAnException() {
    final RuntimeException failure = new ArithmeticException("by a student");
    final IllegalStateException reported = messageOf(new Broken(failure));
    assertSame(failure, reported.getCause());
    final String start = "rendering.FailureLocatorTest$Broken.intersectionWith failed at pixel (15, 10) "
        + "with Ray(R=(0.0, 0.0, 5.0), v=(";
    assertTrue(reported.getMessage().startsWith(start), reported.getMessage());
    assertTrue(reported.getMessage().contains("by a student"), reported.getMessage());
  }

  @Test
  void namesTheObjectWithinATransformation() {
    final Object3D broken = new Broken(new NullPointerException());
    final Object3D moved = new AffineTransformation(new Vector3f(2, 2, 2), new Vector3f(0, 0, 1), broken);
    final String message = messageOf(moved).getMessage();
    assertTrue(message.startsWith("rendering.FailureLocatorTest$Broken.intersectionWith"), message);
  }

  @Test
  void tellsOfAnAnswerOfNull() {
    assertTrue(messageOf(new Broken(null)).getMessage().contains("Broken.intersectionWith failed at pixel (15, 10)"),
        messageOf(new Broken(null)).getMessage());
  }

  /** The classic student's error. */
  private static final class Endless extends Object3D {

    Endless() {
      super(Color.RED);
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      return intersectionWith(ray);
    }
  }

  @Test
  void namesTheObjectThatCallsItselfWithoutEnd() {
    final IllegalStateException reported = messageOf(new Endless());
    assertTrue(reported.getMessage().startsWith("rendering.FailureLocatorTest$Endless.intersectionWith failed at pixel"),
        reported.getMessage());
    assertSame(StackOverflowError.class, reported.getCause().getClass());
  }

  @Test
  void tellsOfTooManyTransformationsWithinEachOther() {
    Object3D object = new Sphere(new Point3D(), 1, Color.RED);
    for (int i = 0; i < 4_000; i++) {
      final Group3D group = new Group3D();
      group.addObject(object);
      object = new AffineTransformation(new Vector3f(1, 1, 1), new Vector3f(), group);
    }
    final String message = messageOf(object).getMessage();
    assertTrue(message.startsWith("objects are nested in too many transformations"), message);
  }

  /** A sphere without a colour, and a box that calls itself. */
  private static final class Careless extends Object3D {

    private final boolean hasBox;

    Careless(final boolean hasBox) {
      super(Color.RED);
      this.hasBox = hasBox;
    }

    @Override
    public Color getColor() {
      return null;
    }

    @Override
    public BoundingBox getBoundingBox() {
      return hasBox ? BoundingBox.UNBOUNDED : getBoundingBox();
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      return new Hit(1, ray.pointAtParameter(1), new Vector3D(0, 0, 1), this);
    }
  }

  @Test
  void namesTheMethodThatFailed() {
    final String box = messageOf(new Careless(false)).getMessage();
    assertTrue(box.startsWith("rendering.FailureLocatorTest$Careless.getBoundingBox failed at pixel"), box);
    final String colour = messageOf(new Careless(true)).getMessage();
    assertTrue(colour.startsWith("rendering.FailureLocatorTest$Careless.getColor failed at pixel (0, 0)"), colour);
  }

  /** A projection whose rays end in the middle of the picture. */
  private static final class HalfDone extends Projection {

    HalfDone() {
      super(1, 1);
    }

    @Override
    public RayGenerator getRayGenerator(final Camera camera, final int W, final int H) {
      return new RayGenerator(camera, W, H) {
        @Override
        public Ray getRay(final int m, final int n) {
          if (n == 9 && m == 17) {
            throw new ArithmeticException("by a student");
          }
          return new Ray(camera.getPosition(), new Point3D(m, n, 0));
        }
      };
    }
  }

  @Test
  void namesTheGeneratorThatFailed() {
    final Camera camera = new Camera(new Point3D(0, 0, 5), new Point3D(), new Vector3D(0, 1, 0));
    camera.setProjection(new HalfDone());
    final String message = assertThrows(IllegalStateException.class,
        () -> new Image(30, 20, Color.BLACK).synthesis(new Group3D(), camera)).getMessage();
    assertTrue(message.matches("rendering\\.FailureLocatorTest\\$HalfDone\\$1\\.getRay failed at pixel \\(17, 9\\): "
        + ".*by a student"), message);
  }
}
